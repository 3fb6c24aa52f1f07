/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The cells of a body's particles: Voronoi cells bounded by the planes between bonded neighbours, radical planes if the
   diameters differ. They are measured by rays from the centres. */

#ifndef POTDEM_AREAS_CELLS_H
#define POTDEM_AREAS_CELLS_H

#include "bonded_body.h"

namespace POTDEM {

// n > 0 unit vectors spread evenly over the sphere along a spiral
std::vector<Vector3> spiral_directions(int n);

class Cell {
 public:
  // how far a ray from the particle along a unit vector stays in its cell (HUGE_VAL: no end); stops below `enough`
  double reach(const Vector3 &direction, double enough = 0.0) const;
  // of a closed cell; the error is about that of a sum over so many evenly spread directions
  double volume(const std::vector<Vector3> &rays) const;

 private:
  friend class Cells;
  struct Side {
    Vector3 normal;    // outwards, over the distance
    double most;       // one over the least distance of this and all later sides
  };
  std::vector<Side> sides;
};

class Cells {
 public:
  explicit Cells(const BondedBody &);    // collective: a mean over ranks

  // diameter in units of length
  double diameter(int i) const { return scale * body.diameter[i]; }
  Cell of(int i) const;    // owned particle
  double reach(int i, const Vector3 &direction) const { return of(i).reach(direction); }
  double volume(int i, const std::vector<Vector3> &rays) const { return of(i).volume(rays); }

 private:
  const BondedBody &body;
  double scale, largest_diameter;

  double diameter_scale() const;
};

// (4 pi / 3) mean r^3 of a body with the radius r(ray) about its centre
template <class Radius> double volume_by_rays(const std::vector<Vector3> &rays, Radius radius)
{
  double cubes = 0.0;
  for (const auto &ray : rays) {
    const double r = radius(ray);
    cubes += r * r * r;
  }
  return 4.0 * M_PI / 3.0 * cubes / rays.size();
}

}    // namespace POTDEM

#endif
