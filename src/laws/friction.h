/* Sliding friction (thesis eqs 5.18 and 5.27): T = -min(eta |u|, mu |F|) u/|u|

   u: sliding velocity, F: normal force, eta: mass per time, mu: dimensionless. T is exactly zero at
   u = 0. The pure Coulomb form of 5.27 is the limit eta -> infinity; it reverses the sliding within a
   step. `automatic` is the largest eta with which a single contact cannot: effective mass / step. */

#ifndef POTDEM_FRICTION_H
#define POTDEM_FRICTION_H

#include <cmath>

namespace POTDEM {

struct Friction {
  double mu = 0.0;
  double eta = 0.0;
  int automatic = 0;

  double viscosity(double effective_mass, double step) const
  {
    return automatic ? effective_mass / step : eta;
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
