/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_WALL_REGION_H
#define LMP_FIX_POTDEM_WALL_REGION_H

#include "laws/friction.h"
#include "laws/hertz_wall.h"

#include "fix.h"

#include <string>

namespace LAMMPS_NS {

class FixPotdemWallRegion : public Fix {
 public:
  FixPotdemWallRegion(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;

 private:
  std::string region_id;
  class Region *region;
  class PotdemLedger *ledger;    // null: no compute potdem/energy
  POTDEM::HertzWall law;
  POTDEM::Friction friction;
  double viscosity;    // H of eq. 5.17, time

  double mine[7], total[7];    // energy, force and torque of the particles on the wall
  bool summed;

  typedef void (FixPotdemWallRegion::*Kernel)();
  Kernel kernel;

  void read(int, char **);
  template <bool SLIDE, bool VISCOUS> void push_all();
  template <bool SLIDE, bool VISCOUS> void push(int i, int contact);
  void rub(int i, const double *n, double normal, const double *sliding, double *drag) const;
  void book(int i, const double *n, double viscous, const double *drag, double normal,
            const double *wall);
  double sum(int);
};

}    // namespace LAMMPS_NS

#endif
