/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* A run that continues from a restart file written within a run (command restart) goes on as the run that wrote it, to the last
   bit. LAMMPS finds the forces of the first step anew, but from other numbers than the run did: there they were found with
   velocities in the middle of the step and before a fix changed the timestep, and from particles in another order. So this fix

   - has the particles sorted on the steps on which a file is written, as they are when a run begins,
   - keeps in the file the velocities with which the forces of that step were found, and its timestep,
   - gives them to the particles while a run that continues finds its first forces.

   A particle whose velocity was changed after the file was read keeps its own. */

#ifndef LMP_FIX_POTDEM_RESUME_H
#define LMP_FIX_POTDEM_RESUME_H

#include "fix_store_atom.h"

namespace LAMMPS_NS {

class FixPotdemResume : public FixStoreAtom {
 public:
  static void
  ensure(LAMMPS *);    // at the init of a style: there if a file may be written or was read
  static bool resumes(LAMMPS *);    // while a run is set up that continues one from within

  FixPotdemResume(LAMMPS *, int, char **);
  int setmask() override;
  void setup_pre_exchange() override;
  void setup(int) override;
  void pre_exchange() override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  bool resuming;
  bigint written;         // step within which the file that was read was written, or -1
  double step, coming;    // timestep: of the forces in the file, of the run that continues

  bool writes_now() const;
  void exchange_velocities();
};

}    // namespace LAMMPS_NS

#endif
