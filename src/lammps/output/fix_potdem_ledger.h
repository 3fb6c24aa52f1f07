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
#include <atomic>
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
    auto &force = begin(kind)[i];
    add(force[0], fx);
    add(force[1], fy);
    add(force[2], fz);
  }

  void add_torque(int i, double arm, const double *turn)    // of friction: arm * turn
  {
    auto &torque = begin(TORQUE)[i];
    for (int k = 0; k < 3; k++) add(torque[k], arm * turn[k]);
  }

  // a wall that moves with velocity u pushes with f: its work, and what of it is friction or viscous heat
  void add_wall(double power) { wall_power += power; }
  void add_slip(Kind kind, double power) { slip_power[kind] += power; }

  // totals over all ranks
  double heat(Kind kind) const { return booked[kind]; }
  double wall_work() const { return booked[NKINDS]; }
  double springs_then() const { return springs; }    // energy of the springs when it began

 private:
  // of owned and ghost particles; zeros, and left alone, as long as nobody notes any
  typedef std::vector<std::array<double, 3>> Forces;
  static constexpr int TORQUE = NKINDS, NFORCES = NKINDS + 1;
  std::array<Forces, NFORCES> forces;
  std::array<std::atomic<bool>, NFORCES> noted;    // since they were zeros
  bool threads;                                    // two of them may note forces on one particle
  double wall_power, slip_power[NKINDS];
  double step;    // that is being done: a fix may change the next one before this is booked
  std::array<double, NKINDS + 1> booked, rate;    // rate: power of the latest step
  bool begun;
  double springs;

  Forces &begin(int which)
  {
    if (!noted[which].load(std::memory_order_relaxed))
      noted[which].store(true, std::memory_order_relaxed);
    return forces[which];
  }
  void add(double &sum, double part) const
  {
    if (threads) {
#pragma omp atomic
      sum += part;
    } else {
      sum += part;
    }
  }
  double power(int which, double **v) const;
  void bring_back();
  std::array<double, NKINDS + 1> powers();
};

}    // namespace LAMMPS_NS

#endif
