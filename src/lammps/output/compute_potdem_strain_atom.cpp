/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Strain at a particle (thesis eq. 5.24): least squares over its live bonds of
     eps_ij = n0^T E n0,    eps_ij = ((r/re)^2 - 1)/2,    n0 the bond's direction in the reference state
   E is the Green-Lagrange tensor: exact for any affine motion, rotation included. With fewer than six
   independent directions the solution of smallest norm is taken; the number of bonds and the rank are
   columns. */

#include "lammps/output/compute_potdem_strain_atom.h"

#include "core/laws/four.h"
#include "core/laws/truss.h"
#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_width.h"
#include "lammps/output/fix_potdem_reference.h"

#include "atom.h"
#include "error.h"
#include "math_eigen_impl.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

static constexpr int COLUMNS = 8;    // exx eyy ezz exy exz eyz nbonds rank
static constexpr double SINGULAR =
    1e-10;    // eigenvalues below this fraction of the largest count as zero
static constexpr double REGULAR = 1e-6;    // well above: nobody need know them
static constexpr int NONE = -1;
static constexpr double MOVED =
    1e-6;    // reference positions and reference lengths agree to this fraction

/* ---------------------------------------------------------------------- */

ComputePotdemStrainAtom::ComputePotdemStrainAtom(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), nmax(0), strain(nullptr), history(nullptr), generation(NONE)
{
  if (narg > 3)
    error->all(FLERR, "compute potdem/strain/atom: unknown keyword '{}', it takes none", arg[3]);
  peratom_flag = 1;
  size_peratom_cols = COLUMNS;
  if (atom->nbonds == 0)
    error->all(FLERR, "compute potdem/strain/atom {} needs bonds: define it after potdem_bonds",
               id);
  history = FixPotdemBondHistory::ensure(lmp);
  keep_reference();
}

ComputePotdemStrainAtom::~ComputePotdemStrainAtom()
{
  if (modify->get_fix_by_id(fix_id)) modify->delete_fix(fix_id);
  memory->destroy(strain);
}

/* ----------------------------------------------------------------------
   the directions of the bonds in the reference state: positions when the compute is defined, or when a particle
   comes later
------------------------------------------------------------------------- */

void ComputePotdemStrainAtom::keep_reference()
{
  fix_id = std::string(id) + "_REFERENCE";
  auto *const fix = dynamic_cast<FixPotdemReference *>(
      modify->add_fix(fmt::format("{} all POTDEM_REFERENCE d2_potdem_{} {} ghost yes writedata no",
                                  fix_id, id, static_cast<int>(FixPotdemReference::COLUMNS))));
  if (fix->restart_reset) {
    fix->restart_reset = 0;
    return;
  }
  fix->take_all();
  check_reference(fix->places());
}

void ComputePotdemStrainAtom::check_reference(double **reference)
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++) {
      const int j = atom->map(atom->bond_atom[i][m]);
      const double re = history->length(i, m);
      if (j < 0 || j >= atom->nlocal || re <= 0.0) continue;
      double del[3] = {reference[j][0] - reference[i][0], reference[j][1] - reference[i][1],
                       reference[j][2] - reference[i][2]};
      PotdemCompat::minimum_image(domain, del);
      const double r = sqrt(del[0] * del[0] + del[1] * del[1] + del[2] * del[2]);
      if (fabs(r - re) > MOVED * re)
        error->one(FLERR,
                   "compute potdem/strain/atom {}: the bond of atoms {} and {} is {} long, not its "
                   "reference "
                   "length {}; define the compute before the bodies move",
                   id, atom->tag[i], atom->tag[j], r, re);
    }
}

double **ComputePotdemStrainAtom::reference() const
{
  const auto *const fix = dynamic_cast<FixPotdemReference *>(modify->get_fix_by_id(fix_id));
  if (!fix)
    error->all(FLERR,
               "compute potdem/strain/atom {}: its fix {}, which keeps the reference positions, "
               "was removed; "
               "define the compute again",
               id, fix_id);
  return fix->places();
}

void ComputePotdemStrainAtom::init()
{
  history = FixPotdemBondHistory::get(lmp, fmt::format("compute potdem/strain/atom {}", id));
  reference();
}

/* ---------------------------------------------------------------------- */

void ComputePotdemStrainAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    memory->destroy(strain);
    memory->create(strain, nmax, COLUMNS, "potdem/strain/atom:strain");
    array_atom = strain;
  }
  init();
  double **const places = reference();
  take_new_bonds(places);
#ifdef POTDEM_WIDE_CODE
  if (potdem_width(lmp) != POTDEM::Width::PLAIN) return fit_all_avx2(places);
#endif
  fit_all(places);
}

/* ----------------------------------------------------------------------
   what stays as long as bonds, ghosts and box do
------------------------------------------------------------------------- */

void ComputePotdemStrainAtom::take_new_bonds(double **reference)
{
  const int nlocal = atom->nlocal;
  if (generation != history->generation || domain->box_change || update->whichflag == 0) {
    generation = history->generation;
    rows.assign(nlocal, Row());
    partner.clear();
    inverse_length2.clear();
  }
  for (int i = 0; i < nlocal; i++)
    if ((atom->mask[i] & groupbit) && rows[i].listed != atom->num_bond[i])
      take_bonds(i, reference, rows[i]);
}

