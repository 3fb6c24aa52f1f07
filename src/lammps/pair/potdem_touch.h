/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Velocities at the contact of two particles, and the friction that they cause. With rotation (SPIN) the
   surfaces move, and the arms from the centres reach to the contact. */

#ifndef LMP_POTDEM_TOUCH_H
#define LMP_POTDEM_TOUCH_H

#include "core/laws/friction.h"

#include <cmath>

namespace LAMMPS_NS {

// what a tangential force at the surface of a solid sphere accelerates there, over its mass: spin adds r^2/I
static constexpr double SPHERE_SLIDING_MASS = 2.0 / 7.0;

// the particles' state
struct PotdemMotion {
  const double (*v)[3], (*omega)[3];
  const double *radius, *rmass;
  double step;    // in which mass over it is force over velocity: dt / mvv2e
};

// del = x_i - x_j, r its length
struct PotdemTouch {
  int i, j;
  double del[3], r;
};

// r dr/dt
inline double potdem_half_rate2(const PotdemMotion &at, const PotdemTouch &touch)
{
  const double *vi = at.v[touch.i], *vj = at.v[touch.j], *del = touch.del;
  return (vi[0] - vj[0]) * del[0] + (vi[1] - vj[1]) * del[1] + (vi[2] - vj[2]) * del[2];
}

// dr/dt
inline double potdem_rate(const PotdemMotion &at, const PotdemTouch &touch)
{
  return potdem_half_rate2(at, touch) / touch.r;
}

template <bool SPIN>
inline void potdem_slide_velocity(const PotdemMotion &at, const PotdemTouch &touch, double *u)
{
  const double *vi = at.v[touch.i], *vj = at.v[touch.j], *del = touch.del;
  const double along = potdem_half_rate2(at, touch) / (touch.r * touch.r);
  for (int k = 0; k < 3; k++) u[k] = vi[k] - vj[k] - along * del[k];
  if (!SPIN) return;
  const double ri = at.radius[touch.i], rj = at.radius[touch.j], share = 1.0 / (ri + rj);
  double spin[3];
  for (int k = 0; k < 3; k++)
    spin[k] = share * (ri * at.omega[touch.i][k] + rj * at.omega[touch.j][k]);
  u[0] -= spin[1] * del[2] - spin[2] * del[1];
  u[1] -= spin[2] * del[0] - spin[0] * del[2];
  u[2] -= spin[0] * del[1] - spin[1] * del[0];
}

// friction on i
template <bool SPIN>
inline void potdem_drag(const PotdemMotion &at, const PotdemTouch &touch,
                        const POTDEM::Friction &friction, double normal, double *drag)
{
  potdem_slide_velocity<SPIN>(at, touch, drag);
  const double speed = sqrt(drag[0] * drag[0] + drag[1] * drag[1] + drag[2] * drag[2]);
  if (speed == 0.0) return;
  const double mi = at.rmass[touch.i], mj = at.rmass[touch.j];
  const double share = SPIN ? SPHERE_SLIDING_MASS : 1.0;
  // effective mass over step, in one division
  const double eta = friction.viscosity(share * mi * mj, (mi + mj) * at.step);
  const double b = friction.factor(speed, normal, eta);
  for (int k = 0; k < 3; k++) drag[k] *= -b;
}

// torque of the drag over the arm of either particle: its radius times this
inline void potdem_turn(const PotdemMotion &at, const PotdemTouch &touch, const double *drag,
                        double *turn)
{
  const double *del = touch.del, share = 1.0 / (at.radius[touch.i] + at.radius[touch.j]);
  turn[0] = share * (drag[1] * del[2] - drag[2] * del[1]);
  turn[1] = share * (drag[2] * del[0] - drag[0] * del[2]);
  turn[2] = share * (drag[0] * del[1] - drag[1] * del[0]);
}

}    // namespace LAMMPS_NS

#endif
