/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The surface of a region as a wall: where a sphere may touch it, and how fast it moves there.

   Places and nearest points come from LAMMPS's regions. What is done here is what they lack (as of 4Feb2025): unions and
   intersections whose parts meet flush, or turn; velocities of parts, at the set-up of a run, and about an axis that is
   no unit vector; open faces met exactly at their edge; the reach of ellipsoids. */

#ifndef LMP_POTDEM_WALL_SURFACE_H
#define LMP_POTDEM_WALL_SURFACE_H

#include "pointers.h"
#include "region.h"

#include <array>
#include <cstdint>
#include <vector>

namespace LAMMPS_NS {

class PotdemWallSurface : protected Pointers {
 public:
  // a place where a sphere may touch
  struct Face {
    int part;
    double foot[3];    // on the surface
    double n[3];       // from there to a centre that is free
    double r;          // distance
    bool grows;        // its velocity is that of a change of shape, too
    int key;           // the same for the same face as long as the region is the same, > 0
  };

  PotdemWallSurface(LAMMPS *);
  void init(Region *);
  void follow();    // before the wall is used in a step
  // where it was a step before, from which its velocities come; for restart files. Nothing where it does not move
  std::vector<double> way() const;
  void go_on(const std::vector<double>
                 &way);    // of this region, or of another one: then it counts as at rest
  bool is_free(const double *x) const    // may a centre be there?
  {
    return region->reglist ? is_free_of_parts(x) : region->match(x[0], x[1], x[2]) != 0;
  }
  // lists of what is near it: not where it changes its shape
  bool can_be_listed() const;
  void begin_list();
  double moved() const;    // no further since then, anywhere in the box
  bool is_near(const double *x, double reach) const;    // may a part be as near?

  // of the faces of one that stands still and has only flat ones: a bit for each
  typedef std::uint64_t Planes;
  bool is_flat() const;
  // those within reach of a centre; false: not known
  bool find_planes(const double *x, double reach, Planes &);
  // as faces(), but any number of threads at once; false: the centre is behind one of these
  bool faces_of(Planes, const double *x, double reach, std::vector<Face> &) const;

  // free: may the centre be there? An empty list if not
  const std::vector<Face> &faces(const double *x, double reach, bool &free)
  {
    found.clear();
    if (region->reglist) {
      free = is_free_of_parts(x);
      if (free) collect_all(x, reach);
      return found;
    }
    const int n = region->surface(x[0], x[1], x[2], parts[0].search * reach);
    if (n) add_faces(0, n, x, reach, found);
    free = n > 0 || is_free(x);    // LAMMPS finds contacts for free centres only
    return found;
  }
  // of a centre that is not free, within a depth: the nearest one, its distance negative; none where the region has parts
  const std::vector<Face> &face_before(const double *x, double depth);
  // of the place that is at the foot now, at a time from now
  void velocity(const Face &, double *u, double when = 0.0) const;
  void spin(const Face &, double *w) const;    // angular velocity
  // of the faces with these keys: are they triangles, and the second a part of the first's surface or around an edge of less than 30 degrees?
  bool is_beside(int key, int other) const;

 private:
  struct Part {
    Region *region;
    const class RegPotdemMesh *mesh;    // null: a region of another kind
    double search;                      // how far LAMMPS is to look for contacts, over the reach
    double angle;                       // of a rotation, at the latest step
    double axis_scale;                  // 1 over the length of its axis
    double listed[4];                   // displacement and angle when a list was begun
    std::array<double, 5> before;       // what LAMMPS keeps of the step before the latest
  };

  struct Plane {
    double n[3], offset;
    bool known;
  };

  // a region in a union or intersection, the number of its first part, and its faces begin to end
  struct Sibling {
    Region *region;
    int part;
    std::size_t begin, end;
  };

  Region *region;
  std::vector<Part> parts;
  std::vector<Face> found;
  std::vector<Plane> planes;
  bigint step;    // of the latest call of follow
  bool moving;    // and there are two steps to take a difference of

  bool is_dynamic() const;

  bool is_free_of_parts(const double *x) const;
  bool learn(const Region::Contact &, const double *x, double reach);
  void collect_all(const double *x, double reach);
  void collect(Region *, int &part, const double *x, double reach, std::vector<Face> &) const;
  void add_faces(int part, int n, const double *x, double reach, std::vector<Face> &) const;
  void prune(const std::vector<Sibling> &, bool intersection, double lift,
             std::vector<Face> &) const;
  bool hides(const Sibling &, const Sibling &owner, const std::vector<Face> &, std::size_t face,
             bool intersection, double lift) const;
  bool is_flush(const Sibling &, const Sibling &owner, const Face &, const Face &nearer,
                double lift) const;
};

}    // namespace LAMMPS_NS

#endif
