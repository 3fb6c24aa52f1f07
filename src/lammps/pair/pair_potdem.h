/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the pair styles of this package share: friction, rotation, diameters, neighbour list, restart, and the
   one loop over pairs (potdem_pair_loop.h). A style derives from PairPotdem<Law> and reads, mixes and prints
   its own coefficients.

   A Law is a trivially copyable struct of coefficients (laws/) with
     Kernel kernel(bool shift) const           the law made ready for the loop, once per init
     double reach(double dbar) const           interaction distance for mean diameter dbar
     contact_only                                  reach is dbar: the short neighbour list by diameters will do
     rate_dependent                                     Kernel has with_rate(force, r, pairing, dr/dt)
   and a Kernel has evaluate(r, pairing) -> Evaluation and hard_core(pairing), the distance that must not be
   reached. */

#ifndef LMP_PAIR_POTDEM_H
#define LMP_PAIR_POTDEM_H

#include "core/laws/contact_geometry.h"
#include "core/laws/evaluation.h"
#include "core/laws/friction.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/pair/potdem_touch.h"

#include "pair.h"

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PotdemInput;

class PairPotdemBase :
    public PotdemCompat::PairWithCutoffsBySize,
    public StiffnessSource,
    public SizedReach,
    public ContactMemory,
    public MonitorUser {
 public:
  PairPotdemBase(class LAMMPS *);
  ~PairPotdemBase() override;
  void init_style() override;
  void settings(int, char **) override;
  double init_one(int, int) override;
  void reset_dt() override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  void write_data(FILE *) override;
  void write_data_all(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;
  void *extract(const char *, int &) override;
  void add_stiffness_to(class PotdemStiffness &, double ahead) override;
  bool outgrown() const override;
  void find_sizes() override;
  double reach_per_size() const override;
  void expect_contacts(const std::vector<PotdemNewContact> &) override;
  void lose_contacts() override;
  void lose_monitor() override { monitor = nullptr; }
  void transfer_history(double *from, double *to, int, int) override { *to = *from; }

  double atom2cut(int) override;
  double radii2cut(double, double) override;

 protected:
  std::vector<POTDEM::Friction> friction;    // per pair of types
  std::vector<double> largest_radius;        // per type
  std::vector<double> least_radius, least_mass;
  std::vector<double>
      alarm;    // per pair of types: distance over dbar below which a pair may have collapsed or be doubtful
  bool sliding, viscous;    // any friction, any viscous part at all
  int rotation;
  class FixPotdemLedger *ledger;        // null: no compute potdem/energy
  class FixPotdemContacts *contacts;    // null: nothing to remember, as no bonds can fail here
  class FixPotdemMonitor *monitor;      // null: nothing to warn of

  // the columns that single() adds, for compute pair/local
  enum { OVERLAP, STIFFNESS, VISCOUS, FRICTION, NEXTRA = FRICTION + 4 };

  int at(int itype, int jtype) const { return itype * (atom_types + 1) + jtype; }
  int atom_types;

  virtual void allocate();
  bool lists_materials(int narg, char **arg) const;
  void coeff_by_material(int narg, char **arg);
  void set_coeff(int ilo, int ihi, int jlo, int jhi, const POTDEM::Friction &);
  POTDEM::ContactGeometry pairing(int i, int j) const;
  POTDEM::ContactGeometry pairing(int i, int j, double begins) const;
  double begins_at(int i, int j) const;

  // the part of the list that one thread does, where its forces go, and what it found
  struct ThreadShare {
    int from, to;
    double **f, **torque;
    class ThrData *thread;                   // null: no threads
    int i = -1, j = -1;                      // a pair that has collapsed
    int doubtful_i = -1, doubtful_j = -1;    // one too deep or too stiff for the step
  };

  PotdemMotion motion() const;
  void note(FixPotdemLedger::Kind, const PotdemTouch &, double share, const double *f);
  void note_torque(const PotdemTouch &, const double *turn);
  virtual void tally(const ThreadShare &, const PotdemTouch &, double energy, const double *f);
  [[noreturn]] void cannot_mix(int i, int j, const std::string &coefficient) const;
  void suspect(ThreadShare &, int i,
               int j) const;    // no address of what the loop keeps in registers
  void report(const ThreadShare &);
  void find_alarm(int i, int j);

  // the style's part
  virtual double with_rate(int pair, double elastic, double r, const POTDEM::ContactGeometry &,
                           double rate) const = 0;
  virtual const char *name() const = 0;
  virtual bool read_setting(PotdemInput &) { return false; }
  virtual const char *setting_names() const { return "rotation"; }
  virtual std::string setting_text() const
  {
    return "";
  }                                        // as pair_style takes it, after a blank
  virtual void work(ThreadShare &) = 0;    // the forces of a part of the list
  virtual void mix(int i, int j) = 0;
  virtual std::string coeff_text(int pair) const = 0;    // as pair_coeff takes it, without friction
  virtual void reread(int pair, PotdemInput &) = 0;      // coefficients with friction
  virtual double *coeff_of_law(int pair, const std::string &) = 0;    // null: no such one
  virtual bool contact_only() const = 0;
  virtual bool any_viscous() const = 0;
  virtual double reach(int i, int j, double dbar) const = 0;
  virtual double hard_core(int pair, const POTDEM::ContactGeometry &) const = 0;
  virtual POTDEM::Evaluation evaluate(int pair, double r,
                                      const POTDEM::ContactGeometry &) const = 0;

 private:
  double monitored_step;    // for which the alarms are set
  std::string contacts_id;
  bool lost_contacts;

  // a coefficient of all pairs of types as fix adapt wants it
  struct Adaptable {
    std::string name;
    double **values;
  };
  std::vector<Adaptable> adaptable;

  void add_announced_radii(std::vector<double> &largest) const;
  [[noreturn]] void collapsed(int i, int j) const;
  double distance(int i, int j) const;
  bool is_deep(int pair, const POTDEM::ContactGeometry &, double r) const;
  double stiff_from(int i, int j, double ri, double rj) const;
  double without_particles() const;
  void find_contacts();
  void find_needs();
  double closest(const PotdemMotion &, const PotdemTouch &, double most, double ahead) const;
  struct PotdemSpring spring(const PotdemTouch &, double r, double weight) const;
  double sticking_viscosity(int pair, double r, const POTDEM::ContactGeometry &) const;
  void dissipative(int pair, PotdemTouch, double elastic, double weight);
  void mix_friction(int i, int j);
  void leave_to_mixing(int i, int j);
  std::string coeff_line(int pair) const;
  double *coeff_named(int pair, const std::string &name);
  void show_to_adapt();
  void take_adapted(int i, int j);
};

template <class Law> class PairPotdem : public PairPotdemBase {
 public:
  using PairPotdemBase::PairPotdemBase;
  void compute(int, int) override;
  void coeff(int, char **) override;
  double init_one(int, int) override;

 protected:
  std::vector<Law> laws;
  std::vector<typename Law::Kernel> kernels;

  void work(ThreadShare &) override;
  Law read(PotdemInput &, POTDEM::Friction &) const;
  virtual void prepare(Law &) const {}    // what pair_style itself says about a law
  void allocate() override;
  std::string coeff_text(int pair) const override;
  void reread(int pair, PotdemInput &) override;
  double *coeff_of_law(int pair, const std::string &) override;
  bool contact_only() const override { return Law::contact_only; }
  bool any_viscous() const override;
  double reach(int i, int j, double dbar) const override { return laws[at(i, j)].reach(dbar); }
  double hard_core(int pair, const POTDEM::ContactGeometry &pairing) const override
  {
    return kernels[pair].hard_core(pairing);
  }
  POTDEM::Evaluation evaluate(int pair, double r,
                              const POTDEM::ContactGeometry &pairing) const override
  {
    return kernels[pair].evaluate(r, pairing);
  }
  double with_rate(int pair, double elastic, double r, const POTDEM::ContactGeometry &partners,
                   double rate) const override
  {
    if constexpr (Law::rate_dependent) return kernels[pair].with_rate(elastic, r, partners, rate);
    return elastic;
  }

 private:
  template <bool EV> void choose(ThreadShare &);
  template <bool SLIDE, bool SPIN, bool EV> void choose_rate(ThreadShare &);
  template <bool SLIDE, bool SPIN, bool RATE, bool EV> void loop(ThreadShare &);
  template <bool SPIN>
  void add_friction(const ThreadShare &, const PotdemMotion &, const PotdemTouch &,
                    const POTDEM::Friction &, double normal, double *push);
};

}    // namespace LAMMPS_NS

#endif
