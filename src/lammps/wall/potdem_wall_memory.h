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

#include <algorithm>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class PotdemWallMemory : protected Pointers {
 public:
  // of the fix with this ID; not while a fix is made
  PotdemWallMemory(LAMMPS *, const std::string &id_fix, int faces, int state);
  ~PotdemWallMemory() override;
  void init();    // error if the fix that keeps it was removed

  // The faces that particle i touches now: others are forgotten, but for those that it has left for new ones. surface.is_beside(left,
  // fresh): of two triangles, whether the way from one to the other is around an edge; a face of another kind is left for any, as where
  // a particle rolls over a seam, and one at a time
  template <class Surface> void follow(int i, const std::vector<int> &keys, const Surface &);
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
  void forget(int i, double *place)
  {
    *place = 0.0;
    number(i) -= 1.0;
  }
};

template <class Surface>
void PotdemWallMemory::follow(int i, const std::vector<int> &keys, const Surface &surface)
{
  if (is_empty(i) || keeps_only(i, keys)) return;
  double *left = nullptr;
  const auto fresh = [this, i, &keys](const auto &fits) {
    return std::find_if(keys.begin(), keys.end(), [&](int key) {
      return !find(i, key) && fits(key);
    });
  };
  for (int k = 0; k < faces; k++) {
    double *const place = places_of(i) + k * width;
    const int key = static_cast<int>(*place);
    if (key == 0 || std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const auto next = fresh([&](int other) {
      return surface.is_beside(key, other);
    });
    if (next != keys.end()) {
      *place = *next;
    } else {
      if (left) forget(i, left);
      left = place;
    }
  }
  if (!left) return;
  const auto any = fresh([](int) {
    return true;
  });
  if (any == keys.end())
    forget(i, left);
  else
    *left = *any;
}

}    // namespace LAMMPS_NS

#endif
