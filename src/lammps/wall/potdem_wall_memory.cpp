/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/wall/potdem_wall_memory.h"

#include "atom.h"
#include "error.h"
#include "fix_store_atom.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PotdemWallMemory::PotdemWallMemory(LAMMPS *lmp, const std::string &id_fix, int _faces, int state) :
    Pointers(lmp), id(fmt::format("{}_MEMORY_{}", id_fix, _faces * (1 + state))), id_owner(id_fix),
    faces(_faces), width(1 + state), store(nullptr), touched(_faces, false)
{
  modify->add_fix(fmt::format("{} all STORE/ATOM {} 0 no yes", id, faces * width));
  init();
}

// not when LAMMPS ends
PotdemWallMemory::~PotdemWallMemory()
{
  if (modify && modify->get_fix_by_id(id)) modify->delete_fix(id);
}

void PotdemWallMemory::init()
{
  store = dynamic_cast<FixStoreAtom *>(modify->get_fix_by_id(id));
  if (!store)
    error->all(FLERR,
               "Fix potdem/wall/region {}: fix {}, in which its contacts remember their friction, "
               "was removed with unfix: leave it, or define the wall again",
               id_owner, id);
}

double *PotdemWallMemory::at(int i) const
{
  return store->astore[i];
}

double *PotdemWallMemory::of_face(int i, int key)
{
  double *const places = at(i);
  int place = faces;
  for (int k = 0; k < faces; k++) {
    const int there = static_cast<int>(places[k * width]);
    if (there == key) {
      touched[k] = true;
      return places + k * width + 1;
    }
    if (there == 0 && place == faces) place = k;
  }
  if (place == faces)
    error->one(FLERR,
               "Fix potdem/wall/region {}: atom {} touches more than {} faces on step {}, for "
               "which its memory has no place; use a region with fewer parts for one fix",
               id_owner, atom->tag[i], faces, update->ntimestep);
  double *const fresh = places + place * width;
  std::fill_n(fresh, width, 0.0);
  *fresh = key;
  touched[place] = true;
  return fresh + 1;
}

void PotdemWallMemory::forget_others(int i)
{
  double *const places = at(i);
  for (int k = 0; k < faces; k++) {
    if (!touched[k]) places[k * width] = 0.0;
    touched[k] = false;
  }
}
