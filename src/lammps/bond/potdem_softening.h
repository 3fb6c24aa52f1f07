/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The bonds that a crack is opening (core/laws/softening.h). The loop over bonds takes them as if they were intact; what damage takes
   from their tension is put right here, so that a scene without such bonds pays nothing for them. The bonds' memory keeps
   their damage, at both ends. */

#ifndef LMP_POTDEM_SOFTENING_H
#define LMP_POTDEM_SOFTENING_H

#include "core/laws/softening.h"
#include "lammps/bond/potdem_bond_network.h"
#include "lammps/glue/interfaces.h"

#include <vector>

namespace LAMMPS_NS {

class PotdemSoftening : protected Pointers {
 public:
  PotdemSoftening(LAMMPS *, const PotdemBondNetwork &);

  // one packed bond, by the owned atom that it belongs to there
  struct Bond {
    int i, n;
    POTDEM::Softening law;
    double q;    // (r/re)^2 now

    // of its intact force and energy
    double loss() const { return q > 1.0 ? law.damage : 0.0; }
  };

  // whether a packed bond is one of these, and its damage
  bool is_among(int n) const { return !among.empty() && among[n]; }
  double damage(int n) const { return is_among(n) ? place(n)->law.damage : 0.0; }

  // the bonds are packed anew; what the memory has of each, in their order
  void make_room(const class FixPotdemBondHistory &);
  void take(int i, int n, const POTDEM::Softening &);
  // of these bonds one more, or the one that goes
  void add(FixPotdemBondHistory &, int i, int j, const POTDEM::Softening &);
  void remove(int i, tagint partner);
  // distances as they are; damage grows if `grows`
  void follow(class FixPotdemBondHistory &, bool grows);

  // in the order of their atoms: those of atoms from <= i < to
  const Bond *begin(int from) const;
  const Bond *end(int to) const { return begin(to); }
  // owned atom, partner, type; their faces are free
  const std::vector<BreakableBonds::Listed> &spent() const { return ended; }

  // of a type, on this rank: what has been lost, and how many there are. One that is shared with another rank counts at the lower ID
  double lost_energy(int type) const;
  int count(int type) const;

  double memory_usage() const { return bonds.capacity() * sizeof(Bond) + among.capacity(); }

 private:
  const PotdemBondNetwork &network;
  std::vector<Bond> bonds;    // in the order of packing
  std::vector<char> among;    // of each packed bond; empty: none is
  std::vector<BreakableBonds::Listed> ended;

  std::vector<Bond>::const_iterator place(int n) const;    // its, or where it would be
  bool counts(const Bond &) const;
  void remember(FixPotdemBondHistory &, const Bond &) const;
};

}    // namespace LAMMPS_NS

#endif
