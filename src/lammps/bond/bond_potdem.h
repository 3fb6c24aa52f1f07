/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The bond styles of this package: BondPotdem<Law>, one for each row of BOND_LAWS in core/laws/law_list.h. Here is what knows
   the law: its coefficients, its kernels, and the loop (bond_potdem_loop.h). */

#ifndef LMP_BOND_POTDEM_H
#define LMP_BOND_POTDEM_H

#include "core/laws/law_list.h"
#include "lammps/bond/bond_potdem_base.h"

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
  void work(ThreadShare &share) override { (this->*(evflag ? tallied : quiet))(share); }

 private:
  std::vector<Law> laws;
  std::vector<typename Law::Kernel> kernels;

  typedef void (BondPotdem::*Loop)(ThreadShare &);
  Loop quiet, tallied;

  template <bool PENETRATION> void choose();
  template <bool PENETRATION, bool DAMP> void choose();
  template <int FAIL, bool PENETRATION, bool DAMP> void choose();
  template <bool EV, int FAIL, bool PENETRATION, bool DAMP> void loop(ThreadShare &);
  double energy_at(int n, double q, const double *state) const;    // q: (r/re)^2
};

}    // namespace LAMMPS_NS

#endif
