/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_volume_term.h"

#include "core/laws/four.h"
#include "core/laws/truss.h"
#include "lammps/glue/potdem_width.h"
#include "lammps/output/potdem_stiffness.h"

#include "atom.h"
#include "math_extra.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace LAMMPS_NS;

static constexpr int NONE = -1;

PotdemVolumeTerm::PotdemVolumeTerm(LAMMPS *lmp, const PotdemBondNetwork &network) :
    Pointers(lmp), bonds(network)
{
}

// cut bonds have the type 0. Within a run moduli may change, and what bonds have set free stays
void PotdemVolumeTerm::begin(const std::vector<double> &moduli)
{
  const auto before = std::exchange(term_of, std::vector<int>(moduli.size(), NONE));
  int count = 0;
  for (std::size_t type = 1; type < moduli.size(); type++)
    if (moduli[type] != 0.0) term_of[type] = count++;
  if (term_of != before) terms.assign(count, {});
  for (std::size_t type = 1; type < moduli.size(); type++)
    if (term_of[type] >= 0) terms[term_of[type]].kappa = moduli[type];
}

void PotdemVolumeTerm::make_room()
{
  const int count = exists() ? bonds.size() : 0;
  own.resize(count);
  other.resize(count);
}

void PotdemVolumeTerm::find_dilatations(FixPotdemBondHistory &history)
{
  for (auto &term : terms) term.root.assign(atom->nlocal + atom->nghost, 0.0);
  root_of_type.assign(term_of.size(), nullptr);
  for (std::size_t type = 0; type < term_of.size(); type++)
    if (term_of[type] >= 0) root_of_type[type] = terms[term_of[type]].root.data();
  add_strains();
  for (auto &term : terms) {
    for (int i = 0; i < atom->nlocal; i++) term.root[i] *= term.kappa;
    history.forward(term.root.data(), 1);
  }
  free_energy();
}

PotdemVolumeTerm::Leaving &PotdemVolumeTerm::leaving_at(int i, int type)
{
  const int term = term_of[type];
  const auto [begin, end] = leaving.equal_range(atom->tag[i]);
  for (auto at = begin; at != end; ++at)
    if (at->second.term == term) return at->second;
  return leaving.insert({atom->tag[i], {term, terms[term].root[i], 0.0, 0.0}})->second;
}

// kappa/2 root^2 with and without them. In a step in which it has gone to another rank, a particle counts as it was before
void PotdemVolumeTerm::free_energy()
{
  for (const auto &[tag, one] : leaving) {
    if (one.now == 0.0) continue;    // expected, but the run ended
    auto &term = terms[one.term];
    const double half = 0.5 * term.kappa;
    const double then = one.then * (one.root_then - half * one.then);
    const int i = atom->map(tag);
    const double now = i >= 0 && i < atom->nlocal ? one.now * (term.root[i] + half * one.now)
                                                  : one.now * (one.root_then - half * one.now);
    term.freed += 0.5 * (then + now);
  }
  leaving.clear();
}

double PotdemVolumeTerm::freed_energy(int type)
{
  return exists(type) ? std::exchange(terms[term_of[type]].freed, 0.0) : 0.0;
}

void PotdemVolumeTerm::add_strains()
{
#ifdef POTDEM_WIDE_CODE
  if (potdem_width(lmp) != POTDEM::Width::PLAIN) return add_strains_avx2();
#endif
  add_each_strain();
}

#ifdef POTDEM_WIDE_CODE
POTDEM_AVX2 void PotdemVolumeTerm::add_strains_avx2()
{
  add_each_strain();
}
#endif

POTDEM_FUNCTION inline void PotdemVolumeTerm::add_each_strain()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const int end = bonds.first[i + 1];
    int n = bonds.first[i];
#ifdef POTDEM_HAS_FOUR
    n = add_four_strains(i, n, end);
#endif
    for (; n < end; n++) add_strain(i, n);
  }
}

