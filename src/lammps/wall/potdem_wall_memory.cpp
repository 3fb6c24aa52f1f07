/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/wall/potdem_wall_memory.h"

#include "atom.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PotdemWallMemory::PotdemWallMemory(LAMMPS *lmp, const std::string &id_fix, int _faces, int state) :
    Pointers(lmp), id(fmt::format("{}_MEMORY_{}", id_fix, 1 + _faces * (1 + state))),
    id_owner(id_fix), faces(_faces), width(1 + state), store(nullptr)
{
  modify->add_fix(fmt::format("{} all STORE/ATOM {} 0 no yes", id, 1 + faces * width));
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
               "was removed with unfix: keep it, or define the wall again",
               id_owner, id);
}

double *PotdemWallMemory::find(int i, int key) const
{
  double *const places = places_of(i);
  for (int k = 0; k < faces; k++)
    if (static_cast<int>(places[k * width]) == key) return places + k * width;
  return nullptr;
}

// as from one step to the next, mostly
bool PotdemWallMemory::keeps_only(int i, const std::vector<int> &keys) const
{
  return keys.size() == 1 && number(i) == 1.0 && static_cast<int>(*places_of(i)) == keys[0];
}

double *PotdemWallMemory::of_face(int i, int key)
{
  if (double *const known = find(i, key)) return known + 1;
  double *const place = find(i, 0);
  if (!place)
    error->one(FLERR,
               "Fix potdem/wall/region {}: atom {} touches more than {} faces on step {}, for "
               "which its memory has no place; use a region with fewer parts for one fix",
               id_owner, atom->tag[i], faces, update->ntimestep);
  std::fill_n(place, width, 0.0);
  *place = key;
  number(i) += 1.0;
  return place + 1;
}
