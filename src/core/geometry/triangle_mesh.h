/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A surface of triangles, as CAD programs write it (STL), and where a sphere touches it.

   A sphere touches each triangle at the place that is nearest to its centre. Counted one by one these would make the
   surface the stiffer, the finer it is, and kick a sphere that rolls over an edge. Therefore the nearest place counts, and a
   further one only
   - if it is nearest of all places around it: on an edge or a corner, if no triangle there goes on to a nearer one;
   - if it rises above the plane through each nearer place that counts, across the line to the centre: as the other side of a
     groove does, and what lies beyond a ridge does not; and
   - if its direction is more than 30 degrees from that of each nearer one that counts: less is a curved surface.
   The energy of a contact is a function of its distance; the distance to a surface is a continuous function of the place,
   and so is that to each side of a groove. A side of a groove of less than 30 degrees begins to count at its edge where an
   overlap of 13 % (1 - cos 30 degrees) of the radius is exceeded.

   A surface is closed if each edge joins two triangles that run through it in opposite directions. It has an inside then;
   a place is inside if it is behind the surface's nearest place. There the normal is that of the face, the sum of the two
   of an edge, or the sum over a corner's triangles by their angles: J. A. Baerentzen and H. Aanaes, IEEE Trans. Vis.
   Comput. Graph. 11 (2005) 243. */

#ifndef POTDEM_TRIANGLE_MESH_H
#define POTDEM_TRIANGLE_MESH_H

#include "core/geometry/triangle_tree.h"

#include <vector>

namespace POTDEM {

class TriangleMesh {
 public:
  struct Contact {
    Vector3 place;
    double r;    // distance
    int triangle, on, which;
  };

  // three corners for each triangle; those without an area are left out. If closed, they are made to run such that normals
  // point outwards
  explicit TriangleMesh(const std::vector<Vector3> &corners);

  int size() const { return static_cast<int>(triangles.size()); }
  int left_out() const { return flat; }
  bool is_closed() const { return open == 0; }
  int open_edges() const { return open; }    // of triangles, that do not join two of them well
  const Box &box() const { return bounds; }
  double volume() const;    // if closed

  // where a sphere around x may touch, the nearest first, each a contact of its own
  void contacts(const Vector3 &x, double reach, std::vector<Contact> &) const;
  // if closed; a place on the surface is inside
  bool is_inside(const Vector3 &x) const;
  bool is_behind(const Vector3 &x, const Contact &nearest) const;
  // is the angle between two triangles, in their directions, less than that of two surfaces? any numbers, as from a file
  bool is_beside(int triangle, int other) const;

 private:
  typedef std::array<int, 3> Triangle;
  std::vector<Vector3> points;
  std::vector<Triangle> triangles, neighbours;    // points; over edge k, -1: none
  std::vector<Vector3> at_points;                 // normals, if closed
  TriangleTree tree;
  Box bounds;
  int flat, open;

  void share_points(const std::vector<Vector3> &corners);
  void join_edges();
  void turn_outwards();
  void find_normals();
  void fill_tree();
  Vector3 normal(int triangle) const;    // of length one
  NearestPlace nearest_place_of(int triangle, const Vector3 &x) const;
  Vector3 normal_at(const Contact &) const;
  bool goes_nearer(const Contact &, const Contact &other) const;
};

}    // namespace POTDEM

#endif
