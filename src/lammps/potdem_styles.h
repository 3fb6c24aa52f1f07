/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The one registration table. LAMMPS includes this file among its own style headers (package compiled
   in), plugin.cpp includes it with macros of its own (plugin). A new style is one line in its block
   and one include below; a new law is a row in core/laws/law_list.h instead. LMP_OPENMP: LAMMPS has the
   package OPENMP. */

// clang-format off
#ifdef PAIR_CLASS
#define POTDEM_PAIR_STYLE(name, Law) \
  PairStyle(potdem/name,PairPotdem<POTDEM::Law>);
CONTACT_LAWS(POTDEM_PAIR_STYLE)
#undef POTDEM_PAIR_STYLE
#ifdef LMP_OPENMP
#define POTDEM_PAIR_STYLE_OMP(name, Law) \
  PairStyle(potdem/name/omp,PairPotdemOMP<POTDEM::Law>);
CONTACT_LAWS(POTDEM_PAIR_STYLE_OMP)
#undef POTDEM_PAIR_STYLE_OMP
#endif
#elif defined(BOND_CLASS)
#define POTDEM_BOND_STYLE(name, Law) \
  BondStyle(potdem/name,BondPotdem<POTDEM::Law>);
BOND_LAWS(POTDEM_BOND_STYLE)
#undef POTDEM_BOND_STYLE
#ifdef LMP_OPENMP
#define POTDEM_BOND_STYLE_OMP(name, Law) \
  BondStyle(potdem/name/omp,BondPotdemOMP<POTDEM::Law>);
BOND_LAWS(POTDEM_BOND_STYLE_OMP)
#undef POTDEM_BOND_STYLE_OMP
#endif
#elif defined(FIX_CLASS)
FixStyle(potdem/damping,FixPotdemDamping);
FixStyle(potdem/failure,FixPotdemFailure);
FixStyle(potdem/timestep,FixPotdemTimestep);
FixStyle(potdem/wall/region,FixPotdemWallRegion);
FixStyle(POTDEM_BOND_HISTORY,FixPotdemBondHistory);
FixStyle(POTDEM_AREA_BOND_HISTORY,FixPotdemBondValues);
FixStyle(POTDEM_CONTACTS,FixPotdemContacts);
FixStyle(POTDEM_LEDGER,FixPotdemLedger);
FixStyle(POTDEM_REFERENCE,FixPotdemReference);
FixStyle(POTDEM_REFRESH,FixPotdemRefresh);
FixStyle(POTDEM_RESUME,FixPotdemResume);
FixStyle(POTDEM_MONITOR,FixPotdemMonitor);
#ifdef LMP_OPENMP
FixStyle(potdem/damping/omp,FixPotdemOMP<FixPotdemDamping>);
FixStyle(potdem/wall/region/omp,FixPotdemOMP<FixPotdemWallRegion>);
#endif
#elif defined(COMPUTE_CLASS)
ComputeStyle(potdem/energy,ComputePotdemEnergy);
ComputeStyle(potdem/piece/atom,ComputePotdemPieceAtom);
ComputeStyle(potdem/strain/atom,ComputePotdemStrainAtom);
ComputeStyle(potdem/timestep,ComputePotdemTimestep);
#elif defined(COMMAND_CLASS)
CommandStyle(potdem_bonds,PotdemBonds);
CommandStyle(potdem_material,PotdemMaterial);
#elif defined(REGION_CLASS)
RegionStyle(potdem/mesh,RegPotdemMesh);
#else
// clang-format on
#ifndef LMP_POTDEM_STYLES_H
#define LMP_POTDEM_STYLES_H
#include "lammps/bond/bond_potdem.h"
#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/bond/fix_potdem_failure.h"
#include "lammps/bond/potdem_bonds.h"
#include "lammps/glue/fix_potdem_refresh.h"
#include "lammps/glue/fix_potdem_resume.h"
#include "lammps/glue/potdem_material.h"
#include "lammps/output/compute_potdem_energy.h"
#include "lammps/output/compute_potdem_piece_atom.h"
#include "lammps/output/compute_potdem_strain_atom.h"
#include "lammps/output/compute_potdem_timestep.h"
#include "lammps/output/fix_potdem_damping.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/fix_potdem_reference.h"
#include "lammps/output/fix_potdem_timestep.h"
#include "lammps/pair/fix_potdem_contacts.h"
#include "lammps/pair/pair_potdem.h"
#include "lammps/wall/fix_potdem_wall_region.h"
#include "lammps/wall/region_potdem_mesh.h"
#ifdef LMP_OPENMP
#include "lammps/bond/bond_potdem_omp.h"
#include "lammps/glue/fix_potdem_omp.h"
#include "lammps/pair/pair_potdem_omp.h"
#endif
#endif
#endif
