/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "least_squares.h"

#include "constants.h"
#include "dilatation.h"

using namespace POTDEM;

namespace {

// of the misfit with respect to a bond's area, from the slopes with respect to the moments of its ends
double slope(const BondedBody::Bond &bond, const Moments &low, const Moments &high)
{
  double p[MOMENTS], force = 0.0, work = 0.0;
  direction_products(bond.n.data(), p);
  for (int k = 0; k < THIRD; k++) force += (low[k] - high[k]) * p[k];
  for (int k = THIRD; k < MOMENTS; k++) work += (low[k] + high[k]) * p[k];
  return force + 0.5 * bond.length * work;
}

}    // namespace

LeastSquares::LeastSquares(const BondedBody &bonded, const std::vector<double> &uniform_areas,
                           const std::vector<Matrix6> &admissible_strains) :
    body(bonded),
    uniform(uniform_areas), admissible(admissible_strains), x(bonded.bonds.size(), 1.0),
    step(bonded.bonds.size()), moments(bonded.nall, Moments{}), done(0)
{
  find_step();
}

std::vector<double> LeastSquares::areas() const
{
  std::vector<double> found;
  found.reserve(x.size());
  for (std::size_t b = 0; b < x.size(); b++) found.push_back(area(b));
  return found;
}

// the weights of the bonds in the dilatation follow the areas found so far
void LeastSquares::find_push()
{
  if (!body.elasticity.has_volume_term()) return;
  push = Dilatation(body, areas(), admissible).pushes();
  for (auto &one : push)
    for (auto &component : one) component *= body.elasticity.volume_modulus();
}

Misfit LeastSquares::misfit(int i, const Matrix6 *target) const
{
  Misfit found(moments[i], body.volume[i], target);
  if (!push.empty()) found.add_push(push[i], body.volume[i]);
  return found;
}

/* ----------------------------------------------------------------------
   Step of the gradient method: one over a diagonal that is nowhere below the second derivative. The misfit of
   particle i alone has a second derivative H_i with the diagonal D_i, H_i <= l_i D_i with l_i the largest
   eigenvalue of H_i scaled by D_i; so their sum is below sum_i l_i D_i.
------------------------------------------------------------------------- */

void LeastSquares::find_step()
{
  struct Seen {
    Matrix6 k;
    double largest;
  };
  std::vector<Seen> seen(body.nall);
  for (int i = 0; i < body.nowned; i++) seen[i] = {admissible[i], largest_eigenvalue(i)};
  body.forward(seen);
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    double above = areas::PULL * areas::PULL;
    for (const int i : {body.bonds[b].low, body.bonds[b].high})
      above += seen[i].largest * curvature(b, seen[i].k, body.volume[i]);
    step[b] = 1.0 / above;
  }
}

// second derivative of one particle's misfit with respect to x of one of its bonds
double LeastSquares::curvature(int b, const Matrix6 &k, double v) const
{
  const Vector6 m = mandel(body.bonds[b].n, body.bonds[b].n);
  double seen = 0.0;
  for (int c = 0; c < 6; c++)
    for (int e = 0; e < 6; e++) seen += k[c][e] * m[c] * m[e];
  const double work = 0.5 * uniform[b] * body.bonds[b].length / v * seen;
  return work * work + uniform[b] * uniform[b] * seen / std::cbrt(v * v * v * v);
}

