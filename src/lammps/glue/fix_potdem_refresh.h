/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Keeps true in a run what styles have derived from the particles at set-up: cutoffs and alarms from the diameters,
   how far ghosts reach and which sections are missing from the bonds. It looks before each rebuild of the
   neighbour lists, after all other fixes, so that particles and bonds that come have their forces at once; and where
   diameters grow, it has lists rebuilt before they miss a contact. Nothing is reduced over ranks but one word,
   unless something has changed. Created by the pair styles and the bond style, one per simulation; without state. */

#ifndef LMP_FIX_POTDEM_REFRESH_H
#define LMP_FIX_POTDEM_REFRESH_H

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

class FixPotdemRefresh : public Fix {
 public:
  static void ensure(LAMMPS *);    // at the init of a style: there, and the last of all fixes

  FixPotdemRefresh(LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void post_integrate() override;
  void pre_exchange() override;
  void setup_post_neighbor() override;
  void post_neighbor() override;
  void pre_force(int) override;
  double memory_usage() override;

 private:
  std::vector<class SizedReach *> sized;
  std::vector<class BondMemory *> bonds;

  // where diameters may change within a run: the state for which the lists were built
  std::vector<double> radius_then, mass_then;
  double box_then[6];
  double growth,
      largest_jump;    // of a radius: since the lists were built, in one step of this run
  double moved;        // furthest particle since the lists were built
  bool warned;

  void renew_cutoffs();
  double box_change() const;
  double of_skin(double growth) const;
  void warn_of_jump();
};

}    // namespace LAMMPS_NS

#endif
