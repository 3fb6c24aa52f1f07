/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Says so when a run is going wrong, once for each reason and run. The critical step is checked when a run begins and then now
   and then; what happens between is seen where it costs nothing: the loops already look for pairs that are too
   close, and a neighbour list is rebuilt when particles have moved far. Created by the pair styles, the bond style and the
   walls, one per simulation; no warnings in a minimization or in `run 0`. It stops what LAMMPS would stop later, with fewer
   words, or not at all: particles outside the box, two time integrations of one particle, a timestep that is not > 0. */

#ifndef LMP_FIX_POTDEM_MONITOR_H
#define LMP_FIX_POTDEM_MONITOR_H

#include "fix.h"

#include <array>
#include <memory>
#include <string>

namespace LAMMPS_NS {

class FixPotdemMonitor : public Fix {
 public:
  static constexpr double DEEP = 0.5;       // distance over that of first contact
  static constexpr double CRUSHED = 0.2;    // length of a bond over its reference

  static FixPotdemMonitor *ensure(LAMMPS *);    // null where it is not active

  FixPotdemMonitor(LAMMPS *, int, char **);
  ~FixPotdemMonitor() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void min_pre_exchange() override;
  void post_neighbor() override;
  void end_of_step() override;
  void post_run() override;

  double stiffest_over_mass() const;    // of one spring between a particle and what is held

  // is this spring alone too stiff for the step, between particles of this sum of inverse masses?
  bool too_stiff_for_step(double stiffness, double inverse_masses) const;
  bool pair_too_stiff_for_step(int i, int j, double stiffness) const
  {
    return too_stiff_for_step(stiffness, inverse_mass(i) + inverse_mass(j));
  }
  bool wall_too_stiff_for_step(int i, double stiffness) const
  {
    return too_stiff_for_step(stiffness, inverse_mass(i));
  }

  // warnings
  void warn_of_stiff_pair(const std::string &what, int i, int j, double stiffness);
  void warn_of_stiff_wall(const std::string &wall, int i, double stiffness);
  void warn_of_deep_pair(int i, int j, double fraction);
  void warn_of_deep_wall(const std::string &wall, int i, double fraction);
  void warn_of_crushed_bond(int i, int j, double fraction);

 private:
  enum Reason { CRITICAL, STIFF, DEPTH, CRUSH, JUMP, NREASONS };
  std::array<std::string, NREASONS> said;    // on this rank
  std::unique_ptr<class ComputePotdemTimestep> critical;
  int moving;    // group bits of what a time integration moves by forces

  // a warning is put into words only if it is the first of its kind: loops may ask for it again and again
  template <typename Words> void say(Reason, const Words &words);
  void check_critical();
  void check_skin() const;
  double least_diameter() const;
  int find_moving() const;
  void check_integration() const;
  void refuse_lost(int i) const;
  double inverse_mass(int i) const;    // 0: held
  double steps_of(double stiffness, double inverse_masses) const;
};

}    // namespace LAMMPS_NS

#endif
