/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/output/fix_potdem_reference.h"

#include "atom.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixPotdemReference::FixPotdemReference(LAMMPS *lmp, int narg, char **arg) :
    FixPropertyAtom(lmp, narg, arg)
{
  create_attribute = 1;
}

int FixPotdemReference::setmask()
{
  return PRE_EXCHANGE | MIN_PRE_EXCHANGE;
}

double **FixPotdemReference::places() const
{
  return atom->darray[index[0]];
}

void FixPotdemReference::take(int i, bool fresh)
{
  double *const place = places()[i];
  std::copy_n(atom->x[i], 3, place);
  place[FRESH] = fresh;
}

void FixPotdemReference::take_all()
{
  for (int i = 0; i < atom->nlocal; i++) take(i, false);
}

// a particle that is new. In a run its bonds are measured in the same step; between runs it may be put elsewhere before that
void FixPotdemReference::set_arrays(int i)
{
  take(i, update->whichflag == 0);
}

void FixPotdemReference::setup_pre_exchange()
{
  for (int i = 0; i < atom->nlocal; i++)
    if (places()[i][FRESH] != 0.0) take(i, false);
}
