/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A contact: a normal law, a rate law and a tangential law (core/laws) put together. The one place for the loops over
   pairs and walls, single(), and the critical step. */

#ifndef POTDEM_CONTACT_H
#define POTDEM_CONTACT_H

#include "core/contact/kinematics.h"
#include "core/laws/approach.h"
#include "core/laws/device.h"
#include "core/laws/evaluation.h"
#include "core/laws/none.h"
#include "core/laws/rolling.h"
#include "core/laws/slide.h"
#include "core/stability/spring.h"

#include <cmath>
#include <type_traits>

namespace POTDEM {

// what resists at the surface: mi mj over mi + mj, mi over 1 at a wall, each less what spin gives way (sliding_mass)
struct ContactMasses {
  double product, sum;
  double step;                // in which mass over it is force over velocity
  double dt;                  // time of a step
  double spin_share = 1.0;    // of the product: what spin leaves
  // to rolling and twisting: 1/(R^2/I1 + R^2/I2), and the larger of R^2 m/I (rolling.h)
  double rolling = 0.0, rolling_lever = 0.0;

  POTDEM_FUNCTION double over_step() const { return product / (sum * step); }
};

// of two particles, and what it knows of rolling
POTDEM_FUNCTION inline ContactMasses with_rolling(ContactMasses masses, double mi, double mj,
                                                  double ri, double rj)
{
  const double dbar = ri + rj, lever = (ri > rj ? ri : rj) / dbar;
  masses.rolling = SPHERE_INERTIA * mi * mj * dbar * dbar / (rj * rj * mj + ri * ri * mi);
  masses.rolling_lever = lever * lever / SPHERE_INERTIA;
  return masses;
}

struct SurfaceForces {
  double friction[3];    // on the first
  double torque[3];      // likewise, beside that of friction: of rolling and twisting
};

struct ContactForces {
  Evaluation elastic;    // of the normal law; the others carry the weight
  double normal;
  double pressing;    // of `normal`, what presses the two together: cohesion left out
  double viscous;     // the part of `normal` that has no potential
  SurfaceForces surface;
};

// a contact that is pressed together, as tangential laws see it
struct Pressed {
  double normal, stiffness;    // of the normal force
  double shear_ratio;          // of its law
  double R;                    // effective radius
  bool advance;
};

template <bool SPIN>
POTDEM_FUNCTION inline Slide slide_of(const ContactMotion &at, const ContactMasses &masses,
                                      const Pressed &pressed)
{
  const double inverse_r = 1.0 / at.r;
  Slide slide{{},
              {inverse_r * at.del[0], inverse_r * at.del[1], inverse_r * at.del[2]},
              pressed.normal,
              pressed.stiffness,
              pressed.shear_ratio,
              masses.over_step(),
              masses.dt,
              pressed.advance,
              SPIN ? masses.dt * inverse_r * dot(at.spin_of_both, at.del) : 0.0};
  sliding_velocity<SPIN>(at, slide.u);
  return slide;
}

// of what turns
template <class Tangential>
POTDEM_FUNCTION inline void rolling_torque(const Tangential &tangential, const ContactMotion &at,
                                           const ContactMasses &masses, const Pressed &pressed,
                                           double *state, double *torque)
{
  auto roll = slide_of<true>(at, masses, pressed);
  const double *const w = at.spin_between, *const n = roll.n;
  roll.u[0] = pressed.R * (w[1] * n[2] - w[2] * n[1]);
  roll.u[1] = pressed.R * (w[2] * n[0] - w[0] * n[2]);
  roll.u[2] = pressed.R * (w[0] * n[1] - w[1] * n[0]);
  roll.mass_over_step = masses.rolling / masses.step;
  tangential.resistance.torque(roll, pressed.R, dot(w, n), state, torque);
}

// motion(): ContactMotion, masses(): ContactMasses, only asked for where the two are pressed together: else there is nothing to hold
// on to. state: what the law remembers, or null
template <bool SPIN, class Tangential, class Motion, class Masses>
POTDEM_FUNCTION inline void surface_forces(const Tangential &tangential, const Pressed &pressed,
                                           double *state, SurfaceForces &found, Motion &&motion,
                                           Masses &&masses)
{
  const double held = tangential.mu > 0.0 ? pressed.normal : 0.0;
  const bool slides = held > 0.0;
  if (slides) tangential.force(slide_of<SPIN>(motion(), masses(), pressed), state, found.friction);
  if constexpr (is_rolling<Tangential>) {
    double *const rolling = state + Tangential::SLIDING_STATE;
    if (pressed.normal > 0.0)
      rolling_torque(tangential, motion(), masses(), pressed, rolling, found.torque);
    else if (pressed.advance)
      for (int k = 0; k < RollingResistance::STATE; k++) rolling[k] = 0.0;
  }
  constexpr int SLIDING_STATE = sliding_state<Tangential>();
  if (!slides && pressed.advance)
    for (int k = 0; k < SLIDING_STATE; k++) state[k] = 0.0;
}

// what presses two that touch together, and the force by which a cohesive law pulls them; of the others all of it, and 0
struct Pressing {
  Evaluation elastic;
  double pull;
};
template <class Kernel, class Geometry>
POTDEM_FUNCTION inline auto pressing_of(const Kernel &kernel, double r, const Geometry &geometry,
                                        const Evaluation &, int)
    -> decltype(Pressing{kernel.pressing(r, geometry), kernel.pull(geometry)})
{
  return {kernel.pressing(r, geometry), kernel.pull(geometry)};
}
template <class Kernel, class Geometry>
POTDEM_FUNCTION inline Pressing pressing_of(const Kernel &, double, const Geometry &,
                                            const Evaluation &elastic, long)
{
  return {{elastic.energy, elastic.force, elastic.stiffness}, 0.0};
}

POTDEM_FUNCTION inline Approach approach(const Evaluation &elastic, double overlap, double rate,
                                         double weight, const ContactMasses &masses)
{
  return {elastic.force,
          elastic.energy,
          overlap,
          rate,
          masses.product * masses.dt,
          masses.sum * masses.spin_share * masses.step * weight};
}

// motion and masses as above. state: what the tangential law remembers, or null
template <bool SPIN, class Kernel, class Geometry, class Rate, class Tangential, class Motion,
          class Masses>
POTDEM_FUNCTION inline ContactForces
contact_forces(const Kernel &kernel, double r, const Geometry &geometry, double weight,
               const Rate &rate_law, const Tangential &tangential, double *state, bool advance,
               Motion &&motion, Masses &&masses)
{
  const auto elastic = kernel.evaluate(r, geometry);
  // number by number: what is copied as a whole goes through memory
  ContactForces found{{elastic.energy, elastic.force, elastic.stiffness},
                      0.0,
                      0.0,
                      0.0,
                      {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
  const auto pressing = pressing_of(kernel, r, geometry, elastic, 0);
  double pushed = pressing.elastic.force, normal = found.elastic.force;
  if constexpr (!std::is_same_v<Rate, Elastic>)
    if (r < geometry.contact) {
      pushed = rate_law.total(approach(pressing.elastic, geometry.contact - r,
                                       rate_of_distance(motion()), weight, masses()));
      normal = pushed - pressing.pull;
      found.viscous = weight * (pushed - pressing.elastic.force);
    }
  found.normal = weight * normal;
  found.pressing = weight * pushed;
  if constexpr (!std::is_same_v<Tangential, Frictionless>) {
    const Pressed pressed{found.pressing, weight * found.elastic.stiffness,
                          shear_ratio_of(kernel, 0), geometry.effective_radius(), advance};
    surface_forces<SPIN>(tangential, pressed, state, found.surface, motion, masses);
  }
  return found;
}

// what they resist displacements of the surface with. Rolling and twisting only turn the bodies: their springs, over I/R^2 for the mass,
// beside those that only turn them the same way
template <class Tangential>
POTDEM_FUNCTION inline void add_surface(const Tangential &tangential, const Pressed &pressed,
                                        const ContactMasses &masses, Spring &spring)
{
  Slide slide{{},
              {spring.n[0], spring.n[1], spring.n[2]},
              pressed.normal,
              pressed.stiffness,
              pressed.shear_ratio,
              masses.over_step(),
              masses.dt,
              false};
  if (tangential.mu > 0.0) {
    spring.friction = tangential.viscosity(slide) / masses.spin_share;
    if constexpr (sliding_state<Tangential>() > 0)
      spring.across = tangential.stiffness(slide) / masses.spin_share;
  }
  if constexpr (is_rolling<Tangential>) {
    slide.mass_over_step = masses.rolling / masses.step;
    const auto rolling = tangential.resistance.rolling(slide.stiffness),
               twisting = tangential.resistance.twisting(slide.stiffness);
    const double lever = masses.rolling_lever;
    spring.across = std::fmax(spring.across, 0.0) + lever * rolling.k;
    spring.friction += lever * rolling.viscosity(slide);
    spring.along = std::fmax(spring.along, lever * twisting.k);
    spring.viscosity = std::fmax(spring.viscosity, lever * twisting.viscosity(slide));
  }
}

// its tangent, for the critical step, at the distance r along n
template <class Kernel, class Geometry, class Rate, class Tangential>
POTDEM_FUNCTION inline Spring contact_spring(const Kernel &kernel, double r,
                                             const Geometry &geometry, double weight,
                                             const Rate &rate_law, const Tangential &tangential,
                                             const ContactMasses &masses, const double *n)
{
  const auto law = kernel.evaluate(r, geometry);
  const auto pressing = pressing_of(kernel, r, geometry, law, 0);
  Spring spring{{n[0], n[1], n[2]},
                weight * law.stiffness,
                Geometry::flat ? 0.0 : -weight * law.force / r,
                0.0,
                0.0};
  if constexpr (!std::is_same_v<Rate, Elastic>)
    if (r < geometry.contact)
      spring.viscosity = weight *
          rate_law.viscosity(approach(pressing.elastic, geometry.contact - r, 0.0, weight, masses));
  if constexpr (!std::is_same_v<Tangential, Frictionless>)
    if (pressing.elastic.force > 0.0)
      add_surface(tangential,
                  {weight * pressing.elastic.force, weight * law.stiffness,
                   shear_ratio_of(kernel, 0), 0.0, false},
                  masses, spring);
  return spring;
}

}    // namespace POTDEM

#endif
