/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the contacts of particles with the faces of a wall remember, in LAMMPS's fix STORE/ATOM, which carries it through
   exchange, sorting and restart files (its ID has its width, so that a file of a wall with other faces or another law is not
   misread): for each particle how many faces it touches, and so many places as it can touch at once, each the key of a
   face (0: free) and the numbers of the tangential law. There only where a law remembers. */

#ifndef LMP_POTDEM_WALL_MEMORY_H
#define LMP_POTDEM_WALL_MEMORY_H

#include "fix_store_atom.h"
#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class PotdemWallMemory : protected Pointers {
 public:
  // of the fix with this ID; not while a fix is made
  PotdemWallMemory(LAMMPS *, const std::string &id_fix, int faces, int state);
  ~PotdemWallMemory() override;
  void init();    // error if the fix that keeps it was removed

  // the faces that particle i touches now: others are forgotten, but for one that it has left for a new one, as where it rolls over a seam
  void follow(int i, const std::vector<int> &keys);
  bool is_empty(int i) const { return number(i) == 0.0; }
  double *of_face(int i, int key);    // its numbers, zeros if it has just been touched
  template <class Action> void for_each(int i, const Action &act) const    // what it remembers
  {
    const double *const places = places_of(i);
    for (int k = 0; k < faces; k++)
      if (places[k * width] != 0.0) act(places + k * width + 1);
  }

 private:
  std::string id, id_owner;
  int faces, width;
  class FixStoreAtom *store;

  double &number(int i) const { return *store->astore[i]; }    // of places in use
  double *places_of(int i) const { return store->astore[i] + 1; }
  bool keeps_only(int i, const std::vector<int> &keys) const;
  double *find(int i, int key) const;    // its place; of 0: a free one; null: none
};

}    // namespace LAMMPS_NS

#endif
