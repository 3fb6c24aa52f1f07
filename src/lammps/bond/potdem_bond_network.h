/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The bonds of one style on this rank, packed for its loop: grouped by their owned atom, in LAMMPS's order; first the
   partners that are owned too, then the ghosts, whose rank computes the same bond for itself. Here is what a bond is;
   what it does, the style and its law know. Packed anew after each rebuild of LAMMPS's bond list. What a law keeps of
   each bond changes in the loop, and goes back into the bonds' memory before the particles change their places. */

#ifndef LMP_POTDEM_BOND_NETWORK_H
#define LMP_POTDEM_BOND_NETWORK_H

#include "pointers.h"

#include <cmath>
#include <vector>

namespace LAMMPS_NS {

class PotdemBondNetwork : protected Pointers {
 public:
  // per owned atom: first bond, first with a ghost partner; one more than there are atoms
  std::vector<int> first, ghosts;
  // per bond; type 0: cut
  std::vector<int> partner;
  typedef unsigned short Type;
  std::vector<Type> type;
  std::vector<double> inverse_length2, half_modulus;    // 1/re^2, A E/2
  std::vector<double> dashpot;                          // if any is damped
  std::vector<double> strength;                         // over that of the type, if it scatters
  std::vector<double> state;                            // nstate of each bond

  PotdemBondNetwork(LAMMPS *, int nstate);

  // takes LAMMPS's bonds of the types that are ours (1), and makes room for what there is of each
  void order(const std::vector<char> &ours, bool damped, bool scattered);
  int size() const { return static_cast<int>(partner.size()); }
  double length(int n) const { return 1.0 / sqrt(inverse_length2[n]); }
  double modulus(int n) const { return 2.0 * half_modulus[n]; }
  double *state_of(int n) { return nstate ? &state[n * static_cast<bigint>(nstate)] : nullptr; }
  int find(int i, int j) const;    // bond of these two on this rank, or -1
  int row_of(int n) const;         // atom that a bond is packed with

  // no force from here on; in_list: LAMMPS's list is the one that was ordered
  void cut(int i, tagint partner_tag, bool in_list);

  void take_state(const class FixPotdemBondHistory &);
  void state_changes() { newer = nstate > 0; }
  bool state_is_newer() const { return newer; }    // than the memory
  void return_state(class FixPotdemBondHistory &);

  double memory_usage() const;

 private:
  int nstate;
  bool newer;

  int find_partner(int i, tagint) const;
  int *listed(int i, int j) const;
};

}    // namespace LAMMPS_NS

#endif
