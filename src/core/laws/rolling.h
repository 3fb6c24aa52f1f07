/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Resistance to rolling and twisting that remembers (Luding, 2008), beside any law of friction. Two bodies that roll on each other,
   or turn about the normal, displace a spring, which carries mu times the normal force at most; its force makes a pair of torques,
   and no force:

     rolling    v = R w x n      torque R n x T on the first        T: tangential_spring.h with v for the sliding velocity
     twisting   v = R w . n      torque R T n on the first          T: the same, a number

   w: angular velocity of the first over the second; n: from the second to the first; R: r1 r2/(r1 + r2), at a wall the
   particle's radius. Torques on the second are the opposite ones. k = ratio * dF/dw, F: normal force; xi: fraction of critical damping of the motion
   that the spring resists, with the mass 1/(R^2/I1 + R^2/I2).

   rolling mu ratio xi    twisting mu ratio xi
   mu >= 0; ratio > 0; xi >= 0. */

#ifndef POTDEM_ROLLING_H
#define POTDEM_ROLLING_H

#include "coefficients.h"
#include "device.h"
#include "slide.h"
#include "tangential_spring.h"

#include <cmath>
#include <utility>

namespace POTDEM {

struct RollingResistance {
  static constexpr int ROLLING = SlipSpring::STATE, STATE = ROLLING + 2;

  double mu, ratio, xi;
  double twist_mu, twist_ratio, twist_xi;

  static constexpr auto coefficients()
  {
    using Law = RollingResistance;
    return std::array{option("rolling", "mu", &Law::mu, nonnegative(), "1"),
                      continued_by("rolling", "ratio", &Law::ratio, positive(), "1"),
                      continued_by("rolling", "xi", &Law::xi, nonnegative(), "1"),
                      option("twisting", "mu", &Law::twist_mu, nonnegative(), "1"),
                      continued_by("twisting", "ratio", &Law::twist_ratio, positive(), "1"),
                      continued_by("twisting", "xi", &Law::twist_xi, nonnegative(), "1")};
  }

  POTDEM_FUNCTION bool active() const { return mu > 0.0 || twist_mu > 0.0; }
  bool given() const { return ratio > 0.0 || twist_ratio > 0.0; }    // with mu = 0, too

  // the material that rolls more easily decides; springs in series
  static RollingResistance mixed(const RollingResistance &a, const RollingResistance &b)
  {
    const auto series = [](double one, double other) {
      return one + other > 0.0 ? 2.0 * one * other / (one + other) : 0.0;
    };
    return {std::fmin(a.mu, b.mu),
            series(a.ratio, b.ratio),
            0.5 * (a.xi + b.xi),
            std::fmin(a.twist_mu, b.twist_mu),
            series(a.twist_ratio, b.twist_ratio),
            0.5 * (a.twist_xi + b.twist_xi)};
  }

  POTDEM_FUNCTION SlipSpring rolling(double stiffness) const { return {ratio * stiffness, mu, xi}; }
  POTDEM_FUNCTION SlipSpring twisting(double stiffness) const
  {
    return {twist_ratio * stiffness, twist_mu, twist_xi};
  }

  // on the first. at.u: R w x n, at.mass_over_step: of the mass above; twist: w . n
  POTDEM_FUNCTION void torque(const Slide &at, double R, double twist, double *state,
                              double *found) const
  {
    double T[3];
    rolling(at.stiffness).force(at, state, T);
    const double along = twisting(at.stiffness).force_along(at, R * twist, state + ROLLING);
    const double *const n = at.n;
    found[0] = R * (n[1] * T[2] - n[2] * T[1] + along * n[0]);
    found[1] = R * (n[2] * T[0] - n[0] * T[2] + along * n[1]);
    found[2] = R * (n[0] * T[1] - n[1] * T[0] + along * n[2]);
  }

  POTDEM_FUNCTION static double energy(const double *state)
  {
    const double *const twist = state + ROLLING;
    return SlipSpring::energy(state) +
        (twist[1] > 0.0 ? 0.5 * twist[0] * twist[0] / twist[1] : 0.0);
  }
};

// a law of friction with such a resistance; the second particle sees the rolling and twisting springs as the first does
template <class Tangential> struct Rolls : public Tangential {
  RollingResistance resistance;

  static constexpr int SLIDING_STATE = Tangential::STATE,
                       STATE = SLIDING_STATE + RollingResistance::STATE;

  template <class Law = Tangential, class = decltype(std::declval<Law>().undamped())>
  POTDEM_FUNCTION Rolls undamped() const
  {
    return {Tangential::undamped(), resistance};
  }
  POTDEM_FUNCTION void turn(double *state) const
  {
    if constexpr (SLIDING_STATE > 0) Tangential::turn(state);
  }
  POTDEM_FUNCTION double energy(const double *state) const
  {
    double found = RollingResistance::energy(state + SLIDING_STATE);
    if constexpr (SLIDING_STATE > 0) found += Tangential::energy(state);
    return found;
  }
};

template <class Tangential> constexpr bool is_rolling = false;
template <class Tangential> constexpr bool is_rolling<Rolls<Tangential>> = true;

// numbers that the law of friction itself keeps
template <class Tangential> constexpr int sliding_state()
{
  if constexpr (is_rolling<Tangential>)
    return Tangential::SLIDING_STATE;
  else
    return Tangential::STATE;
}

}    // namespace POTDEM

#endif
