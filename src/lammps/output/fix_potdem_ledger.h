/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the dissipative forces have taken out of the system. Styles note their dissipative force on each
   particle while they compute it; at the end of the step, when the velocity of that instant is known, its
   work is booked. Velocity Verlet applies the force of a step half before and half after it, so the sum
   is the trapezoidal rule: second order in the step. Exists only where compute potdem/energy does; the
   styles then find it at init. */

#ifndef LMP_FIX_POTDEM_LEDGER_H
#define LMP_FIX_POTDEM_LEDGER_H

#include "fix.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {

class FixPotdemLedger : public Fix {
 public:
  enum Kind { FRICTION, VISCOUS, DAMPING, NKINDS };

  static FixPotdemLedger *find(LAMMPS *);    // null in a minimization: nothing is dissipated there

  FixPotdemLedger(LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  void setup(int) override;
  void end_of_step() override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;
  double memory_usage() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  void add(Kind kind, int i, double fx, double fy, double fz)
  {
    double *force = forces[i].data() + 3 * kind;
    add(force[0], fx);
    add(force[1], fy);
    add(force[2], fz);
  }

  void add_torque(int i, double arm, const double *turn)    // of friction: arm * turn
  {
    for (int k = 0; k < 3; k++) add(forces[i][3 * NKINDS + k], arm * turn[k]);
  }

  // a wall that moves with velocity u pushes with f: its work, and what of it is friction or viscous heat
  void add_wall(double power) { wall_power += power; }
  void add_slip(Kind kind, double power) { slip_power[kind] += power; }

  // totals over all ranks
  double heat(Kind kind) const { return booked[kind]; }
  double wall_work() const { return booked[NKINDS]; }
  double springs_then() const { return springs; }    // energy of the springs when it began

 private:
  static constexpr int WIDTH = 3 * NKINDS + 3;
  std::vector<std::array<double, WIDTH>> forces;    // owned and ghost particles
  bool threads;                                     // two of them may note forces on one particle
  double wall_power, slip_power[NKINDS];
  double step;    // that is being done: a fix may change the next one before this is booked
  std::array<double, NKINDS + 1> booked, rate;    // rate: power of the latest step
  bool begun;
  double springs;

  void add(double &sum, double part) const
  {
    if (threads) {
#pragma omp atomic
      sum += part;
    } else {
      sum += part;
    }
  }
  std::array<double, NKINDS + 1> powers();
};

}    // namespace LAMMPS_NS

#endif
