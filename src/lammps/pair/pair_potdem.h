/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* pair_style potdem/NAME for a normal law (core/laws/law_list.h), with a rate law where the law allows one, and any tangential
   law: their coefficients by their tables (pair_potdem_coeff.h), what one pair does (pair_potdem_contact.h), and the one loop
   over pairs (pair_potdem_loop.h).

   A law is a trivially copyable struct of coefficients with
     coefficients(), complete(), mixed()       core/laws/coefficients.h
     double reach(double dbar) const           interaction distance for mean diameter dbar
     contact_only                              reach is dbar: the short neighbour list by diameters will do; it only repels
     rate_dependent                            'viscous H' may act beside it
     wide                                      (optional) its Kernel has no branches, and so makes vector instructions
     Kernel kernel(bool shift) const           the law made ready for the loop, once per init
   and a Kernel has evaluate(r, geometry) -> Evaluation and hard_core(geometry), the distance that must not be reached. */

#ifndef LMP_PAIR_POTDEM_H
#define LMP_PAIR_POTDEM_H

#include "core/contact/contact_batch.h"
#include "core/laws/law_list.h"
#include "lammps/glue/potdem_friction.h"
#include "lammps/glue/potdem_rate.h"
#include "lammps/pair/pair_potdem_base.h"

namespace LAMMPS_NS {

template <class Law> class PairPotdem : public PairPotdemBase {
 public:
  PairPotdem(class LAMMPS *);
  ~PairPotdem() override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void reset_dt() override;
  void compute(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  void write_data(FILE *) override;
  void write_data_all(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;
  void *extract(const char *, int &) override;
  void transfer_history(double *, double *, int, int) override;
  void add_stiffness_to(class PotdemStiffness &, double ahead) override;
  void add_energy_to(PotdemEnergies &) override;

 protected:
  using Kernel = typename Law::Kernel;

  int begin_work();
  void work(ThreadShare &);    // the forces of a part of the list
  void end_work(const std::vector<ThreadShare> &);

 private:
  // per pair of types
  std::vector<Law> laws;
  std::vector<bool> law_mixed;    // given, but for the law itself
  std::vector<PotdemRate> rates;
  std::vector<PotdemFriction> friction;
  std::vector<Kernel> kernels;
  std::vector<double>
      alarm;    // distance over dbar below which a pair may have collapsed or be doubtful

  PotdemRate of_style;          // what pair_style itself says about rates
  PotdemRates dashpots;         // those of the one law in use, once it is known
  PotdemFrictions frictions;    // likewise
  bool kernel_known;
  bool sliding, viscous;    // any friction, any viscous part at all
  static constexpr int WIDE = 16;
  POTDEM::Width width;      // of the machine's registers
  double monitored_step;    // for which the alarms are set

  // a coefficient of all pairs of types as fix adapt wants it
  struct Adaptable {
    std::string name;
    double **values;
  };
  std::vector<Adaptable> adaptable;

  // the columns that single() adds, for compute pair/local
  enum { OVERLAP, STIFFNESS, VISCOUS, FRICTION, SLIDES = FRICTION + 4, ROLLING, TWISTING, NEXTRA };

  const char *name() const override;
  double reach(int i, int j, double dbar) const override { return laws[at(i, j)].reach(dbar); }
  double hard_core(int i, int j) const;

  // coefficients
  void allocate();
  bool lists_materials(int narg, char **arg) const;
  void coeff_by_material(int narg, char **arg);
  void leave_to_mixing(int i, int j);
  void read(PotdemMaterialInput &, int pair);
  void mix(int i, int j);
  void mix_law(int i, int j);
  void mirror(int i, int j);
  std::string coeff_line(int pair) const;
  double *coeff_named(int pair, const std::string &name);
  double *velocity_coeff_named(int pair, const std::string &name);
  void show_to_adapt();
  void take_adapted(int i, int j);
  void find_needs();

  // one pair
  void find_alarm(int i, int j);
  double stiff_from(int i, int j, double ri, double rj) const;
  static bool is_deep(const Kernel &, double r, const POTDEM::ContactGeometry &);
  // by value: no address of what the loop keeps in registers
  void suspect(ThreadShare &, int i, int j, double r, POTDEM::ContactGeometry) const;
  POTDEM::ContactMotion motion(int i, int j) const;
  POTDEM::ContactMasses masses(int i, int j, double arm) const;
  void dissipative(int pair, int i, int j, double r, double weight);
  double closest(int i, int j, const POTDEM::ContactMotion &, double most, double ahead) const;
  POTDEM::Spring spring(int i, int j, const POTDEM::ContactMotion &, double r, double weight) const;

  // the loop
  void find_kernel();
  void report(const ThreadShare &);
  template <class Tangential> void choose(ThreadShare &, const std::vector<Tangential> &);
  template <class Tangential, bool SPIN, bool EV>
  void choose_rate(ThreadShare &, const Tangential *);
  template <class Tangential, class Rate, bool SPIN, bool EV>
  void loop(ThreadShare &, const Tangential *, const Rate *);
  bool is_collapsed(ThreadShare &, int i, int j, double r, POTDEM::ContactGeometry) const;

  // arrays of particles
  struct Particles {
    const double (*x)[3], (*v)[3], (*omega)[3], *radius, *rmass;
    const int *type;
    double (*f)[3], (*torque)[3];
    int nlocal, newton;

    Particles(const class Atom *, const ThreadShare &, int newton);
  };

  // whose contacts a batch has
  template <int LANES> struct Lanes {
    int n = 0;    // in use
    int i[LANES], j[LANES];
    double *state[LANES];
    int current = -1;    // particle whose force is being summed up
    double force[3] = {0.0, 0.0, 0.0};

    void add_force(double (*f)[3])
    {
      for (int k = 0; k < 3; k++) {
        if (current >= 0) f[current][k] += force[k];
        force[k] = 0.0;
      }
    }
  };

  template <class Batch> static void gather_motion(Batch &, const Particles &, int i, int j, int l);
  template <bool EV, class Batch, class Owners>
  void take(ThreadShare &, const Particles &, const Batch &, Owners &);
  template <class Batch>
  static void take_torques(const Particles &, const Batch &, int i, int j, bool to_both, int l);
  template <class Batch> void book(const Batch &, int i, int j, int l) const;
};

}    // namespace LAMMPS_NS

#endif