void ComputePotdemStrainAtom::take_bonds(int i, double **reference, Row &row)
{
  POTDEM::StrainFit fit;
  row = Row();
  row.listed = atom->num_bond[i];
  row.first = static_cast<int>(partner.size());
  for (int m = 0; m < atom->num_bond[i]; m++) {
    const double re = history->length(i, m);
    if (atom->bond_type[i][m] <= 0) continue;
    if (re <= 0.0) generation = NONE;    // it may have been measured the next time
    const int k = atom->map(atom->bond_atom[i][m]);
    if (k < 0 || re <= 0.0) continue;
    const int j = domain->closest_image(i, k);
    double n[3], direct[3];
    MathExtra::sub3(reference[j], reference[i], direct);
    MathExtra::copy3(direct, n);
    PotdemCompat::minimum_image(domain, n);
    row.crosses = row.crosses || !std::equal(n, n + 3, direct);
    check_length(i, j, re, MathExtra::len3(n));
    fit.add(n);
    partner.push_back(j);
    inverse_length2.push_back(1.0 / (re * re));
  }
  row.bonds = fit.bonds;
  if (fit.bonds == 0) return;
  row.rank = 6;
  if (fit.invert(REGULAR, row.inverse)) return;
  double values[6], vectors[6][6];
  MathEigen::Jacobi<double, double *, double(*)[6], double const(*)[6]>(6).Diagonalize(
      fit.matrix, values, vectors);
  row.rank = fit.invert(values, vectors, SINGULAR, row.inverse);
}

/* ---------------------------------------------------------------------- */

void ComputePotdemStrainAtom::fit_all(double **reference)
{
  fit_each(reference);
}

#ifdef POTDEM_WIDE_CODE
POTDEM_AVX2 void ComputePotdemStrainAtom::fit_all_avx2(double **reference)
{
  fit_each(reference);
}
#endif

POTDEM_FUNCTION inline void ComputePotdemStrainAtom::fit_each(double **reference)
{
  for (int i = 0; i < atom->nlocal; i++) {
    std::fill_n(strain[i], COLUMNS, 0.0);
    const auto &row = rows[i];
    if (!(atom->mask[i] & groupbit) || row.bonds == 0) continue;
    double sum[6];
    add_bonds(i, row, (const double(*)[3]) atom->x[0],
              (const double(*)[FixPotdemReference::COLUMNS]) reference[0], sum);
    row.inverse.apply(sum, strain[i]);
    strain[i][6] = row.bonds;
    strain[i][7] = row.rank;
  }
}

template <class Places>
POTDEM_FUNCTION inline void ComputePotdemStrainAtom::add_bonds(int i, const Row &row,
                                                               const double (*x)[3],
                                                               Places reference, double *sum) const
{
  const int end = row.first + row.bonds;
  int n = row.first;
  std::fill_n(sum, 6, 0.0);
#ifdef POTDEM_HAS_FOUR
  if (!row.crosses) {
    POTDEM::StrainSum<POTDEM::Four> fours;
    for (; n + 4 <= end; n += 4) {
      const POTDEM::Four3 before(reference, &partner[n], reference[i]), del(x, &partner[n], x[i]);
      const POTDEM::Four reference_del[3] = {before.x, before.y, before.z};
      const auto q = del.dot(del) * POTDEM::read_vector<POTDEM::Four>(&inverse_length2[n]);
      fours.add(reference_del, POTDEM::truss_strain(q));
    }
    for (int k = 0; k < 6; k++) sum[k] = POTDEM::sum(fours.of[k]);
  }
#endif
  POTDEM::StrainSum<double> ones;
  for (; n < end; n++) {
    const int j = partner[n];
    double before[3], del[3];
    MathExtra::sub3(reference[j], reference[i], before);
    MathExtra::sub3(x[j], x[i], del);
    if (row.crosses) PotdemCompat::minimum_image(domain, before);
    ones.add(before, POTDEM::truss_strain(MathExtra::lensq3(del) * inverse_length2[n]));
  }
  for (int k = 0; k < 6; k++) sum[k] += ones.of[k];
}

void ComputePotdemStrainAtom::check_length(int i, int j, double re, double reference) const
{
  if (fabs(reference * reference - re * re) > 2.0 * MOVED * re * re)
    error->one(FLERR,
               "compute potdem/strain/atom {}: the bond of atoms {} and {} has the reference "
               "length {}, but their "
               "reference positions are {} apart: they were bonded after the compute had seen "
               "them elsewhere, "
               "or a periodic box has changed its size; define the compute after the bonds, and "
               "strain across a periodic boundary needs a box of fixed size",
               id, atom->tag[i], atom->tag[j], re, reference);
}

double ComputePotdemStrainAtom::memory_usage()
{
  const double bonds =
      partner.capacity() * sizeof(int) + inverse_length2.capacity() * sizeof(double);
  return static_cast<double>(nmax) * COLUMNS * sizeof(double) + rows.capacity() * sizeof(Row) +
      bonds;
}
