/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* fix potdem/failure: what bonds of one type bear, and the bonds that reached it, gone for good. How, see the .cpp */

#ifndef LMP_FIX_POTDEM_FAILURE_H
#define LMP_FIX_POTDEM_FAILURE_H

#include "core/laws/strength_scatter.h"

#include "lammps/glue/interfaces.h"

#include "fix_update_special_bonds.h"

#include <vector>

namespace LAMMPS_NS {

class FixPotdemFailure :
    public FixUpdateSpecialBonds,
    public FailureCriterion,
    public EnergySource {
 public:
  FixPotdemFailure(class LAMMPS *, int, char **);
  ~FixPotdemFailure() override;
  int setmask() override;
  void init() override;
  void give_strengths_to(class BondStrengths &) const override;
  void add_energy_to(PotdemEnergies &all) override { all.fracture += lost_energy; }
  void setup(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  // one failed bond, in the order of the columns of the local output; then the distance to the contact law's reach
  struct Failure {
    double step, time, tag1, tag2, x, y, z, strain, energy, contact;
    double gap;
  };

  int btype;
  double tension, compression;
  POTDEM::StrengthScatter scatter;
  double ntension, ncompression, lost_energy;    // since the first run, over all ranks
  BreakableBonds *bonds;                         // those of this type
  class FixPotdemBondHistory *history;
  int maxrows;    // of array_local: what this rank decided, in one block, as LAMMPS's Python module reads it

  // a bond that is to fail, by the IDs of its ends (low < high), and its energy when that was found
  struct Pending {
    tagint low, high;
    double energy;
  };
  std::vector<Pending> pending;    // the same on all ranks

  static POTDEM::StrengthScatter read_scatter(class PotdemInput &);
  void agree();
  std::vector<Failure> describe_pending();
  Failure describe(int i, const Pending &) const;
  double bond_energy(int i, int j) const;
  double contact_reach(int i, int j) const;
  void record(const std::vector<Failure> &);
  void find_bonds();
  void warn_if_idle() const;
  void remove(const Failure &);
};

}    // namespace LAMMPS_NS

#endif
