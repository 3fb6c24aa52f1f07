/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* fix potdem/failure: what bonds of one type bear, and the bonds that reached it, gone for good, at once or when a crack has opened.
   How, see the .cpp */

#ifndef LMP_FIX_POTDEM_FAILURE_H
#define LMP_FIX_POTDEM_FAILURE_H

#include "core/laws/strength_scatter.h"
#include "lammps/glue/interfaces.h"

#include "fix_update_special_bonds.h"

#include <map>
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
  void add_energy_to(PotdemEnergies &all) override { all.fracture += totals().energy; }
  void setup(int) override;
  void post_integrate() override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  // one failed bond, in the order of the columns of the local output
  struct Failure {
    double step, time, tag1, tag2, x, y, z, strain, energy, contact;
  };
  struct Totals {
    double energy, tension, compression;    // fracture energy, and failed bonds
    double softening;                       // bonds that are left and damaged
    double count() const { return tension + compression; }
  };

  int btype;
  double tension, compression;
  double toughness;    // energy over area of a crack; 0: bonds fail at once
  bool principal;      // in tension the stress of the solid decides, not that of a bond
  POTDEM::StrengthScatter scatter;
  Totals lost;              // since the first run, of what this rank decided
  bigint uncounted;         // of those: LAMMPS's number of bonds still has them
  BreakableBonds *bonds;    // those of this type
  class FixPotdemBondHistory *history;
  int maxrows;    // of array_local: what this rank decided, in one block, as LAMMPS's Python module reads it

  // a bond that is to fail, by the IDs of its ends (low < high), on each rank that has one of them
  struct Doomed {
    tagint low, high;
    double energy;    // when that was found, where it was
    int other;        // rank that owns the other end
  };
  struct TagPair {
    tagint low, high;
  };
  std::vector<Doomed> pending;
  std::vector<int> owner;    // rank of each ghost
  std::map<int, std::vector<TagPair>>
      told;          // for each rank that shares bonds with this one: nothing, between messages
  int generation;    // of the bond list that they belong to

  static POTDEM::StrengthScatter read_scatter(class PotdemInput &);
  static bool read_criterion(PotdemInput &);
  void follow_lists();
  void decide();
  void doom(int i, int j);
  void find_onsets();
  POTDEM::Softening softening_of(const BreakableBonds::Reached &, double re) const;
  void check_softening();
  void tell();
  bool owns(tagint) const;
  struct Apart {
    double del[3],
        r2;    // from the end with the lower ID, if this rank has it, else from the other
  };
  std::vector<Apart> distances() const;
  Failure describe(const Doomed &, const Apart &, double contact) const;
  double bond_energy(int i, tagint partner, double r2) const;
  double contact_reach(int i, int j) const;
  void record(const Failure &);
  void find_bonds();
  void warn_if_idle();
  void remove(const Doomed &, double r2);
  Totals totals() const;
  Totals over_all_ranks(const Totals &) const;
  void count_bonds();
};

}    // namespace LAMMPS_NS

#endif
