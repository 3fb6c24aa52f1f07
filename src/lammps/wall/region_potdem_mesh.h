/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A region that is bounded by triangles from an STL file (core/geometry/triangle_mesh.h), for everything that takes a
   region: walls, particles on a lattice in it, groups. Where the triangles do not enclose a volume they are a sheet with
   two sides: an open face in LAMMPS's terms. */

#ifndef LMP_REGION_POTDEM_MESH_H
#define LMP_REGION_POTDEM_MESH_H

#include "core/geometry/triangle_mesh.h"

#include "region.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class RegPotdemMesh : public Region {
 public:
  RegPotdemMesh(class LAMMPS *, int, char **);
  ~RegPotdemMesh() override;
  int inside(double, double, double) override;
  int surface_interior(double *, double) override;
  int surface_exterior(double *, double) override;
  bool is_beside(int triangle, int other) const { return mesh->is_beside(triangle, other); }

 private:
  std::unique_ptr<POTDEM::TriangleMesh> mesh;
  std::vector<POTDEM::TriangleMesh::Contact> found;

  std::vector<POTDEM::Vector3> read(const std::string &file) const;
  void set_extent();
  void report(const std::string &file) const;
  int surface(double *, double, bool from_inside);
};

}    // namespace LAMMPS_NS

#endif
