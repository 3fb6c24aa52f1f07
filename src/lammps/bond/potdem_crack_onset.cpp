/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/potdem_crack_onset.h"

#include "core/areas/constants.h"
#include "core/laws/green_lagrange.h"
#include "core/laws/strength_scatter.h"
#include "core/laws/truss.h"
#include "lammps/glue/potdem_swap.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "math_eigen.h"
#include "math_extra.h"

#include <cmath>
#include <map>
#include <set>

using namespace LAMMPS_NS;

static constexpr int NONE = -1;
// of the largest eigenvalue: below it the bonds do not tell the strain
static constexpr double SINGULAR = 1e-4;
// of a plane network of central forces
static constexpr double PLANE_POISSON = 1.0 / 3.0;

// of its principal values: reached if the two others are equal, as in a bar that is pulled
static double bound_of(const double (*stress)[3])
{
  const double mean = (stress[0][0] + stress[1][1] + stress[2][2]) / 3.0;
  double deviation2 = 0.0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) {
      const double deviation = stress[a][b] - (a == b ? mean : 0.0);
      deviation2 += deviation * deviation;
    }
  return mean + sqrt(2.0 / 3.0 * deviation2);
}

PotdemCrackOnset::PotdemCrackOnset(LAMMPS *lmp, const PotdemBondNetwork &network,
                                   const PotdemSoftening &softening) :
    Pointers(lmp),
    network(network), softening(softening), packed(NONE)
{
}

std::vector<BreakableBonds::Reached>
PotdemCrackOnset::find(const BreakableBonds::CrackQuestion &question, double E,
                       const std::vector<BreakableBonds::Listed> &loaded, int generation)
{
  follow_lists(generation);
  find_loaded(loaded, question.type);
  for (const int i : loaded_atoms) {
    stress_of[i] = static_cast<int>(stresses.size());
    stresses.push_back(stress_at(i, question, E));
  }
  if (!question.sharing.empty()) tell(question);

  std::vector<BreakableBonds::Reached> reached;
  if (stresses.empty()) return reached;
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = network.first[i]; n < network.first[i + 1]; n++) {
      const int j = network.partner[n];
      if ((stress_of[i] == NONE && stress_of[j] == NONE) || network.type[n] != question.type ||
          softening.is_among(n) || !(atom->mask[i] & atom->mask[j] & question.groupbit))
        continue;
      double del[3];
      BreakableBonds::Reached one{i, j, strain(i, {n, j}, del), 0.0, 1.0};
      if (is_reached(question, E, del, one)) reached.push_back(one);
    }
  return reached;
}

void PotdemCrackOnset::follow_lists(int generation)
{
  if (packed == generation) return;
  packed = generation;
  const int nlocal = atom->nlocal;
  first.assign(nlocal + 1, 0);
  const auto each_end = [&](const auto &work) {
    for (int i = 0; i < nlocal; i++)
      for (int n = network.first[i]; n < network.first[i + 1]; n++) {
        const int j = network.partner[n];
        work(i, End{n, j});
        if (j < nlocal) work(j, End{n, i});
      }
  };
  each_end([&](int i, const End &) {
    first[i + 1]++;
  });
  for (int i = 0; i < nlocal; i++) first[i + 1] += first[i];
  ends.resize(first[nlocal]);
  std::vector<int> next(first.begin(), first.end() - 1);
  each_end([&](int i, const End &end) {
    ends[next[i]++] = end;
  });
}

double PotdemCrackOnset::strain(int i, const End &end, double *del) const
{
  MathExtra::sub3(atom->x[end.other], atom->x[i], del);
  return POTDEM::truss_strain(MathExtra::lensq3(del) * network.inverse_length2[end.bond]);
}

void PotdemCrackOnset::find_loaded(const std::vector<BreakableBonds::Listed> &loaded, int type)
{
  const int nlocal = atom->nlocal;
  stress_of.assign(nlocal + atom->nghost, NONE);
  stresses.clear();
  loaded_atoms.clear();
  for (const auto &one : loaded) {
    if (one.type != type || softening.is_among(one.packed)) continue;
    for (const int end : {one.i, one.j}) {
      if (end >= nlocal || stress_of[end] != NONE) continue;
      stress_of[end] = 0;
      loaded_atoms.push_back(end);
    }
  }
}