POTDEM_FUNCTION inline void PotdemVolumeTerm::add_strain(int i, int n)
{
  auto *const root = root_of_type[bonds.type[n]];
  if (!root) return;
  const double *const xi = atom->x[i], *const xj = atom->x[bonds.partner[n]];
  const double del[3] = {xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
  const double r2 = del[0] * del[0] + del[1] * del[1] + del[2] * del[2];
  const double strain = POTDEM::truss_strain(r2 * bonds.inverse_length2[n]);
  root[i] += own[n] * strain;
  if (n < bonds.ghosts[i]) root[bonds.partner[n]] += other[n] * strain;
}

#ifdef POTDEM_HAS_FOUR
// bonds n, n + 1, ... of atom i as long as there are four of the first one's type; the first that is left
POTDEM_FUNCTION inline int PotdemVolumeTerm::add_four_strains(int i, int n, int end)
{
  using POTDEM::Four;
  const auto x = (const double(*)[3]) atom->x[0];
  const auto *const type = bonds.type.data();
  const int *const partner = bonds.partner.data();
  const int ghosts = bonds.ghosts[i];
  const int first = n < end ? type[n] : 0;
  auto *const root = root_of_type[first];
  if (!root) return n;
  Four here{};
  for (; n + 4 <= end; n += 4) {
    if ((type[n] ^ first) | (type[n + 1] ^ first) | (type[n + 2] ^ first) | (type[n + 3] ^ first))
      break;
    const POTDEM::Four3 del(x, partner + n, x[i]);
    const Four strain =
        POTDEM::truss_strain(del.dot(del) * POTDEM::read_vector<Four>(&bonds.inverse_length2[n]));
    here += strain * POTDEM::read_vector<Four>(&own[n]);
    const Four there = strain * POTDEM::read_vector<Four>(&other[n]);
    if (n + 4 <= ghosts)
      for (int m = 0; m < 4; m++) root[partner[n + m]] += there[m];
    else
      for (int m = 0; n + m < ghosts; m++) root[partner[n + m]] += there[m];
  }
  root[i] += POTDEM::sum(here);
  return n;
}
#endif

double PotdemVolumeTerm::tension(int type, int i, int j,
                                 const FixPotdemBondHistory::Dilatation &part) const
{
  const auto &root = terms[term_of[type]].root;
  if (std::max(i, j) >= static_cast<int>(root.size())) return 0.0;
  return root[i] * part.own + root[j] * part.other;
}

/* ----------------------------------------------------------------------
   root_i is linear in the displacements u of particle i and its neighbours j, sum g_ij u_j, with g_ij along the bond. By Cauchy's inequality
   root_i^2 <= G_i sum u_j.g_ij g_ij.u_j / |g_ij| with G_i = sum |g_ij|, which adds to each particle what a wall would. If kappa < 0
   nothing is added, which is above it
------------------------------------------------------------------------- */

void PotdemVolumeTerm::add_stiffness_to(PotdemStiffness &sum, FixPotdemBondHistory &history) const
{
  for (std::size_t term = 0; term < terms.size(); term++)
    if (terms[term].kappa > 0.0) add_stiffness_to(sum, history, static_cast<int>(term));
}

void PotdemVolumeTerm::add_stiffness_to(PotdemStiffness &sum, FixPotdemBondHistory &history,
                                        int term) const
{
  const int nlocal = atom->nlocal;
  struct Slope {
    double self[3], total;    // g_ii, G_i
  };
  std::vector<Slope> slopes(nlocal + atom->nghost, Slope());
  // for each bond: atom, partner, whose root changes by g along n with the partner's displacement
  const auto each = [&](const auto &work) {
    for (int i = 0; i < nlocal; i++)
      for (int n = bonds.first[i]; n < bonds.first[i + 1]; n++) {
        if (term_of[bonds.type[n]] != term) continue;
        const int j = bonds.partner[n];
        double along[3];
        MathExtra::sub3(atom->x[j], atom->x[i], along);
        const double r = MathExtra::len3(along), per_length = r * bonds.inverse_length2[n];
        MathExtra::scale3(1.0 / r, along);
        work(i, j, per_length * own[n], along);
        MathExtra::negate3(along);
        work(j, i, per_length * other[n], along);
      }
  };
  each([&](int i, int, double g, const double *along) {
    for (int k = 0; k < 3; k++) slopes[i].self[k] -= g * along[k];
    slopes[i].total += fabs(g);
  });
  for (int i = 0; i < nlocal; i++) slopes[i].total += MathExtra::len3(slopes[i].self);
  history.forward(reinterpret_cast<double *>(slopes.data()), sizeof(Slope) / sizeof(double));
  const double kappa = terms[term].kappa;
  each([&](int i, int j, double g, const double *along) {
    if (j < nlocal)
      sum.add_wall(
          j, {{along[0], along[1], along[2]}, kappa * slopes[i].total * fabs(g), 0.0, 0.0, 0.0});
  });
  for (int i = 0; i < nlocal; i++) {
    const double g = MathExtra::len3(slopes[i].self);
    if (g == 0.0) continue;
    const double *const self = slopes[i].self;
    sum.add_wall(
        i, {{self[0] / g, self[1] / g, self[2] / g}, kappa * slopes[i].total * g, 0.0, 0.0, 0.0});
  }
}

double PotdemVolumeTerm::memory_usage() const
{
  double doubles = own.capacity() + other.capacity();
  for (const auto &term : terms) doubles += term.root.capacity();
  return doubles * sizeof(double);
}
