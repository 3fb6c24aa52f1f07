/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Friction that remembers (Cundall and Strack, 1979): what touches sticks together by a spring in the plane of contact, which
   carries mu times the normal force at most.

     dT/dt = -k u        |T| <= mu F        u: sliding velocity, F: normal force, k = ratio * dF/dw
     force = T - c u, c = 2 xi sqrt(k m)    with |force| <= mu F        m: mass that resists at the surface

   A contact keeps T and the k for which it holds. T turns with the plane of contact. Where k falls, as it does when the normal
   force of Hertz falls, T falls as k does: the displacement T/k stays, and no energy is made (Thornton, Cummins and Cleary,
   2013). Where k grows T stays. The spring has the energy T^2/(2 k); sliding dissipates, and so does c.

   friction mu spring ratio [damping xi]
   ratio > 0: of the tangential stiffness to the normal one (2/3 to 1 for solids); xi >= 0: fraction of critical damping. */

#ifndef POTDEM_TANGENTIAL_SPRING_H
#define POTDEM_TANGENTIAL_SPRING_H

#include "coefficients.h"
#include "device.h"
#include "slide.h"

#include <cmath>

namespace POTDEM {

// what a contact keeps: T, k
struct SlipSpring {
  static constexpr int STATE = 4;

  double k, mu, xi;

  POTDEM_FUNCTION static double square(const double *a)
  {
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  }

  POTDEM_FUNCTION double viscosity(const Slide &at) const
  {
    return 2.0 * xi * std::sqrt(k * at.mass_over_step * at.dt);
  }

  // the elastic part in the present plane of contact, turned with the two about n, for the present stiffness
  POTDEM_FUNCTION void turned(const Slide &at, const double *state, double *T) const
  {
    const double *const n = at.n;
    const double out = state[0] * n[0] + state[1] * n[1] + state[2] * n[2];
    for (int c = 0; c < 3; c++) T[c] = state[c] - out * n[c];
    const double turn = at.advance ? at.turn : 0.0;
    T[0] += turn * (n[1] * state[2] - n[2] * state[1]);
    T[1] += turn * (n[2] * state[0] - n[0] * state[2]);
    T[2] += turn * (n[0] * state[1] - n[1] * state[0]);
    const double left = square(T), softer = k < state[3] ? k : state[3];
    const double above = softer * softer * square(state), below = state[3] * state[3] * left;
    const double scale = below > 0.0 ? std::sqrt(above / below) : 0.0;
    for (int c = 0; c < 3; c++) T[c] *= scale;
  }

  POTDEM_FUNCTION static void limit(double *T, double most, bool applies = true)
  {
    const double size = applies ? square(T) : 0.0;
    const double share = size > most * most ? most / std::sqrt(size) : 1.0;
    for (int c = 0; c < 3; c++) T[c] *= share;
  }

  // to rounding: what a run left is where it goes on, to the last bit
  POTDEM_FUNCTION static bool is_found_again(const double *T, const double *state)
  {
    constexpr double rounding = 1e-14;
    const double off[3] = {T[0] - state[0], T[1] - state[1], T[2] - state[2]};
    return square(off) <= rounding * rounding * square(state);
  }

  POTDEM_FUNCTION void force(const Slide &at, double *state, double *f) const
  {
    const double most = mu * at.normal, c = xi > 0.0 ? viscosity(at) : 0.0;
    double T[3];
    turned(at, state, T);
    const double dt = at.advance ? at.dt : 0.0;
    for (int d = 0; d < 3; d++) T[d] -= k * at.u[d] * dt;
    limit(T, most);
    const bool same = !at.advance && is_found_again(T, state);
    for (int d = 0; d < 3; d++) T[d] = same ? state[d] : T[d];
    for (int d = 0; d < 3; d++) f[d] = T[d] - c * at.u[d];
    limit(f, most, c > 0.0);
    for (int d = 0; d < 3; d++) state[d] = at.advance ? T[d] : state[d];
    state[3] = at.advance ? k : state[3];
  }

  POTDEM_FUNCTION static double within(double T, double most)
  {
    const double above = T > -most ? T : -most;
    return above < most ? above : most;
  }

  // the same for a motion along the normal at the speed u. state: T, k
  POTDEM_FUNCTION double force_along(const Slide &at, double u, double *state) const
  {
    const double most = mu * at.normal;
    const double had = state[0] * (k < state[1] ? k / state[1] : 1.0);
    const double T = within(had - k * u * (at.advance ? at.dt : 0.0), most);
    const double damped = xi > 0.0 ? T - viscosity(at) * u : T;
    state[0] = at.advance ? T : state[0];
    state[1] = at.advance ? k : state[1];
    return within(damped, most);
  }

  // as the second particle sees it
  POTDEM_FUNCTION static void turn(double *state)
  {
    for (int c = 0; c < 3; c++) state[c] = -state[c];
  }

  POTDEM_FUNCTION static double energy(const double *state)
  {
    if (state[3] == 0.0) return 0.0;
    return 0.5 * (state[0] * state[0] + state[1] * state[1] + state[2] * state[2]) / state[3];
  }
};

// what laws of such a spring have in common; they have mu, xi and stiffness(slide)
template <class Law> struct RemembersSlip {
  static constexpr int STATE = SlipSpring::STATE;

  POTDEM_FUNCTION SlipSpring spring(const Slide &at) const
  {
    const auto &law = static_cast<const Law &>(*this);
    return {law.stiffness(at), law.mu, law.xi};
  }
  POTDEM_FUNCTION void force(const Slide &at, double *state, double *f) const
  {
    spring(at).force(at, state, f);
  }
  POTDEM_FUNCTION double viscosity(const Slide &at) const { return spring(at).viscosity(at); }
  POTDEM_FUNCTION static void turn(double *state) { SlipSpring::turn(state); }
  POTDEM_FUNCTION static double energy(const double *state) { return SlipSpring::energy(state); }
};

struct TangentialSpring : public RemembersSlip<TangentialSpring> {
  static constexpr const char *keyword = "spring";

  double mu = 0.0, ratio = 0.0, xi = 0.0;

  static constexpr auto coefficients()
  {
    using Law = TangentialSpring;
    return std::array{
        required("mu", &Law::mu, nonnegative(), "1"),
        required("ratio", &Law::ratio, positive(), "1").called("friction spring ratio"),
        option("damping", "xi", &Law::xi, nonnegative(), "1")};
  }

  // the more slippery material decides; springs in series
  static TangentialSpring mixed(const TangentialSpring &a, const TangentialSpring &b)
  {
    return {{},
            std::fmin(a.mu, b.mu),
            2.0 * a.ratio * b.ratio / (a.ratio + b.ratio),
            0.5 * (a.xi + b.xi)};
  }

  POTDEM_FUNCTION TangentialSpring undamped() const { return {{}, mu, ratio, 0.0}; }

  POTDEM_FUNCTION double stiffness(const Slide &at) const { return ratio * at.stiffness; }
};

}    // namespace POTDEM

#endif