// with the strain of all its bonds of the type
PotdemCrackOnset::Stress
PotdemCrackOnset::stress_at(int i, const BreakableBonds::CrackQuestion &question, double E) const
{
  POTDEM::StrainFit fit;
  POTDEM::StrainSum<double> sum;
  for (int k = first[i]; k < first[i + 1]; k++) {
    const int n = ends[k].bond;
    if (network.type[n] != question.type) continue;
    double del[3];
    const double eps = strain(i, ends[k], del);
    const double left = eps > 0.0 ? 1.0 - softening.damage(n) : 1.0;
    const double weight = left * network.modulus(n) * network.length(n);
    fit.add(del, weight);
    sum.add(del, weight * eps);
  }
  const bool plane = domain->dimension == 2;
  if (plane)
    for (const int k : {2, 4, 5}) fit.matrix[k][k] = fit.matrix[0][0] + fit.matrix[1][1];

  Stress stress{NAN, {}};
  POTDEM::StrainInverse inverse;
  if (!fit.invert(SINGULAR, inverse)) return stress;
  double e[6];
  inverse.apply(sum.of, e);
  const double nu = plane ? PLANE_POISSON : POTDEM::areas::POISSON;
  const double twice_shear = E / (1.0 + nu);
  const double lame = twice_shear * nu / (plane ? 1.0 - nu : 1.0 - 2.0 * nu);
  const double mean = lame * (e[0] + e[1] + e[2]);
  static constexpr int AT[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  double tensor[3][3], values[3], vectors[3][3];
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) tensor[a][b] = twice_shear * e[AT[a][b]];
  for (int a = 0; a < domain->dimension; a++) tensor[a][a] += mean;
  stress.largest = bound_of(tensor);
  if (stress.largest < question.strength && !question.scatter.active()) return stress;
  if (MathEigen::jacobi3(tensor, values, vectors) != 0) return {NAN, {}};
  stress.largest = values[0];
  for (int k = 0; k < 3; k++) stress.direction[k] = vectors[k][0];
  return stress;
}

// each rank that has bonds of a loaded particle of this one hears its stress
void PotdemCrackOnset::tell(const BreakableBonds::CrackQuestion &question)
{
  const int nlocal = atom->nlocal;
  std::map<int, std::vector<Told>> news;
  for (const int rank : question.sharing) news[rank];
  for (const int i : loaded_atoms) {
    std::set<int> ranks;
    for (int k = first[i]; k < first[i + 1]; k++) {
      const int j = ends[k].other;
      if (j >= nlocal) ranks.insert(question.owner_of_ghost[j - nlocal]);
    }
    for (const int rank : ranks)
      if (rank != comm->me) news[rank].push_back({atom->tag[i], stresses[stress_of[i]]});
  }
  potdem_swap(world, news);
  std::map<tagint, int> heard;
  for (const auto &[rank, all] : news)
    for (const auto &one : all) {
      heard[one.tag] = static_cast<int>(stresses.size());
      stresses.push_back(one.stress);
    }
  for (int j = nlocal; j < nlocal + atom->nghost; j++) {
    const int owned = atom->map(atom->tag[j]);
    const auto at = heard.find(atom->tag[j]);
    if (at != heard.end())
      stress_of[j] = at->second;
    else if (owned < nlocal)
      stress_of[j] = stress_of[owned];
  }
}

bool PotdemCrackOnset::is_reached(const BreakableBonds::CrackQuestion &question, double E,
                                  const double *del, BreakableBonds::Reached &one) const
{
  if (one.strain <= 0.0) return false;
  const double strength =
      question.strength * question.scatter.factor(atom->tag[one.i], atom->tag[one.j]);
  const Stress *decisive = nullptr;
  const bool in_order = atom->tag[one.i] < atom->tag[one.j];    // on each rank, if they are equal
  for (const int end : {in_order ? one.i : one.j, in_order ? one.j : one.i}) {
    if (stress_of[end] == NONE) continue;
    const auto *const known = &stresses[stress_of[end]];
    if (std::isfinite(known->largest) && (!decisive || known->largest > decisive->largest))
      decisive = known;
  }
  one.stress = decisive ? decisive->largest : E * one.strain;
  if (one.stress < strength) return false;
  if (decisive) one.cosine = fabs(MathExtra::dot3(decisive->direction, del)) / MathExtra::len3(del);
  return true;
}

double PotdemCrackOnset::memory_usage() const
{
  const double ints = first.capacity() + stress_of.capacity() + loaded_atoms.capacity();
  return ints * sizeof(int) + ends.capacity() * sizeof(End) + stresses.capacity() * sizeof(Stress);
}
