/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/wall/region_potdem_mesh.h"

#include "lammps/glue/potdem_input.h"
#include "lammps/wall/potdem_stl.h"

#include "comm.h"
#include "domain.h"
#include "error.h"

#include <algorithm>
#include <exception>

using namespace LAMMPS_NS;
using POTDEM::Vector3;

// places where a sphere touches at once, each more than 30 degrees from the next; the nearest ones count
static constexpr int MOST_CONTACTS = 12;

/* ----------------------------------------------------------------------
   region ID potdem/mesh FILE [scale S] [LAMMPS's keywords of regions]
------------------------------------------------------------------------- */

RegPotdemMesh::RegPotdemMesh(LAMMPS *lmp, int narg, char **arg) : Region(lmp, narg, arg)
{
  PotdemInput input(lmp, std::string("region ") + id + " potdem/mesh", narg - 2, arg + 2);
  const std::string file = input.word();
  const bool scaled = input.next_is("scale");
  const double scale = scaled ? input.in_range("scale", POTDEM::positive()) : 1.0;
  const int read_already = scaled ? 5 : 3;
  options(narg - read_already, arg + read_already);

  auto corners = read(file);
  for (auto &corner : corners) {
    corner[0] *= scale * xscale;
    corner[1] *= scale * yscale;
    corner[2] *= scale * zscale;
  }
  mesh = std::make_unique<POTDEM::TriangleMesh>(corners);
  if (mesh->size() == 0)
    error->all(FLERR, "Region {}: all triangles of {} have an area of zero", id, file);
  cmax = tmax = MOST_CONTACTS;
  contact = new Contact[cmax];
  if (!mesh->is_closed()) openflag = 1;
  set_extent();
  if (comm->me == 0) report(file);
}

RegPotdemMesh::~RegPotdemMesh()
{
  if (copymode) return;
  delete[] contact;
}

// on one rank, for all
std::vector<Vector3> RegPotdemMesh::read(const std::string &file) const
{
  std::vector<Vector3> corners;
  bigint count = 0;
  if (comm->me == 0) {
    try {
      corners = potdem_read_stl(file);
    } catch (const std::exception &problem) {
      error->one(FLERR, "Region {}: STL file {}: {}", id, file, problem.what());
    }
    count = static_cast<bigint>(corners.size());
  }
  MPI_Bcast(&count, 1, MPI_LMP_BIGINT, 0, world);
  if (3 * count > MAXSMALLINT)
    error->all(FLERR, "Region {}: STL file {} has more triangles than can be sent at once", id,
               file);
  corners.resize(count);
  MPI_Bcast(corners.data(), static_cast<int>(3 * count), MPI_DOUBLE, 0, world);
  return corners;
}

void RegPotdemMesh::set_extent()
{
  bboxflag = interior && mesh->is_closed();
  const auto &box = mesh->box();
  extent_xlo = box.lo[0];
  extent_xhi = box.hi[0];
  extent_ylo = box.lo[1];
  extent_yhi = box.hi[1];
  extent_zlo = box.lo[2];
  extent_zhi = box.hi[2];
}

void RegPotdemMesh::report(const std::string &file) const
{
  const auto &box = mesh->box();
  std::string text = fmt::format("Region {}: {} triangles from {}", id, mesh->size(), file);
  if (mesh->left_out() > 0)
    text += fmt::format(", without {} that have an area of zero", mesh->left_out());
  text += fmt::format(", from ({:.6g} {:.6g} {:.6g}) to ({:.6g} {:.6g} {:.6g})", box.lo[0],
                      box.lo[1], box.lo[2], box.hi[0], box.hi[1], box.hi[2]);
  text += mesh->is_closed()
      ? fmt::format(", volume {:.8g}\n", mesh->volume())
      : fmt::format(
            ", a sheet with two sides, for walls only: {} edges do not join two triangles\n",
            mesh->open_edges());
  utils::logmesg(lmp, text);
}

/* ---------------------------------------------------------------------- */

// LAMMPS does not ask this of a region with open faces: to it all is inside
int RegPotdemMesh::inside(double x, double y, double z)
{
  return openflag || mesh->is_inside({x, y, z});
}

int RegPotdemMesh::surface_interior(double *x, double cutoff)
{
  return surface(x, cutoff, true);
}

// a sheet is asked for both at once
int RegPotdemMesh::surface_exterior(double *x, double cutoff)
{
  return openflag ? 0 : surface(x, cutoff, false);
}

int RegPotdemMesh::surface(double *x, double cutoff, bool from_inside)
{
  const Vector3 centre = {x[0], x[1], x[2]};
  mesh->contacts(centre, cutoff, found);
  if (found.empty()) return 0;
  if (!openflag && mesh->is_behind(centre, found[0]) != from_inside) return 0;
  const int n = std::min(cmax, static_cast<int>(found.size()));
  for (int k = 0; k < n; k++) {
    add_contact(k, x, found[k].place[0], found[k].place[1], found[k].place[2]);
    contact[k].iwall = found[k].triangle;
    contact[k].varflag = 0;
  }
  return n;
}
