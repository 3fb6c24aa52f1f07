/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Adds pairs to the neighbour lists of the pair styles as they are, without building them anew: those of bonds that failed, which
   LAMMPS has left out. The next rebuild finds them by itself. */

#ifndef LMP_POTDEM_PAIR_LISTS_H
#define LMP_POTDEM_PAIR_LISTS_H

#include "pointers.h"

#include <map>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PotdemPairLists : protected Pointers {
 public:
  PotdemPairLists(LAMMPS *lmp) : Pointers(lmp) {}

  void add(tagint first, tagint second);    // wherever LAMMPS would have the pair on this rank
  void forget();                            // after a rebuild

 private:
  // rows of particles that have grown: in a list, and in what is remembered of its pairs
  std::map<std::pair<const class NeighList *, int>, std::vector<int>> rows;
  struct Memory {
    std::vector<int> flags;
    std::vector<double> values;
  };
  std::map<std::pair<const class FixNeighHistory *, int>, Memory> memories;

  void add_to(class NeighList *, tagint first, tagint second);
  bool leaves_out(const class NeighList *, int i, int j) const;
  void append(class NeighList *, int i, int j);
  void grow_memory(class FixNeighHistory *, int i, int n);
};

}    // namespace LAMMPS_NS

#endif
