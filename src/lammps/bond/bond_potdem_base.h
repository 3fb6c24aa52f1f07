/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What LAMMPS and the other styles see of any bond style of this package (bond_potdem.h). Its parts are the packed bonds
   (potdem_bond_network.h), the sections (potdem_bond_area.h), the energy of the change of volume (potdem_volume_term.h), the
   strengths (potdem_bond_strengths.h) and the bonds that a crack is opening (potdem_softening.h). */

#ifndef LMP_BOND_POTDEM_BASE_H
#define LMP_BOND_POTDEM_BASE_H

#include "core/laws/evaluation.h"
#include "lammps/bond/potdem_bond_area.h"
#include "lammps/bond/potdem_bond_network.h"
#include "lammps/bond/potdem_bond_strengths.h"
#include "lammps/bond/potdem_crack_onset.h"
#include "lammps/bond/potdem_softening.h"
#include "lammps/bond/potdem_volume_term.h"
#include "lammps/glue/interfaces.h"
#include "lammps/glue/potdem_law_io.h"

#include "bond.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class BondPotdemBase :
    public Bond,
    public StiffnessSource,
    public BondMemory,
    public BreakableBonds {
 public:
  BondPotdemBase(class LAMMPS *, const std::string &name, int nstate);
  ~BondPotdemBase() override;
  void init_style() override;
  void reinit() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  double equilibrium_distance(int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_data(FILE *) override;
  double single(int, double, int, int, double &) override;
  void *extract(const char *, int &) override;
  double memory_usage() override;

  void add_stiffness_to(class PotdemStiffness &, double ahead) override;

  bool has_new_bonds() const override;
  void expect_new_bonds() override;
  void masses_changed() override;
  void lose_memory() override;
  bool lost_memory() const override { return lost; }
  void return_state() override;

  bool owns(int type) const override;
  double youngs_modulus(int type) const override { return modulus(type); }
  const std::vector<Listed> &overstretched() const override { return over; }
  double energy_of_bond(int type, double r2, int i, int j) override;
  void expect_cut(int i, tagint partner) override;
  void cut(int i, tagint partner, double r2) override;
  double freed_energy(int type) override { return volume.freed_energy(type); }
  std::vector<Reached> reached_by_cracks(const CrackQuestion &) override;
  const char *cannot_soften(int type) const override;
  void soften(int i, int j, const POTDEM::Softening &) override;
  const std::vector<Listed> &spent() const override { return softening.spent(); }
  double softening_energy(int type) const override { return softening.lost_energy(type); }
  int softening_bonds(int type) const override { return softening.count(type); }

 protected:
  std::string name, style;    // potdem/..., bond_style potdem/...

  // what bond_coeff says beside the law
  struct BesideLaw {
    PotdemBondArea area;
    double xi = 0.0;    // fraction of critical damping
  };
  std::vector<BesideLaw> beside;

  PotdemBondNetwork bonds;
  PotdemVolumeTerm volume;
  PotdemSoftening softening;
  PotdemCrackOnset onset;
  BondStrengths strengths;
  bool any_penetration, damped;
  class FixPotdemLedger *ledger;    // null: no compute potdem/energy

  // the atoms that one thread does, where their forces go, and what it found
  struct ThreadShare {
    int from, to;
    double **f;
    class ThrData *thread;                  // null: no threads
    std::vector<Listed> over;               // bonds that fail
    double energy = 0.0, virial[6] = {};    // unless each atom's are asked for
    int i = -1, j = -1;                     // a bond without length
    int crushed_i = -1, crushed = -1;       // one that is hardly longer: owned atom, packed bond

    void note_collapsed(int atom, int other)
    {
      i = atom;
      j = other;
    }
    void note_crushed(int atom, int bond)
    {
      crushed_i = atom;
      crushed = bond;
    }
  };
  std::vector<Listed> over;

  static ThreadShare share(int from, int to, double **f, double ** /*torque*/,
                           class ThrData *thread)
  {
    return {from, to, f, thread, {}};
  }
  int begin_work();
  void end_work(const std::vector<ThreadShare> &);
  void collect(const ThreadShare &);
  void take_damage(const ThreadShare &);    // what the loop gave to bonds that soften
  void note(int i, int j, double fx, double fy, double fz);
  virtual void tally(const ThreadShare &, int i, int j, double energy, double pull,
                     const double *del);
  bool read_beside(PotdemInput &, BesideLaw &) const;    // one keyword

  // the law's part
  virtual void make_laws(int ntypes) = 0;
  virtual void read(PotdemMaterialInput &, int lo, int hi) = 0;    // coefficients of these types
  virtual PotdemLawRows rows(int type) = 0;
  virtual double modulus(int type) const = 0;
  virtual bool has_penetration(int type) const = 0;
  virtual POTDEM::Evaluation evaluate(int type, double r, double re, double modulus,
                                      const double *state) const = 0;
  virtual void make_kernel(int type) = 0;
  virtual void choose_loop() = 0;    // the smallest that the coefficients and the strengths need
  virtual void work(ThreadShare &) = 0;

 private:
  class FixPotdemBondHistory *history;    // null before the first run, or lost
  bool lost;
  class FixPotdemMonitor *monitor;    // null: nothing to warn of
  int generation;                     // of the bonds' memory, that is packed; -1: none
  bool new_bonds;                     // there may be some since the last run

  // the columns that single() adds, for compute bond/local
  enum { STRAIN, STRESS, SECTION, REFERENCE, DAMAGE, NEXTRA };

  // a coefficient of all types as fix adapt wants it
  struct Adaptable {
    std::string name;
    double *values;
  };
  std::vector<Adaptable> adaptable;

  void allocate();
  std::string coeff_line(int type);                      // as bond_coeff takes it
  double *coeff_named(int type, const std::string &);    // null: no such one
  void show_to_adapt();
  void take_adapted(int type);
  void check_settings() const;
  void find_needs();
  void set_communication();
  void announce_contacts();
  void forget_packed();
  void follow_lists();
  void pack();
  void pack_bond(int i, int n);
  void check_reach(int i, int j, double re) const;
  void measure_new_bonds();
  void find_areas();
  double section(int type, int i, int j, int slot) const;
  POTDEM::Evaluation own_evaluation(int type, double r, int i, int j, int slot);
  void check_solid(int type, double found) const;
  double part_of_volume(int i, int slot, double r2) const;
  const double *state_of(int i, int j, int slot);
  [[noreturn]] void collapsed(int i, int j) const;
  void suspect(int i, int n);
};

}    // namespace LAMMPS_NS

#endif
