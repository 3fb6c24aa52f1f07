/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A contact: a normal law, a rate law and a tangential law (core/laws) put together. The one place for the loops over
   pairs and walls, single(), and the critical step. */

#ifndef POTDEM_CONTACT_H
#define POTDEM_CONTACT_H

#include "core/contact/kinematics.h"
#include "core/laws/coefficients.h"
#include "core/laws/device.h"
#include "core/laws/evaluation.h"
#include "core/laws/slide.h"
#include "core/stability/spring.h"

#include <type_traits>

namespace POTDEM {

// no rate law, no tangential law
struct Elastic {
  static constexpr std::array<Coefficient<Elastic>, 0> coefficients() { return {}; }
  POTDEM_FUNCTION static constexpr bool active() { return false; }
  static Elastic mixed(const Elastic &, const Elastic &) { return {}; }
};
struct Frictionless {
  static constexpr int STATE = 0;
  static constexpr double mu = 0.0;
};

// what resists at the surface: mi mj over mi + mj, mi over 1 at a wall, each less what spin gives way (sliding_mass)
struct ContactMasses {
  double product, sum;
  double step;    // in which mass over it is force over velocity
  double dt;      // time of a step

  POTDEM_FUNCTION double over_step() const { return product / (sum * step); }
};

struct ContactForces {
  Evaluation elastic;    // of the normal law; the others carry the weight
  double normal;
  double viscous;        // the part of `normal` that has no potential
  double friction[3];    // on the first
};

template <bool SPIN>
POTDEM_FUNCTION inline Slide slide_of(const ContactMotion &at, const ContactMasses &masses,
                                      double normal, double stiffness, double shear_ratio,
                                      bool advance)
{
  const double inverse_r = 1.0 / at.r;
  Slide slide{{},          {inverse_r * at.del[0], inverse_r * at.del[1], inverse_r * at.del[2]},
              normal,      stiffness,
              shear_ratio, masses.over_step(),
              masses.dt,   advance};
  sliding_velocity<SPIN>(at, slide.u);
  return slide;
}

// slide(): Slide, only asked for where the two are pressed together: else there is nothing to hold on to. state: what the law
// remembers, or null
template <class Tangential, class MadeSlide>
POTDEM_FUNCTION inline void friction_force(const Tangential &tangential, double normal,
                                           bool advance, double *state, double *f,
                                           MadeSlide &&slide)
{
  if (normal > 0.0 && tangential.mu > 0.0)
    tangential.force(slide(), state, f);
  else if (advance)
    for (int k = 0; k < Tangential::STATE; k++) state[k] = 0.0;
}

// motion(): ContactMotion, masses(): ContactMasses, only asked for where they matter. state: what the tangential law remembers, or null
template <bool SPIN, class Kernel, class Geometry, class Rate, class Tangential, class Motion,
          class Masses>
POTDEM_FUNCTION inline ContactForces
contact_forces(const Kernel &kernel, double r, const Geometry &geometry, double weight,
               const Rate &rate_law, const Tangential &tangential, double *state, bool advance,
               Motion &&motion, Masses &&masses)
{
  ContactForces found{kernel.evaluate(r, geometry), 0.0, 0.0, {0.0, 0.0, 0.0}};
  double normal = found.elastic.force;
  if constexpr (!std::is_same_v<Rate, Elastic>)
    if (r < geometry.contact) {
      const double rate = rate_of_distance(motion());
      normal = rate_law.total(found.elastic.force, geometry.contact - r, rate);
      found.viscous = weight * (normal - found.elastic.force);
    }
  found.normal = weight * normal;
  if constexpr (!std::is_same_v<Tangential, Frictionless>)
    friction_force(tangential, found.normal, advance, state, found.friction, [&] {
      return slide_of<SPIN>(motion(), masses(), found.normal, weight * found.elastic.stiffness,
                            shear_ratio_of(kernel, 0), advance);
    });
  return found;
}

// its tangent, for the critical step, at the distance r along n. spin_share: what spin leaves of the mass at the surface
template <class Kernel, class Geometry, class Rate, class Tangential>
POTDEM_FUNCTION Spring contact_spring(const Kernel &kernel, double r, const Geometry &geometry,
                                      double weight, const Rate &rate_law,
                                      const Tangential &tangential, const ContactMasses &masses,
                                      double spin_share, const double *n)
{
  const auto law = kernel.evaluate(r, geometry);
  Spring spring{{n[0], n[1], n[2]},
                weight * law.stiffness,
                Geometry::flat ? 0.0 : -weight * law.force / r,
                0.0,
                0.0};
  if constexpr (!std::is_same_v<Rate, Elastic>)
    if (r < geometry.contact)
      spring.viscosity = weight * rate_law.viscosity(law.force, geometry.contact - r);
  if constexpr (!std::is_same_v<Tangential, Frictionless>)
    if (law.force > 0.0 && tangential.mu > 0.0) {
      const Slide slide{{},
                        {n[0], n[1], n[2]},
                        weight * law.force,
                        weight * law.stiffness,
                        shear_ratio_of(kernel, 0),
                        masses.over_step(),
                        masses.dt,
                        false};
      spring.friction = tangential.viscosity(slide) / spin_share;
      if constexpr (Tangential::STATE > 0) spring.across = tangential.stiffness(slide) / spin_share;
    }
  return spring;
}

}    // namespace POTDEM

#endif
