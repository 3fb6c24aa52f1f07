/* The one registration table. LAMMPS includes this file among its own style headers (package compiled
   in), plugin.cpp includes it with macros of its own (plugin). A new style is one line in its block
   and one include below. */

// clang-format off
#ifdef PAIR_CLASS
PairStyle(potdem/granular,PairPotdemGranular);
PairStyle(potdem/granular/omp,PairPotdemGranularOMP);
PairStyle(potdem/hertz,PairPotdemHertz);
PairStyle(potdem/hertz/omp,PairPotdemHertzOMP);
PairStyle(potdem/lj,PairPotdemLJ);
PairStyle(potdem/lj/omp,PairPotdemLJOMP);
PairStyle(potdem/truss,PairPotdemTruss);
PairStyle(potdem/truss/omp,PairPotdemTrussOMP);
#elif defined(BOND_CLASS)
BondStyle(potdem/truss,BondPotdemTruss);
BondStyle(potdem/truss/omp,BondPotdemTrussOMP);
#elif defined(FIX_CLASS)
FixStyle(potdem/damping,FixPotdemDamping);
FixStyle(potdem/failure,FixPotdemFailure);
FixStyle(potdem/timestep,FixPotdemTimestep);
FixStyle(potdem/wall/region,FixPotdemWallRegion);
FixStyle(POTDEM_BOND_HISTORY,PotdemBondStore);
FixStyle(POTDEM_CONTACTS,FixPotdemContacts);
FixStyle(POTDEM_LEDGER,PotdemLedger);
FixStyle(POTDEM_REFERENCE,FixPotdemReference);
FixStyle(POTDEM_REFRESH,FixPotdemRefresh);
FixStyle(POTDEM_WATCH,PotdemWatch);
#elif defined(COMPUTE_CLASS)
ComputeStyle(potdem/energy,ComputePotdemEnergy);
ComputeStyle(potdem/piece/atom,ComputePotdemPieceAtom);
ComputeStyle(potdem/strain/atom,ComputePotdemStrainAtom);
ComputeStyle(potdem/timestep,ComputePotdemTimestep);
#elif defined(COMMAND_CLASS)
CommandStyle(potdem_bonds,PotdemBonds);
CommandStyle(potdem_material,PotdemMaterial);
#else
// clang-format on
#ifndef LMP_POTDEM_STYLES_H
#define LMP_POTDEM_STYLES_H
#include "bond_potdem_truss.h"
#include "bond_potdem_truss_omp.h"
#include "compute_potdem_energy.h"
#include "compute_potdem_piece_atom.h"
#include "compute_potdem_strain_atom.h"
#include "compute_potdem_timestep.h"
#include "fix_potdem_contacts.h"
#include "fix_potdem_damping.h"
#include "fix_potdem_failure.h"
#include "fix_potdem_reference.h"
#include "fix_potdem_refresh.h"
#include "fix_potdem_timestep.h"
#include "fix_potdem_wall_region.h"
#include "pair_potdem_granular.h"
#include "pair_potdem_hertz.h"
#include "pair_potdem_lj.h"
#include "pair_potdem_omp.h"
#include "pair_potdem_truss.h"
#include "potdem_bond_store.h"
#include "potdem_bonds.h"
#include "potdem_ledger.h"
#include "potdem_material.h"
#include "potdem_watch.h"
#endif
#endif
