/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The bond styles of this package: BondPotdem<Law>, one for each row of BOND_LAWS in core/laws/law_list.h. Here is what knows
   the law: its coefficients, its kernels, and the loop (bond_potdem_loop.h). */

#ifndef LMP_BOND_POTDEM_H
#define LMP_BOND_POTDEM_H

#include "core/laws/four.h"
#include "core/laws/law_list.h"
#include "core/laws/width.h"
#include "lammps/bond/bond_potdem_base.h"
#include "lammps/output/fix_potdem_monitor.h"

#include <vector>

namespace LAMMPS_NS {

template <class Law> class BondPotdem : public BondPotdemBase {
 public:
  BondPotdem(class LAMMPS *);

 protected:
  void make_laws(int ntypes) override;
  void read(PotdemMaterialInput &, int lo, int hi) override;
  PotdemLawRows rows(int type) override;
  double modulus(int type) const override { return laws[type].E; }
  bool has_penetration(int type) const override;
  POTDEM::Evaluation evaluate(int type, double r, double re, double modulus,
                              const double *state) const override
  {
    return kernels[type].evaluate(r, re, modulus, state);
  }
  void make_kernel(int type) override { kernels[type] = laws[type].kernel(); }
  void choose_loop() override;
  void work(ThreadShare &share) override
  {
    (this->*(evflag ? tallied : quiet))(share);
    take_damage(share);
  }

 private:
  std::vector<Law> laws;
  std::vector<typename Law::Kernel> kernels;

  typedef void (BondPotdem::*Loop)(ThreadShare &);
  Loop quiet, tallied;

  template <bool PENETRATION> void choose();
  template <bool PENETRATION, bool DAMP> void choose();
  template <int FAIL, bool PENETRATION, bool DAMP> void choose();
  template <bool EV, int FAIL, bool PENETRATION, bool DAMP> Loop loop_for_machine();

  // what the loop reads and where its forces go
  struct Inputs {
    const double (*x)[3], (*v)[3];
    const int *partner;
    const PotdemBondNetwork::Type *type;
    const double *inverse_length2, *half_modulus, *dashpot, *scale;
    const POTDEM::Strength *strength;
    const typename Law::Kernel *kernel;
    const double *const *roots, *weight_here,
        *weight_there;    // of the volume term; roots null: none
    double (*f)[3];
    bool energy, virial, of_atoms;    // asked for, perhaps of each atom

    Inputs(BondPotdem &, double **forces);
  };
  // what LAMMPS asks of one thread's bonds as a whole, summed up one by one or four at a time
  template <class Number> struct Sums {
    Number energy{}, virial[6]{};

    void add(const Inputs &, const Number &owned, const Number &energy, const Number &pull,
             const Number *del);
    void add_to(ThreadShare &) const;
  };
  static constexpr double CRUSHED = FixPotdemMonitor::CRUSHED * FixPotdemMonitor::CRUSHED;

  template <bool EV, int FAIL, bool PENETRATION, bool DAMP> void loop(ThreadShare &);
  template <bool EV, int FAIL, bool PENETRATION, bool DAMP> void loop_over(ThreadShare &);
  template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
  bool take(const Inputs &, ThreadShare &, int i, int n, int ghosts, double *force, Sums<double> &);
#ifdef POTDEM_WIDE_CODE
  template <bool EV, int FAIL, bool PENETRATION, bool DAMP> void loop_avx2(ThreadShare &);
#endif
#ifdef POTDEM_HAS_FOUR
  template <bool EV, int FAIL, bool PENETRATION, bool DAMP>
  bool take_four(const Inputs &, const ThreadShare &, int i, int n, int ghosts,
                 POTDEM::Four3 &force, Sums<POTDEM::Four> &);
#endif
};

}    // namespace LAMMPS_NS

#endif
