/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What a tangential law sees of a contact that is pressed together, and how spin makes its surfaces give way.

   A tangential law is a struct of coefficients, the first of which is mu, with
     STATE                              numbers that it keeps per contact, 0 at first touch
     force(slide, state, f)             the force f on the first particle (LAMMPS's sign), and what it remembers
     turn(state)                        (if STATE > 0) what the second particle would remember
     energy(state)                      (if STATE > 0) what can be had back
     viscosity(slide)                   the largest force over the velocity of the surface, for the critical step
     stiffness(slide)                   (if STATE > 0) the largest force over its displacement, likewise
     undamped()                         (if it has a dashpot, of the fraction xi) the law with xi = 0, of which the compiler knows it
     needs_shear_ratio                  (if so) it is for normal laws that know the shear modulus: Kernel has shear_ratio */

#ifndef POTDEM_SLIDE_H
#define POTDEM_SLIDE_H

#include "device.h"

#include <type_traits>
#include <utility>

namespace POTDEM {

struct Slide {
  double u[3];         // velocity of the first particle's surface over the second one's
  double n[3];         // from the second to the first
  double normal;       // force, > 0
  double stiffness;    // of the normal force
  double
      shear_ratio;    // of the tangential stiffness to the normal one, by the elasticity of both; 0: not known
  double mass_over_step;    // force over velocity: what ends the sliding within a step
  double dt;                // time of a step
  bool advance;             // a step has been made: state may change
  double turn = 0.0;        // angle by which both turn about n together within a step
};

// of a normal law's kernel; 0: it does not know
template <class Kernel>
POTDEM_FUNCTION inline auto shear_ratio_of(const Kernel &kernel, int)
    -> decltype(kernel.shear_ratio + 0.0)
{
  return kernel.shear_ratio;
}
template <class Kernel> POTDEM_FUNCTION inline double shear_ratio_of(const Kernel &, long)
{
  return 0.0;
}

template <class Kernel>
auto knows_shear_ratio(int) -> decltype(std::declval<Kernel>().shear_ratio, std::true_type());
template <class Kernel> std::false_type knows_shear_ratio(long);

// of a particle that spins, over m r^2: a solid sphere, a disc
constexpr double SPHERE_INERTIA = 0.4, DISC_INERTIA = 0.5;

// mass that a tangential force at the surface accelerates there, over the particle's: 1/(1/m + a^2/I) with
// arm = a/r, inertia = I/(m r^2); 2/7 for a solid sphere, 1/3 for a disc
POTDEM_FUNCTION constexpr double sliding_mass(double arm, double inertia)
{
  return 1.0 / (1.0 + arm * arm / inertia);
}

}    // namespace POTDEM

#endif
