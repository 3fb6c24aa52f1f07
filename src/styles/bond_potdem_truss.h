/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_BOND_POTDEM_TRUSS_H
#define LMP_BOND_POTDEM_TRUSS_H

#include "laws/evaluation.h"
#include "laws/penetration.h"

#include "bond.h"

#include <vector>

namespace LAMMPS_NS {

class BondPotdemTruss : public Bond {
 public:
  BondPotdemTruss(class LAMMPS *);
  ~BondPotdemTruss() override;
  void init_style() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  double equilibrium_distance(int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_data(FILE *) override;
  double single(int, double, int, int, double &) override;
  double memory_usage() override;

  // for fix potdem/failure. Strengths are stresses, < 0: none; they hold until the next init().
  double modulus(int type) const { return coeffs[type].E; }
  void set_strength(int type, double tension, double compression);

  struct Overstretched {
    int i, n;    // owned atom, packed bond
  };
  const std::vector<Overstretched> &overstretched() const { return over; }
  int partner(int n) const { return bonds.partner[n]; }
  int type(int n) const { return bonds.type[n]; }
  void refresh();                     // follow the latest rebuild of the bond list
  void cut(int i, tagint partner);    // no force from here on

 protected:
  enum AreaMode { FACTOR, LATTICE };

  struct Coeff {
    double E;
    int mode;
    double area;    // FACTOR: a; LATTICE: the section itself, 0 until the lattice is known
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
  };

  std::vector<Coeff> coeffs;
  std::vector<POTDEM::Penetration> factors;
  std::vector<double> tension2, compression2;    // (r/re)^2 at failure
  bool breakable, hindered, damped;
  Packed bonds;
  std::vector<Overstretched> over;

  class PotdemBondStore *bond_store;
  class PotdemLedger *ledger;    // null: no compute potdem/energy
  int generation;
  double longest, cutghost_own;

  typedef void (BondPotdemTruss::*Kernel)();
  Kernel quiet, tallied;

  void allocate();
  void set_communication();
  double estimate_longest() const;
  void pack();
  void order_bonds();
  void check_reach(int i, int j, double re) const;
  double section(int type, int i, int slot) const;
  void find_lattice(int type);
  void lattice_section(int type, int i, double *found) const;
  bool centred(int type, int i, double spacing) const;
  POTDEM::Evaluation law(int type, double r, double re, double modulus) const;
  double energy_at(int n, double q) const;

  void choose_kernels();
  template <bool HINDER, bool DAMP> void choose();
  template <bool EV, bool FAIL, bool HINDER, bool DAMP> void kernel();
  void note(int i, int j, double fx, double fy, double fz);
  [[noreturn]] void collapsed(int i, int j, double r2) const;
  void tally(int i, int j, int n, double q, double pull, double dx, double dy, double dz);
};

}    // namespace LAMMPS_NS

#endif
