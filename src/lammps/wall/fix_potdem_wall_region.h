/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_FIX_POTDEM_WALL_REGION_H
#define LMP_FIX_POTDEM_WALL_REGION_H

#include "core/contact/contact.h"
#include "core/laws/hertz_wall.h"
#include "core/laws/law_list.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_friction.h"
#include "lammps/glue/potdem_rate.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/wall/potdem_wall_memory.h"
#include "lammps/wall/potdem_wall_surface.h"

#include "fix.h"

#include <array>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace LAMMPS_NS {

// a law made ready for a wall
template <class Law> struct PotdemWallLaw {
  Law law;
  typename Law::Kernel kernel;

  double reach(double ri) const { return law.reach(ri); }
  POTDEM::WallGeometry geometry(double ri) const
  {
    return {ri, Law::contact_only ? law.reach(ri) : ri};
  }
};

class FixPotdemWallRegion : public Fix, public StiffnessSource, public EnergySource {
 public:
  FixPotdemWallRegion(class LAMMPS *, int, char **);
  ~FixPotdemWallRegion() override;
  void post_constructor() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  void add_stiffness_to(class PotdemStiffness &, double ahead) override;
  void add_energy_to(PotdemEnergies &) override;

 protected:
  virtual int threads() const { return 1; }

 private:
  // a particle that touches a face
  struct Touch {
    double n[3], r;                  // off the wall, and how far the centre is from the surface
    double del[3];                   // from the foot there to the centre
    POTDEM::ContactMotion motion;    // along n, for a distance of 1
    double normal;                   // force along n
    POTDEM::Pressed pressed;
    POTDEM::SurfaceForces surface;
    double wall[3], wall_spin[3];    // velocity of the surface at the foot, and how fast it turns
    double wall_between[3];          // its velocity between this step and the one before
    int key;                         // of the face

    Touch() {}    // only what the kernel needs is set
  };

  // what one thread finds, and where it works
  struct ThreadShare {
    double sums[7], virial[6];    // energy, force and torque of the particles on the wall
    double power, slip[FixPotdemLedger::NKINDS];    // for the ledger
    struct Suspect {
      int i;
      double nearness, stiffness;
    };
    std::vector<Suspect> suspects;
    std::vector<int> passed;     // a plane: the region must say what that means
    std::exception_ptr error;    // what cannot leave a thread
    std::vector<PotdemWallSurface::Face> faces;
    std::vector<Touch> touches;    // of one particle
    std::vector<int> keys;         // of their faces

    void begin();
  };
  std::vector<ThreadShare> shares;

  std::string region_id;
  class Region *region;
  PotdemWallSurface surface;
  std::vector<double> way_in_file;    // of the surface, until the region is known
  class FixPotdemLedger *ledger;      // null: no compute potdem/energy
  class FixPotdemMonitor *monitor;    // null: nothing to warn of
  double too_stiff, too_near;    // stiffness over mass, distance over radius: to be looked at twice
#define POTDEM_WALL_OF_LAW(name, Law) , PotdemWallLaw<POTDEM::Law>
  std::variant<PotdemWallLaw<POTDEM::HertzWall> CONTACT_LAWS(POTDEM_WALL_OF_LAW)> law;
#undef POTDEM_WALL_OF_LAW
  PotdemRate rate;
  PotdemFriction friction;
  typedef std::function<void(int i, ThreadShare &)> FrictionKernel;
  FrictionKernel friction_kernel;
  const FrictionKernel *rub;                   // null: no friction
  std::unique_ptr<PotdemWallMemory> memory;    // null: friction remembers nothing
  bool rotation;
  double inertia;    // of a particle that spins, over m r^2
  double step;       // in which mass over it is force over velocity

