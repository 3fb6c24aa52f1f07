/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_BOND_POTDEM_TRUSS_H
#define LMP_BOND_POTDEM_TRUSS_H

#include "core/laws/evaluation.h"
#include "core/laws/penetration.h"
#include "core/laws/strength_scatter.h"

#include "lammps/glue/interfaces.h"

#include "bond.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class BondPotdemTruss : public Bond, public StiffnessSource, public BondMemory {
 public:
  BondPotdemTruss(class LAMMPS *);
  ~BondPotdemTruss() override;
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

  static BondPotdemTruss *find(class LAMMPS *);    // the style in use, on threads or not; or null

  // for fix potdem/failure. Strengths are stresses, < 0: none; they hold until the next init(), which asks
  // the fixes for them.
  double modulus(int type) const { return coeffs[type].E; }
  void set_strength(int type, double ft, double fc, const POTDEM::StrengthScatter &);

  struct Overstretched {
    int i, n;    // owned atom, packed bond
  };
  const std::vector<Overstretched> &overstretched() const { return over; }
  int partner(int n) const { return bonds.partner[n]; }
  int type(int n) const { return bonds.type[n]; }
  void refresh();    // follow the latest rebuild of the bond list
  bool has_new_bonds() const override;
  void expect_new_bonds() override;
  void masses_changed() override { generation = -1; }
  void lose_memory() override;
  bool lost_memory() const override { return lost; }
  void cut(int i, tagint partner);    // no force from here on

  void add_stiffness_to(class PotdemStiffness &, double ahead) override;

 protected:
  enum AreaMode { FACTOR, LATTICE, BODY };

  struct Coeff {
    double E;
    int mode;
    double area;    // FACTOR: a; BODY: density or 0
    int m;          // 0: no non-penetration factor
    int normalized;
    double xi;    // fraction of critical damping
  };

  // Bonds grouped by their owned atom, in LAMMPS's order; first the partners that are owned too, then
  // the ghosts, whose rank computes the same bond for itself.
  struct Packed {
    std::vector<int> first, ghosts;    // per owned atom: first bond, first with a ghost partner
    std::vector<int> partner, type, listed;    // per bond; listed: place in neighbor->bondlist
    std::vector<double> inverse_length2, half_modulus, dashpot;    // 1/re^2, A E/2
    std::vector<double> strength;                                  // over that of the type
  };

  std::vector<Coeff> coeffs;
  std::vector<POTDEM::Penetration> factors;
  std::vector<double> tension, compression;    // per type: load 2 c eps at failure
  std::vector<POTDEM::StrengthScatter> scatter;
  enum Failing { NEVER, BY_TYPE, BY_BOND } failing;
  bool has_penetration, damped;
  Packed bonds;
  std::vector<Overstretched> over;

  class FixPotdemBondHistory *history;    // null before the first run, or lost
  bool lost;
  class FixPotdemLedger *ledger;      // null: no compute potdem/energy
  class FixPotdemMonitor *monitor;    // null: nothing to warn of
  int generation;
  bool new_bonds;    // there may be some since the last run
  double longest;

  // the atoms that one thread does, where their forces go, and what it found
  struct ThreadShare {
    int from, to;
    double **f;
    class ThrData *thread;               // null: no threads
    std::vector<Overstretched> over;     // bonds that fail
    int i = -1, j = -1;                  // a bond without length
    int crushed_i = -1, crushed = -1;    // one that is hardly longer: owned atom, packed bond
  };
  typedef void (BondPotdemTruss::*Kernel)(ThreadShare &);
  Kernel quiet, tallied;

  // the columns that single() adds, for compute bond/local
  enum { STRAIN, STRESS, SECTION, REFERENCE, NEXTRA };

  // a coefficient of all types as fix adapt wants it
  struct Adaptable {
    std::string name;
    double *values;
  };
  std::vector<Adaptable> adaptable;

  void allocate();
  Coeff read(class PotdemMaterialInput &) const;
  std::string coeff_line(int type) const;
  double *coeff_named(int type, const std::string &);    // null: no such one
  void show_to_adapt();
  void take_adapted(int type);
  void find_needs();
  void set_communication();
  void announce_contacts();
  void pack();
  bool is_ours(int type) const;
  void order_bonds();
  void check_reach(int i, int j, double re) const;
  double section(int type, int i, int slot) const;
  void measure_new_bonds();
  void find_areas();
  bool lacks_section(int type, int i, int slot) const;
  void find_lattice(int type);
  struct LatticeFound {
    double section;    // 0: not a lattice that we know
    double nearest, bonds;
  };
  LatticeFound read_lattice(int type, int i) const;
  double section_of_lattice(int type) const;
  bigint give_section(int type, double);
  bool centred(int type, int i, double spacing) const;
  POTDEM::Evaluation law(int type, double r, double re, double modulus) const;
  double energy_at(int n, double q) const;

  void choose_kernels();
  template <bool HINDER, bool DAMP> void choose();
  template <int FAIL, bool HINDER, bool DAMP> void choose();
  template <bool EV, int FAIL, bool HINDER, bool DAMP> void kernel(ThreadShare &);
  void note(int i, int j, double fx, double fy, double fz);
  void work(ThreadShare &);
  void collect(const ThreadShare &);
  [[noreturn]] void collapsed(int i, int j) const;
  void suspect(int i, int n) const;
  virtual void tally(const ThreadShare &, int i, int j, double energy, double push,
                     const double *del);
};

}    // namespace LAMMPS_NS

#endif
