/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_lattice_area.h"

#include "core/areas/lattice_area.h"
#include "core/laws/truss.h"
#include "lammps/glue/fix_potdem_bond_history.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"

#include <algorithm>
#include <vector>

using namespace LAMMPS_NS;

// lattice distances are recognised within this fraction
static constexpr double SHELL_TOLERANCE = 1e-3;

/* ---------------------------------------------------------------------- */

PotdemLatticeArea::PotdemLatticeArea(LAMMPS *lmp, FixPotdemBondHistory *history,
                                     const std::string &style) :
    Pointers(lmp),
    history(history), style(style)
{
}

void PotdemLatticeArea::solve(int type)
{
  struct {
    int count, rank;
  } mine = {0, comm->me}, most;
  const int chosen = fullest(type, mine.count);
  MPI_Allreduce(&mine, &most, 1, MPI_2INT, MPI_MAXLOC, world);
  if (most.count == 0) return;

  Found found{};
  if (comm->me == most.rank) found = read(type, chosen);
  MPI_Bcast(&found, sizeof(found), MPI_BYTE, most.rank, world);
  const double section = found.section > 0.0 ? found.section : section_of_type(type);
  if (section <= 0.0)
    error->all(
        FLERR,
        "{}: area lattice for bond type {} needs a cubic, bcc, fcc or hcp "
        "lattice with enough bonds to be stiff; the particle with most bonds has {} and {} nearest "
        "neighbours: use area body or area factor",
        style, type, most.count, found.nearest);
  const bigint count = give_section(type, section);
  if (comm->me == 0) report(type, found, section, count);
}

void PotdemLatticeArea::report(int type, const Found &found, double section, bigint count) const
{
  if (found.section > 0.0)
    utils::logmesg(lmp,
                   "{}: bond type {}: lattice with {} nearest neighbours and {} bonds "
                   "per particle, section {:.8g}\n",
                   style, type, found.nearest, found.bonds, section);
  else
    utils::logmesg(lmp,
                   "{}: bond type {}: {} new bonds make no lattice of their own and get "
                   "the section {:.8g} of this type\n",
                   style, type, count, section);
}

/* ---------------------------------------------------------------------- */

bool PotdemLatticeArea::lacks_section(int type, int i, int m) const
{
  return atom->bond_type[i][m] == type && history->area(i, m) >= 0.0;
}

// owned atom that has most bonds, and how many
int PotdemLatticeArea::fullest(int type, int &most) const
{
  int chosen = -1;
  for (int i = 0; i < atom->nlocal; i++) {
    const int *types = atom->bond_type[i], n = atom->num_bond[i];
    const int count = std::count(types, types + n, type);
    bool incomplete = false;
    for (int m = 0; m < n; m++) incomplete = incomplete || lacks_section(type, i, m);
    if (incomplete && count > most) {
      most = count;
      chosen = i;
    }
  }
  return chosen;
}

PotdemLatticeArea::Found PotdemLatticeArea::read(int type, int i) const
{
  std::vector<double> lengths;
  for (int m = 0; m < atom->num_bond[i]; m++)
    if (atom->bond_type[i][m] == type) lengths.push_back(history->length(i, m));
  std::sort(lengths.begin(), lengths.end());
  const double spacing = lengths.front();
  const int nearest = std::count_if(lengths.begin(), lengths.end(), [spacing](double length) {
    return length < spacing * (1.0 + SHELL_TOLERANCE);
  });
  Found found{0.0, static_cast<double>(nearest), 0.0};
  const auto lattice = POTDEM::lattice_of(nearest, nearest != 12 || centred(type, i, spacing));
  if (lattice == POTDEM::Lattice::NONE) return found;
  for (const double length : lengths)
    if (!POTDEM::is_shell(lattice, length / spacing, SHELL_TOLERANCE)) return found;
  const auto answer = POTDEM::lattice_area(lattice, lengths.back() / spacing);
  found.bonds = answer.bonds;
  found.section = answer.area_factor * POTDEM::truss_section(spacing);
  return found;
}

// fcc, unlike hcp, has every nearest neighbour face another one
bool PotdemLatticeArea::centred(int type, int i, double spacing) const
{
  double sum[3] = {0.0, 0.0, 0.0};
  int opposite = 0;
  std::vector<const double *> near;
  for (int m = 0; m < atom->num_bond[i]; m++)
    if (atom->bond_type[i][m] == type && history->length(i, m) < spacing * (1.0 + SHELL_TOLERANCE))
      near.push_back(atom->x[domain->closest_image(i, atom->map(atom->bond_atom[i][m]))]);
  for (const double *a : near)
    for (const double *b : near) {
      for (int k = 0; k < 3; k++) sum[k] = a[k] + b[k] - 2.0 * atom->x[i][k];
      if (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] < 0.01 * spacing * spacing)
        opposite++;
    }
  return opposite == static_cast<int>(near.size());
}

// that the bonds of this type have already; 0: none has
double PotdemLatticeArea::section_of_type(int type) const
{
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      if (atom->bond_type[i][m] == type) mine = MAX(mine, -history->area(i, m));
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}

// to the bonds that have none; how many there are
bigint PotdemLatticeArea::give_section(int type, double section)
{
  bigint ends = 0, all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      if (lacks_section(type, i, m)) {
        history->store_area(i, m, -section);
        ends++;
      }
  MPI_Allreduce(&ends, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all / 2;
}
