/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_WALL_REGION_H
#define LMP_FIX_POTDEM_WALL_REGION_H

#include "core/laws/friction.h"
#include "core/laws/wall.h"
#include "lammps/glue/interfaces.h"
#include "lammps/wall/potdem_wall_surface.h"

#include "fix.h"

#include <string>
#include <variant>
#include <vector>

namespace LAMMPS_NS {

class FixPotdemWallRegion : public Fix, public StiffnessSource, public EnergySource {
 public:
  FixPotdemWallRegion(class LAMMPS *, int, char **);
  void post_constructor() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;

  void add_stiffness_to(class PotdemStiffness &, double ahead) override;
  Term energy_term() const override { return WALLS; }
  double energy() override { return compute_scalar(); }

 private:
  // a particle that touches a face
  struct Touch {
    double n[3];       // off the wall
    double arm[3];     // from the centre to the foot on the surface
    double normal;     // force
    double wall[3];    // velocity of the surface at the foot
    double drag[3];    // friction
  };

  std::string region_id;
  class Region *region;
  PotdemWallSurface surface;
  class FixPotdemLedger *ledger;      // null: no compute potdem/energy
  class FixPotdemMonitor *monitor;    // null: nothing to warn of
  double too_stiff, too_near;    // stiffness over mass, distance over radius: to be looked at twice
  std::variant<POTDEM::LayeredHertzWall, POTDEM::LawWall<POTDEM::ShiftedLJ>,
               POTDEM::LawWall<POTDEM::RegularisedGranular>, POTDEM::LawWall<POTDEM::TrussContact>>
      law;
  POTDEM::Friction friction;
  double viscosity;    // H of eq. 5.17, time
  bool rotation;
  double inertia;                // of a particle that spins, over m r^2
  std::vector<Touch> touches;    // of one particle

  double mine[7], total[7];    // energy, force and torque of the particles on the wall
  bool summed;

  void read(int, char **);
  void read_hertz(class PotdemInput &);
  bool read_hertz_option(class PotdemInput &);
  template <class Law> void read_wall(class PotdemInput &);
  void read_common(class PotdemInput &, const char *names);
  void read_rotation(class PotdemInput &);
  void check_rotation();

  template <bool MOTION> void act(int vflag);
  template <bool MOTION, class Wall> void push_with(const Wall &);
  template <bool SLIDE, bool SPIN, bool VISCOUS, class Wall> void push_all(const Wall &);
  template <bool SLIDE, bool VISCOUS, class Wall>
  bool normal_force(int i, const PotdemWallSurface::Face &, const Wall &, Touch &);
  template <bool SPIN> void add_friction(int i);
  template <bool SPIN> void hold_at_rest(int i);
  template <bool SPIN> void sliding(int i, const Touch &, double *u) const;
  void bring_back(double *x) const;
  bool out_of_plane(int i, const PotdemWallSurface::Face &) const;
  void add(int i, const Touch &, const double *f);
  template <class Wall> void stiffen_with(const Wall &, class PotdemStiffness &, double ahead);
  template <class Wall>
  double closest(int i, const PotdemWallSurface::Face &, double ahead, const Wall &) const;
  template <class Wall>
  struct PotdemSpring spring(int i, const PotdemWallSurface::Face &, double r, const Wall &) const;
  void suspect(int i, double nearness, double stiffness) const;
  double sum(int);
};

}    // namespace LAMMPS_NS

#endif