// power iteration; bonds that the particle does not see are left out
double LeastSquares::largest_eigenvalue(int i) const
{
  const auto neighbours = body.neighbours(i);
  const int n = neighbours.size();
  std::vector<double> diagonal(n), z(n, 0.0);
  std::vector<Moments> products(n);    // of one bond with x = 1
  double most = 0.0;
  for (int h = 0; h < n; h++) {
    const int b = neighbours[h].bond;
    diagonal[h] = curvature(b, admissible[i], body.volume[i]);
    most = std::max(most, diagonal[h]);
    Moments &p = products[h];
    direction_products(body.bonds[b].n.data(), p.data());
    for (int k = 0; k < THIRD; k++) p[k] *= neighbours[h].sign * uniform[b];
    for (int k = THIRD; k < MOMENTS; k++) p[k] *= 0.5 * uniform[b] * body.bonds[b].length;
  }
  double answer = 1.0;
  Moments m;    // any that no eigenvector is orthogonal to
  for (int k = 0; k < MOMENTS; k++)
    m[k] = 1.0 / (1.0 + k) / (k < THIRD ? 1.0 : std::cbrt(body.volume[i]));
  for (int iteration = 0; iteration < areas::POWER_ITERATIONS && most > 0.0; iteration++) {
    double norm = 0.0;
    for (int h = 0; h < n; h++) {
      z[h] = 0.0;
      if (diagonal[h] < areas::UNSEEN * most) continue;
      z[h] = dot(products[h], m);
      norm += z[h] * z[h] / diagonal[h];
      z[h] /= diagonal[h];
    }
    if (iteration > 0) answer = std::sqrt(norm);
    m.fill(0.0);
    for (int h = 0; h < n; h++)
      for (int k = 0; k < MOMENTS; k++) m[k] += z[h] / std::sqrt(norm) * products[h][k];
    m = Misfit(m, body.volume[i], nullptr).slope(admissible[i], body.volume[i]);
  }
  return answer;
}

// moments of the areas z A0 about each owned particle
void LeastSquares::accumulate(const std::vector<double> &z)
{
  std::fill(moments.begin(), moments.end(), Moments{});
  double p[MOMENTS];
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    const auto &bond = body.bonds[b];
    direction_products(bond.n.data(), p);
    const double area = z[b] * uniform[b], work = 0.5 * area * bond.length;
    for (int end = 0; end < 2; end++) {
      const int i = end == 0 ? bond.low : bond.high;
      if (i >= body.nowned) continue;
      const double pull = end == 0 ? area : -area;
      double *m = moments[i].data();
      for (int k = 0; k < THIRD; k++) m[k] += pull * p[k];
      for (int k = THIRD; k < MOMENTS; k++) m[k] += work * p[k];
    }
  }
}

void LeastSquares::find_slopes(const std::vector<double> &z, const std::vector<Matrix6> &target)
{
  accumulate(z);
  for (int i = 0; i < body.nowned; i++)
    if (body.bonded(i)) moments[i] = misfit(i, &target[i]).slope(admissible[i], body.volume[i]);
  body.forward(moments);
}

// projected gradient step from `ahead`; returned: whether the last move, x to there, went uphill (> 0)
double LeastSquares::descend(const std::vector<double> &ahead, std::vector<double> &moved) const
{
  double uphill = 0.0;
  for (std::size_t b = 0; b < body.bonds.size(); b++) {
    const auto &bond = body.bonds[b];
    const double g = uniform[b] * slope(bond, moments[bond.low], moments[bond.high]) +
        areas::PULL * areas::PULL * (ahead[b] - 1.0);
    moved[b] = std::clamp(ahead[b] - step[b] * g, areas::LEAST, areas::MOST);
    uphill += bond.counted * (ahead[b] - moved[b]) * (moved[b] - x[b]) / step[b];
  }
  body.halo.sum(&uphill, 1);
  return uphill;
}

// the momentum is dropped where it points uphill
void LeastSquares::iterate(int n, const std::vector<Matrix6> &target)
{
  find_push();
  std::vector<double> ahead = x, moved(x.size());
  double t = 1.0;
  for (int iteration = 0; iteration < n; iteration++) {
    find_slopes(ahead, target);
    const double uphill = descend(ahead, moved);
    const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * t * t));
    const double momentum = uphill > 0.0 ? 0.0 : (t - 1.0) / next;
    t = uphill > 0.0 ? 1.0 : next;
    for (std::size_t b = 0; b < body.bonds.size(); b++) {
      ahead[b] = moved[b] + momentum * (moved[b] - x[b]);
      x[b] = moved[b];
    }
    done++;
  }
}

std::vector<Misfit> LeastSquares::misfits(const std::vector<Matrix6> *target)
{
  accumulate(x);
  std::vector<Misfit> found;
  found.reserve(body.nowned);
  for (int i = 0; i < body.nowned; i++)
    found.push_back(misfit(i, target ? &(*target)[i] : nullptr));
  return found;
}
