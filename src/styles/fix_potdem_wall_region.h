/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_WALL_REGION_H
#define LMP_FIX_POTDEM_WALL_REGION_H

#include "laws/friction.h"
#include "laws/wall.h"

#include "fix.h"

#include <string>
#include <variant>

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
  std::variant<POTDEM::LayeredHertzWall, POTDEM::LawWall<POTDEM::ShiftedLJ>,
               POTDEM::LawWall<POTDEM::RegularisedGranular>, POTDEM::LawWall<POTDEM::TrussContact>>
      law;
  POTDEM::Friction friction;
  double viscosity;    // H of eq. 5.17, time

  double mine[7], total[7];    // energy, force and torque of the particles on the wall
  bool summed;

  void read(int, char **);
  void read_hertz(class PotdemInput &);
  bool read_hertz_option(class PotdemInput &);
  template <class Law> void read_wall(class PotdemInput &);
  void read_common(class PotdemInput &, const char *names);

  template <class Wall> void push_with(const Wall &);
  template <bool SLIDE, bool VISCOUS, class Wall> void push_all(const Wall &);
  template <bool SLIDE, bool VISCOUS, class Wall> void push(int i, int contact, const Wall &);
  void rub(int i, const double *n, double normal, const double *sliding, double *drag) const;
  void book(int i, const double *n, double viscous, const double *drag, double normal,
            const double *wall);
  double sum(int);
};

}    // namespace LAMMPS_NS

#endif
