/* Sliding friction (thesis eqs 5.18 and 5.27): T = -min(eta |u|, mu |F|) u/|u|

   u: sliding velocity, F: normal force, eta: mass per time, mu: dimensionless. T is exactly zero at
   u = 0. The pure Coulomb form of 5.27 is the limit eta -> infinity; it reverses the sliding within a
   step. `automatic` is the largest eta with which a single contact cannot: effective mass / step.
   At a wall all other forces on the particle are known, and `automatic` means the force that brings the
   particle to rest within the step (`stop`), as far as mu |F| allows: it holds a particle at rest
   without creep.
   Where a particle may spin, its surface gives way sooner: `sliding_mass` is what resists there. */

#ifndef POTDEM_FRICTION_H
#define POTDEM_FRICTION_H

#include <cmath>

namespace POTDEM {

// of a particle that spins, over m r^2: a solid sphere, a disc
constexpr double SPHERE_INERTIA = 0.4, DISC_INERTIA = 0.5;

// mass that a tangential force at the surface accelerates there, over the particle's: 1/(1/m + a^2/I) with
// arm = a/r, inertia = I/(m r^2); 2/7 for a solid sphere, 1/3 for a disc
inline double sliding_mass(double arm, double inertia)
{
  return 1.0 / (1.0 + arm * arm / inertia);
}

struct Friction {
  double mu = 0.0;
  double eta = 0.0;
  int automatic = 0;

  double viscosity(double effective_mass, double step) const
  {
    return automatic ? effective_mass / step : eta;
  }

  // Coulomb friction against a force `stop` that would end the sliding within the step: its share
  double share(double stop, double normal_force) const
  {
    const double limit = mu * std::fabs(normal_force);
    return stop <= limit ? 1.0 : limit / stop;
  }

  // the factor b of T = -b u
  double factor(double speed, double normal_force, double viscosity) const
  {
    const double limit = mu * std::fabs(normal_force);
    return viscosity * speed <= limit ? viscosity : limit / speed;
  }
};

}    // namespace POTDEM

#endif
