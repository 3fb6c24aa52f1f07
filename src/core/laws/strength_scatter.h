/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Strength that scatters from bond to bond (thesis 5.2.4 names it as future work): the strength of a bond over the
   mean strength, from the IDs of its particles and a seed alone, so that it is the same on every rank, at every
   time and for either order of the two.

     weibull k    F(s) = 1 - exp(-(s G)^k), G = Gamma(1 + 1/k): mean 1, coefficient of variation
                  sqrt(Gamma(1 + 2/k) / G^2 - 1)                                    k > 0
     normal cov   mean 1, standard deviation cov, cut at 3 of them on either side   0 < cov <= 0.3 */

#ifndef POTDEM_STRENGTH_SCATTER_H
#define POTDEM_STRENGTH_SCATTER_H

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace POTDEM {

class StrengthScatter {
 public:
  static constexpr double LARGEST_COV = 0.3, CUT = 3.0;

  StrengthScatter() = default;    // none
  static StrengthScatter weibull(double k, std::uint64_t seed)
  {
    return {WEIBULL, k, 1.0 / std::tgamma(1.0 + 1.0 / k), seed};
  }
  static StrengthScatter normal(double cov, std::uint64_t seed) { return {NORMAL, cov, 1.0, seed}; }

  bool active() const { return form != NONE; }

  // strength of the bond of particles a and b over the mean
  double factor(std::uint64_t a, std::uint64_t b) const
  {
    std::uint64_t state = mix(mix(mix(seed) + std::min(a, b)) + std::max(a, b));
    if (form == WEIBULL) return scale * std::pow(-std::log(uniform(state)), 1.0 / parameter);
    if (form == NONE) return 1.0;
    double z;
    do {    // Box and Muller
      const double radius = std::sqrt(-2.0 * std::log(uniform(state)));
      z = radius * std::cos(2.0 * M_PI * uniform(state));
    } while (std::fabs(z) > CUT);
    return 1.0 + parameter * z;
  }

 private:
  enum Form { NONE, WEIBULL, NORMAL };
  Form form = NONE;
  double parameter = 0.0, scale = 1.0;
  std::uint64_t seed = 0;

  StrengthScatter(Form form, double parameter, double scale, std::uint64_t seed) :
      form(form), parameter(parameter), scale(scale), seed(seed)
  {
  }

  // SplitMix64 (Steele, Lea and Flood, 2014): a step of the sequence and its finaliser
  static std::uint64_t mix(std::uint64_t z)
  {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  // 0 < u < 1
  static double uniform(std::uint64_t &state)
  {
    state = mix(state);
    return (static_cast<double>(state >> 11) + 0.5) * 0x1p-53;
  }
};

}    // namespace POTDEM

#endif
