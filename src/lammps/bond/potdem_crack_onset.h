/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Where a solid cracks, whatever the directions of its bonds: a bond is reached by a crack when the largest principal stress of one of
   its particles reaches the tensile strength; the direction of that stress is the normal of the crack.

   The stress of a particle is Hooke's, E and nu of the network, for the strain that fits its bonds best (core/laws/green_lagrange.h),
   each counted as stiff as it is: A E re (1 - D). Such a strain is exact where the strain is uniform, at surfaces too, and beside an
   open crack it is that of the side on which the particle is. The stress of a particle is looked for only if one of its bonds that do
   not soften yet has reached LOADED of the strength, which the largest principal stress cannot precede. Where bonds do not tell the strain of
   either particle (a chain, a layer one particle thick in three dimensions) the bond's own stress decides. */

#ifndef LMP_POTDEM_CRACK_ONSET_H
#define LMP_POTDEM_CRACK_ONSET_H

#include "lammps/bond/potdem_bond_network.h"
#include "lammps/bond/potdem_softening.h"
#include "lammps/glue/interfaces.h"

#include <vector>

namespace LAMMPS_NS {

class PotdemCrackOnset : protected Pointers {
 public:
  PotdemCrackOnset(LAMMPS *, const PotdemBondNetwork &, const PotdemSoftening &);

  // loaded: bonds past BondStrengths::LOADED. Collective among the ranks that share bonds
  std::vector<BreakableBonds::Reached> find(const BreakableBonds::CrackQuestion &, double E,
                                            const std::vector<BreakableBonds::Listed> &loaded,
                                            int generation);
  double memory_usage() const;

 private:
  struct Stress {
    double
        largest;    // principal one, or something between it and the strength; not finite: the bonds do not tell
    double direction[3];    // its own
  };
  struct Told {
    tagint tag;
    Stress stress;
  };
  const PotdemBondNetwork &network;
  const PotdemSoftening &softening;

  // of each owned atom all its packed bonds, also those that are packed with their other end, and where that is
  struct End {
    int bond, other;
  };
  std::vector<int> first;
  std::vector<End> ends;
  int packed;    // generation of the lists that they belong to

  // of owned and ghost atoms: which of stresses is theirs, or -1
  std::vector<int> stress_of;
  std::vector<Stress> stresses;
  std::vector<int> loaded_atoms;

  void follow_lists(int generation);
  double strain(int i, const End &, double *del) const;
  void find_loaded(const std::vector<BreakableBonds::Listed> &, int type);
  Stress stress_at(int i, const BreakableBonds::CrackQuestion &, double E) const;
  void tell(const BreakableBonds::CrackQuestion &);
  bool is_reached(const BreakableBonds::CrackQuestion &, double E, const double *del,
                  BreakableBonds::Reached &) const;
};

}    // namespace LAMMPS_NS

#endif