  // between two neighbour lists: only these may touch the wall
  struct NearPlanes {
    int i;
    bool remembers;    // of its memory, which is far away
    PotdemWallSurface::Planes which;
  };
  std::vector<NearPlanes> near_planes;
  std::vector<int> near;                        // anything else
  std::vector<std::array<double, 3>> images;    // of one particle
  bigint listed;    // step of the neighbour list that they belong to; -1: none, all may

  double mine[7], total[7];    // energy, force and torque of the particles on the wall
  bool summed;

  void read(int, char **);
  void read_named(class PotdemMaterialInput &);
  template <class Law> void read_wall(class PotdemMaterialInput &);
  void read_common(class PotdemMaterialInput &, const std::string &names);
  void read_rotation(class PotdemInput &);
  void check_rotation();

  template <bool MOTION> void act(int vflag);
  void gather(const ThreadShare &);
  bool is_listed() const;
  bool can_be_listed() const;
  template <class Wall> void list_near(const Wall &);
  void find_images(const double *x);
  template <class Law, class Rate> void choose(const PotdemWallLaw<Law> &, const Rate &);
  template <bool SLIDE, bool MOVE, class Wall, class Rate>
  void push_all(const Wall &, const Rate &);
  template <bool SLIDE, bool MOVE, class Wall, class Rate>
  void push_from_planes(const Wall &, const Rate &);
  template <bool SLIDE, bool MOVE, class Wall, class Rate>
  void push_part(int part, const Wall &, const Rate &);
  template <bool SLIDE, bool MOVE, class Wall, class Rate>
  void push_near(NearPlanes &, const Wall &, const Rate &, ThreadShare &);
  bool remembers(int i) const
  {
    return memory && !memory->is_empty(i);
  }
  template <bool SLIDE, bool MOVE, class Wall, class Rate>
  void push(int i, const Wall &, const Rate &);
  template <bool SLIDE, bool MOVE, class Wall, class Rate>
  void push(int i, const std::vector<PotdemWallSurface::Face> &, const Wall &, const Rate &,
            ThreadShare &);
  template <class Wall>
  const std::vector<PotdemWallSurface::Face> *faces_at(const double *x, const Wall &, double ri,
                                                       double further);
  [[noreturn]] void passed(int i, const double *x) const;
  template <bool MOVE, class Wall, class Rate>
  bool normal_force(int i, const PotdemWallSurface::Face &, const Wall &, const Rate &, Touch &,
                    ThreadShare &);
  template <bool SPIN, class Tangential>
  void add_friction(int i, const Tangential &, const Tangential &alone, ThreadShare &);
  template <bool SPIN, class Tangential>
  void rub_face(int i, const Tangential &, double *state, Touch &, ThreadShare &);
  void follow_faces(int i, ThreadShare &);
  template <bool SPIN> POTDEM::ContactMotion motion_over_step(int i, const Touch &) const;
  void turn(int i, const double *torque);
  FrictionKernel make_friction_kernel();
  template <bool SPIN>
  void hold_at_rest(int i, const POTDEM::Sliding &, std::vector<Touch> &) const;
  void note(int i, const Touch &, double viscous, ThreadShare &) const;
  void bring_back(double *x) const;
  bool out_of_plane(int i, const PotdemWallSurface::Face &) const;
  void book(int i, const Touch &, const double *f, ThreadShare &);
  void find_motion(int i, const PotdemWallSurface::Face &, Touch &) const;
  double spin_share(double r_over_ri) const;
  POTDEM::ContactMasses masses_of(int i, double r_over_ri) const;
  template <class Wall> void add_stiffness_of(const Wall &, class PotdemStiffness &, double ahead);
  template <class Wall>
  double closest(int i, const PotdemWallSurface::Face &, double ahead, const Wall &) const;
  template <class Wall>
  POTDEM::Spring spring(int i, const PotdemWallSurface::Face &, double r, const Wall &) const;
  void suspect(int i, double nearness, double stiffness) const;
  double sum(int);
};

}    // namespace LAMMPS_NS

#endif
