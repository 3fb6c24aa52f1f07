/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/bond_potdem_truss.h"

#include "core/areas/lattice_area.h"
#include "core/laws/truss.h"
#include "lammps/bond/fix_potdem_bond_history.h"
#include "lammps/bond/potdem_body_area.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_refresh.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_material_input.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/potdem_stiffness.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// LAMMPS's own allowance for the stretch of bonds in its communication cutoff
static constexpr double STRETCH_ALLOWANCE = 1.5;
static constexpr double UNBREAKABLE = 1e300;
// lattice distances are recognised within this fraction
static constexpr double SHELL_TOLERANCE = 1e-3;

static double distance2(const double *a, const double *b)
{
  const double dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
  return dx * dx + dy * dy + dz * dz;
}

/* ---------------------------------------------------------------------- */

BondPotdemTruss::BondPotdemTruss(LAMMPS *lmp) :
    Bond(lmp), failing(NEVER), has_penetration(false), damped(false), history(nullptr), lost(false),
    ledger(nullptr), monitor(nullptr), generation(-1), new_bonds(true), longest(0.0),
    quiet(nullptr), tallied(nullptr)
{
  partial_flag = 1;
  writedata = 1;
  single_extra = PotdemCompat::columns_in_single(lmp, force->bond_style) ? NEXTRA : 0;
  svector = new double[NEXTRA];
}

BondPotdemTruss::~BondPotdemTruss()
{
  delete[] svector;
  if (allocated) memory->destroy(setflag);
  for (auto &one : adaptable) memory->destroy(one.values);
}

BondPotdemTruss *BondPotdemTruss::find(LAMMPS *lmp)
{
  for (const char *style : {"potdem/truss", "potdem/truss/omp"})
    if (auto bond = lmp->force->bond_match(style)) return dynamic_cast<BondPotdemTruss *>(bond);
  return nullptr;
}

void BondPotdemTruss::settings(int narg, char **arg)
{
  if (narg > 0)
    error->all(FLERR, "bond_style potdem/truss: unknown keyword '{}', it takes none", arg[0]);
}

void BondPotdemTruss::allocate()
{
  allocated = 1;
  const int n = atom->nbondtypes + 1;
  memory->create(setflag, n, "bond:setflag");
  std::fill(setflag, setflag + n, 0);
  coeffs.assign(n, Coeff{});
  factors.assign(n, POTDEM::Penetration());
}

/* ----------------------------------------------------------------------
   N  E  area factor a | area lattice | area body [density rho]  [penetration m [normalized]] [damping xi]
------------------------------------------------------------------------- */

void BondPotdemTruss::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemMaterialInput input(lmp, "bond_coeff potdem/truss", narg, arg);
  int lo, hi;
  utils::bounds(FLERR, input.word(), 1, atom->nbondtypes, lo, hi, error);
  const Coeff c = read(input);
  for (int type = lo; type <= hi; type++) {
    coeffs[type] = c;
    setflag[type] = 1;
  }
  show_to_adapt();
}

BondPotdemTruss::Coeff BondPotdemTruss::read(PotdemMaterialInput &input) const
{
  Coeff c{};
  c.E = input.property("E");
  if (!input.next_is("area")) {
    input.word();
    input.unknown("area");
  }
  if (input.next_is("factor")) {
    c.mode = FACTOR;
    c.area = input.in_range("area factor a", POTDEM::positive());
  } else if (input.next_is("lattice")) {
    c.mode = LATTICE;
  } else if (input.next_is("body")) {
    c.mode = BODY;
    if (input.next_is("density")) c.area = input.properties({"density"}, " of area body").front();
  } else {
    input.word();
    input.unknown("area factor, area lattice or area body");
  }
  if (c.mode != FACTOR && domain->dimension == 2)
    input.fail("area lattice and area body are for solids in three dimensions; in two use area "
               "factor a, for a plate the a of its thickness (see the page of the style)");
  while (!input.done()) {
    if (input.next_is("penetration")) {
      c.m = input.whole("penetration m", POTDEM::MAX_PENETRATION);
      c.normalized = input.next_is("normalized");
    } else if (input.next_is("damping")) {
      c.xi = input.in_range("damping xi", POTDEM::nonnegative());
    } else {
      input.word();
      input.unknown("penetration or damping");
    }
  }
  return c;
}

/* ---------------------------------------------------------------------- */

void BondPotdemTruss::init_style()
{
  potdem_refuse_respa(lmp, "bond_style potdem/truss");
  if (!atom->radius_flag)
    error->all(FLERR,
               "bond_style potdem/truss needs particle diameters, e.g. atom_style bpm/sphere");
  if (force->newton_bond)
    error->all(
        FLERR,
        "bond_style potdem/truss needs newton off for bonds: make the bonds with potdem_bonds, "
        "or put 'newton on off' before the box is created");
  const double *lj = force->special_lj, *coul = force->special_coul;
  if (lj[1] != 0.0 || lj[2] != 1.0 || lj[3] != 1.0 || coul[2] != 1.0 || coul[3] != 1.0)
    error->all(FLERR,
               "bond_style potdem/truss needs 'special_bonds lj 0 1 1 coul 0 1 1', as potdem_bonds "
               "sets it: "
               "bonded pairs do not touch, all others do");
  history = FixPotdemBondHistory::ensure(lmp);
  lost = false;
  announce_contacts();
  ledger = FixPotdemLedger::find(lmp);
  monitor = FixPotdemMonitor::ensure(lmp);
  FixPotdemRefresh::ensure(lmp);
  new_bonds = true;

  reinit();
  for (int type = 1; type <= atom->nbondtypes; type++)
    if (setflag[type] && coeffs[type].mode == BODY)
      history->allow_exchange(POTDEM::BodyHalo::WIDEST);
  set_communication();
}

// LAMMPS has the pair style initialised before this
void BondPotdemTruss::announce_contacts()
{
  for (auto *const contacts : potdem_find<ContactMemory>(lmp))
    contacts->expect_contacts(history->new_contacts);
  history->new_contacts.clear();
}

// what fix adapt calls when it has changed coefficients, at any step
void BondPotdemTruss::reinit()
{
  for (int type = 1; type <= atom->nbondtypes; type++) take_adapted(type);
  find_needs();
  if (damped) comm->ghost_velocity = 1;
  generation = -1;
}

void BondPotdemTruss::find_needs()
{
  has_penetration = damped = false;
  failing = NEVER;
  for (int type = 1; type <= atom->nbondtypes; type++) {
    if (!setflag[type]) continue;
    if (coeffs[type].m > 0) {
      has_penetration = true;
      factors[type] = POTDEM::Penetration(coeffs[type].m, coeffs[type].normalized);
    }
    if (coeffs[type].xi > 0.0 && !potdem_minimizes(lmp)) damped = true;
  }
  tension.assign(atom->nbondtypes + 1, UNBREAKABLE);
  compression.assign(atom->nbondtypes + 1, -UNBREAKABLE);
  scatter.assign(atom->nbondtypes + 1, POTDEM::StrengthScatter());
  for (const auto *criterion : potdem_find<FailureCriterion>(lmp))
    criterion->give_strengths_to(*this);
}

/* ----------------------------------------------------------------------
   ghosts must reach the far end of every bond, stretched; a user's own comm_modify cutoff is kept if
   it covers the bonds as they are. What this style has set itself is known as such by the bonds' memory
------------------------------------------------------------------------- */

void BondPotdemTruss::set_communication()
{
  longest = history->longest();
  const double need = longest + neighbor->skin;
  const bool users = comm->cutghostuser > 0.0 && comm->cutghostuser != history->ghost_cutoff;
  if (users && comm->cutghostuser < need)
    error->all(
        FLERR,
        "bond_style potdem/truss: the longest bond ({}) and the neighbour skin ({}) are beyond the "
        "communication cutoff {}; increase it with comm_modify cutoff, or leave it out",
        longest, neighbor->skin, comm->cutghostuser);
  if (users) return;
  const double contacts = force->pair ? force->pair->cutforce : 0.0;
  comm->cutghostuser = history->ghost_cutoff =
      MAX(STRETCH_ALLOWANCE * longest, contacts) + neighbor->skin;
}

bool BondPotdemTruss::has_new_bonds() const
{
  return history->has_new_bonds();
}

void BondPotdemTruss::lose_memory()
{
  history = nullptr;
  lost = true;
}

void BondPotdemTruss::expect_new_bonds()
{
  new_bonds = true;
  set_communication();
}

double BondPotdemTruss::equilibrium_distance(int /*type*/)
{
  return longest;
}

void BondPotdemTruss::set_strength(int type, double ft, double fc,
                                   const POTDEM::StrengthScatter &spread)
{
  if (ft > 0.0) tension[type] = 2.0 * ft / coeffs[type].E;
  if (fc > 0.0) compression[type] = -2.0 * fc / coeffs[type].E;
  scatter[type] = spread;
  failing = MAX(failing, spread.active() ? BY_BOND : BY_TYPE);
}

/* ----------------------------------------------------------------------
   after each rebuild of LAMMPS's bond list: what the loop needs, contiguous and in its order
------------------------------------------------------------------------- */

void BondPotdemTruss::pack()
{
  generation = history->generation;
  if (new_bonds) {
    measure_new_bonds();
    find_areas();
    new_bonds = false;
  }
  order_bonds();

  const std::size_t n = bonds.partner.size();
  bonds.inverse_length2.resize(n);
  bonds.half_modulus.resize(n);
  bonds.dashpot.resize(damped ? n : 0);
  bonds.strength.resize(failing == BY_BOND ? n : 0);
  for (int i = 0; i < atom->nlocal; i++) {
    for (int k = bonds.first[i]; k < bonds.first[i + 1]; k++) {
      const int j = bonds.partner[k], type = bonds.type[k];
      const int slot = history->slot(i, atom->tag[j]);
      const double re = history->length(i, slot);
      const double modulus = coeffs[type].E * section(type, i, slot);
      bonds.inverse_length2[k] = 1.0 / (re * re);
      bonds.half_modulus[k] = 0.5 * modulus;
      if (j >= atom->nlocal) check_reach(i, j, re);
      if (monitor && monitor->pair_too_stiff_for_step(i, j, modulus / re))
        monitor->warn_of_stiff_pair("The bond of", i, j, modulus / re);
      if (failing == BY_BOND) bonds.strength[k] = scatter[type].factor(atom->tag[i], atom->tag[j]);
      if (damped) {
        const double mi = atom->rmass[i], mj = atom->rmass[j];
        bonds.dashpot[k] =
            2.0 * coeffs[type].xi * sqrt(modulus / re * force->mvv2e * mi * mj / (mi + mj));
      }
    }
  }
}

// in bond_style hybrid the list may hold those of other styles
bool BondPotdemTruss::is_ours(int type) const
{
  return type > 0 && setflag[type];
}

// LAMMPS lists the bonds by owned atom already; within one atom the ghosts go last
void BondPotdemTruss::order_bonds()
{
  int **list = neighbor->bondlist;
  const int nlist = neighbor->nbondlist, nlocal = atom->nlocal;
  bonds.first.assign(nlocal + 1, 0);
  bonds.ghosts.assign(nlocal, 0);
  for (int k = 0; k < nlist; k++) {
    if (!is_ours(list[k][2])) continue;
    bonds.first[list[k][0] + 1]++;
    if (list[k][1] < nlocal) bonds.ghosts[list[k][0]]++;
  }
  for (int i = 0; i < nlocal; i++) {
    bonds.first[i + 1] += bonds.first[i];
    bonds.ghosts[i] += bonds.first[i];
  }
  const int n = bonds.first[nlocal];
  bonds.partner.resize(n);
  bonds.type.resize(n);
  bonds.listed.resize(n);
  std::vector<int> owned(bonds.first.begin(), bonds.first.end() - 1), ghost = bonds.ghosts;
  for (int k = 0; k < nlist; k++) {
    if (!is_ours(list[k][2])) continue;
    const int i = list[k][0];
    const int at = list[k][1] < nlocal ? owned[i]++ : ghost[i]++;
    bonds.partner[at] = list[k][1];
    bonds.type[at] = list[k][2];
    bonds.listed[at] = k;
  }
}

// before the bond's far end leaves the ghosts and LAMMPS can only say that an atom is missing
void BondPotdemTruss::check_reach(int i, int j, double re) const
{
  const double r = sqrt(distance2(atom->x[i], atom->x[j]));
  const double cutoff = MAX(comm->cutghostuser, neighbor->cutneighmax);
  if (r + neighbor->skin > cutoff)
    error->one(
        FLERR,
        "Bond between atoms {} and {} is {} long (reference {}): with the neighbour skin {} it is "
        "beyond the communication cutoff {}; increase it with comm_modify cutoff, or let bonds "
        "fail "
        "with fix potdem/failure",
        atom->tag[i], atom->tag[j], r, re, neighbor->skin, cutoff);
}

double BondPotdemTruss::section(int type, int i, int slot) const
{
  const Coeff &c = coeffs[type];
  if (c.mode == FACTOR) return c.area * history->section(i, slot);
  return fabs(history->area(i, slot));
}

// at set-up it is worth a word: a body that is strained already is measured as it is
void BondPotdemTruss::measure_new_bonds()
{
  bigint ends = history->measure_new_bonds(), all;
  if (!update->setupflag) return;
  MPI_Allreduce(&ends, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all > 0 && comm->me == 0)
    utils::logmesg(lmp,
                   "bond_style potdem/truss: {} bonds that had no reference length take their "
                   "present one\n",
                   all / 2);
}

void BondPotdemTruss::find_areas()
{
  for (int type = 1; type <= atom->nbondtypes; type++) {
    if (!setflag[type]) continue;
    if (coeffs[type].mode == LATTICE) find_lattice(type);
    if (coeffs[type].mode == BODY) PotdemBodyArea(lmp, history).solve(type, coeffs[type].area);
  }
}

/* ----------------------------------------------------------------------
   area lattice: the lattice is read off the bonds of the particle that has most of them, of those with bonds that have no
   section yet. A few bonds that join bodies make no lattice: they get the section of their type
------------------------------------------------------------------------- */

bool BondPotdemTruss::lacks_section(int type, int i, int m) const
{
  return atom->bond_type[i][m] == type && history->area(i, m) >= 0.0;
}

void BondPotdemTruss::find_lattice(int type)
{
  struct {
    int count, rank;
  } mine = {0, comm->me}, most;
  int chosen = -1;
  for (int i = 0; i < atom->nlocal; i++) {
    const int *types = atom->bond_type[i], n = atom->num_bond[i];
    const int count = std::count(types, types + n, type);
    bool incomplete = false;
    for (int m = 0; m < n; m++) incomplete = incomplete || lacks_section(type, i, m);
    if (incomplete && count > mine.count) {
      mine.count = count;
      chosen = i;
    }
  }
  MPI_Allreduce(&mine, &most, 1, MPI_2INT, MPI_MAXLOC, world);
  if (most.count == 0) return;

  LatticeFound found{};
  if (comm->me == most.rank) found = read_lattice(type, chosen);
  MPI_Bcast(&found, sizeof(found), MPI_BYTE, most.rank, world);
  const double known = found.section > 0.0 ? found.section : section_of_lattice(type);
  if (known <= 0.0)
    error->all(
        FLERR,
        "bond_style potdem/truss: area lattice for bond type {} needs a cubic, bcc, fcc or hcp "
        "lattice with enough bonds to be stiff; the particle with most bonds has {} and {} nearest "
        "neighbours: use area body or area factor",
        type, most.count, found.nearest);
  const bigint count = give_section(type, known);
  if (comm->me != 0) return;
  if (found.section > 0.0)
    utils::logmesg(
        lmp,
        "bond_style potdem/truss: bond type {}: lattice with {} nearest neighbours and {} bonds "
        "per particle, section {:.8g}\n",
        type, found.nearest, found.bonds, known);
  else
    utils::logmesg(
        lmp,
        "bond_style potdem/truss: bond type {}: {} new bonds make no lattice of their own and get "
        "the section {:.8g} of this type\n",
        type, count, known);
}

BondPotdemTruss::LatticeFound BondPotdemTruss::read_lattice(int type, int i) const
{
  std::vector<double> lengths;
  for (int m = 0; m < atom->num_bond[i]; m++)
    if (atom->bond_type[i][m] == type) lengths.push_back(history->length(i, m));
  std::sort(lengths.begin(), lengths.end());
  const double spacing = lengths.front();
  const int nearest = std::count_if(lengths.begin(), lengths.end(), [spacing](double length) {
    return length < spacing * (1.0 + SHELL_TOLERANCE);
  });
  LatticeFound found{0.0, static_cast<double>(nearest), 0.0};
  const auto lattice = POTDEM::lattice_of(nearest, nearest != 12 || centred(type, i, spacing));
  if (lattice == POTDEM::Lattice::NONE) return found;
  for (const double length : lengths)
    if (!POTDEM::is_shell(lattice, length / spacing, SHELL_TOLERANCE)) return found;
  const auto answer = POTDEM::lattice_area(lattice, lengths.back() / spacing);
  found.bonds = answer.bonds;
  found.section = answer.area_factor * POTDEM::truss_section(spacing);
  return found;
}

// that the bonds of this type have already; 0: none has
double BondPotdemTruss::section_of_lattice(int type) const
{
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      if (atom->bond_type[i][m] == type) mine = MAX(mine, -history->area(i, m));
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}

// to the bonds that have none; how many there are
bigint BondPotdemTruss::give_section(int type, double section)
{
  bigint ends = 0, all;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < atom->num_bond[i]; m++)
      if (lacks_section(type, i, m)) {
        history->store_area(i, m, -section);
        ends++;
      }
  MPI_Allreduce(&ends, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all / 2;
}

// fcc, unlike hcp, has every nearest neighbour face another one
bool BondPotdemTruss::centred(int type, int i, double spacing) const
{
  double sum[3] = {0.0, 0.0, 0.0};
  int opposite = 0;
  std::vector<const double *> near;
  for (int m = 0; m < atom->num_bond[i]; m++)
    if (atom->bond_type[i][m] == type && history->length(i, m) < spacing * (1.0 + SHELL_TOLERANCE))
      near.push_back(atom->x[domain->closest_image(i, atom->map(atom->bond_atom[i][m]))]);
  for (const double *a : near)
    for (const double *b : near) {
      for (int k = 0; k < 3; k++) sum[k] = a[k] + b[k] - 2.0 * atom->x[i][k];
      if (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] < 0.01 * spacing * spacing)
        opposite++;
    }
  return opposite == static_cast<int>(near.size());
}

/* ---------------------------------------------------------------------- */

void BondPotdemTruss::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  refresh();
  over.clear();
  ThreadShare all{0, atom->nlocal, atom->f, nullptr, {}};
  work(all);
  collect(all);
}

void BondPotdemTruss::work(ThreadShare &share_of_thread)
{
  (this->*(evflag ? tallied : quiet))(share_of_thread);
}

void BondPotdemTruss::collect(const ThreadShare &share_of_thread)
{
  if (share_of_thread.i >= 0) collapsed(share_of_thread.i, share_of_thread.j);
  if (monitor && share_of_thread.crushed >= 0)
    suspect(share_of_thread.crushed_i, share_of_thread.crushed);
  over.insert(over.end(), share_of_thread.over.begin(), share_of_thread.over.end());
}

void BondPotdemTruss::refresh()
{
  if (generation == history->generation) return;
  pack();
  choose_kernels();
}

// the smallest kernel that the coefficients and the failure fixes need
void BondPotdemTruss::choose_kernels()
{
  if (has_penetration)
    damped ? choose<true, true>() : choose<true, false>();
  else
    damped ? choose<false, true>() : choose<false, false>();
}

template <bool HINDER, bool DAMP> void BondPotdemTruss::choose()
{
  switch (failing) {
    case NEVER:
      return choose<NEVER, HINDER, DAMP>();
    case BY_TYPE:
      return choose<BY_TYPE, HINDER, DAMP>();
    case BY_BOND:
      return choose<BY_BOND, HINDER, DAMP>();
  }
}

template <int FAIL, bool HINDER, bool DAMP> void BondPotdemTruss::choose()
{
  quiet = &BondPotdemTruss::kernel<false, FAIL, HINDER, DAMP>;
  tallied = &BondPotdemTruss::kernel<true, FAIL, HINDER, DAMP>;
}

/* ----------------------------------------------------------------------
   the loop over bonds: one atom at a time, its force kept in registers
------------------------------------------------------------------------- */

template <bool EV, int FAIL, bool HINDER, bool DAMP>
void BondPotdemTruss::kernel(ThreadShare &share_of_thread)
{
  const auto *const x = (const double(*)[3]) atom->x[0];
  const auto *const v = (const double(*)[3]) atom->v[0];
  auto *const f = (double(*)[3]) share_of_thread.f[0];
  const int *const partner = bonds.partner.data();
  const int *const type = bonds.type.data();
  const double *const inverse_length2 = bonds.inverse_length2.data();
  const double *const half_modulus = bonds.half_modulus.data();
  constexpr double crushed = FixPotdemMonitor::CRUSHED * FixPotdemMonitor::CRUSHED;

  for (int i = share_of_thread.from; i < share_of_thread.to; i++) {
    const int begin = bonds.first[i], end = bonds.first[i + 1], ghosts = bonds.ghosts[i];
    if (begin == end) continue;
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2];
    double fx = 0.0, fy = 0.0, fz = 0.0;
    for (int n = begin; n < end; n++) {
      const int j = partner[n];
      const double dx = x[j][0] - xi, dy = x[j][1] - yi, dz = x[j][2] - zi;
      const double r2 = dx * dx + dy * dy + dz * dz;
      const double q = r2 * inverse_length2[n];
      if (!(q > crushed)) {    // true for NaN as well
        if (!(r2 > 0.0)) {
          share_of_thread.i = i;
          share_of_thread.j = j;
          return;
        }
        share_of_thread.crushed_i = i;
        share_of_thread.crushed = n;
      }

      // tension over distance; load: 2 c eps, the stress over E/2
      const double inverse_r = 1.0 / sqrt(r2);
      double load = q - 1.0;
      if (HINDER && coeffs[type[n]].m > 0) load *= factors[type[n]].value(sqrt(q));
      if (FAIL) {
        const double strength = FAIL == BY_BOND ? bonds.strength[n] : 1.0;
        if (load >= strength * tension[type[n]] || load <= strength * compression[type[n]])
          share_of_thread.over.push_back({i, n});
      }
      double pull = half_modulus[n] * load * inverse_r;
      if (EV) {
        const double del[3] = {-dx, -dy, -dz};
        tally(share_of_thread, i, j, eflag_either ? energy_at(n, q) : 0.0, -pull, del);
      }
      if (DAMP) {
        const double damp = bonds.dashpot[n] * inverse_r * inverse_r *
            ((v[j][0] - v[i][0]) * dx + (v[j][1] - v[i][1]) * dy + (v[j][2] - v[i][2]) * dz);
        if (ledger) note(i, j, damp * dx, damp * dy, damp * dz);
        pull += damp;
      }

      const double px = pull * dx, py = pull * dy, pz = pull * dz;
      fx += px;
      fy += py;
      fz += pz;
      if (n < ghosts) {
        f[j][0] -= px;
        f[j][1] -= py;
        f[j][2] -= pz;
      }
    }
    f[i][0] += fx;
    f[i][1] += fy;
    f[i][2] += fz;
  }
}

// viscous force on i; the rank of a ghost notes its own
void BondPotdemTruss::note(int i, int j, double fx, double fy, double fz)
{
  ledger->add(FixPotdemLedger::VISCOUS, i, fx, fy, fz);
  if (j < atom->nlocal) ledger->add(FixPotdemLedger::VISCOUS, j, -fx, -fy, -fz);
}

// the factor of penetration keeps a crushed bond stiff, perhaps too stiff for the step; without it nothing does
void BondPotdemTruss::suspect(int i, int n) const
{
  const int type = bonds.type[n], j = bonds.partner[n];
  if (type == 0) return;    // cut
  const double r = sqrt(distance2(atom->x[i], atom->x[j]));
  const double re = 1.0 / sqrt(bonds.inverse_length2[n]);
  const double stiffness = law(type, r, re, 2.0 * bonds.half_modulus[n]).stiffness;
  if (coeffs[type].m == 0)
    monitor->warn_of_crushed_bond(i, j, r / re);
  else if (monitor->pair_too_stiff_for_step(i, j, stiffness))
    monitor->warn_of_stiff_pair("The crushed bond of", i, j, stiffness);
}

void BondPotdemTruss::collapsed(int i, int j) const
{
  error->one(FLERR,
             "Bond between atoms {} and {} has length {} on step {}: its ends are at the same "
             "place or their positions "
             "are not finite; use a smaller timestep, or keep the ends apart with 'penetration' in "
             "bond_coeff",
             atom->tag[i], atom->tag[j], sqrt(distance2(atom->x[i], atom->x[j])),
             update->ntimestep);
}

void BondPotdemTruss::tally(const ThreadShare &, int i, int j, double energy, double push,
                            const double *del)
{
  ev_tally(i, j, atom->nlocal, 0, energy, push, del[0], del[1], del[2]);
}

double BondPotdemTruss::energy_at(int n, double q) const
{
  const int type = bonds.type[n];
  const double re = 1.0 / sqrt(bonds.inverse_length2[n]);
  return law(type, sqrt(q) * re, re, 2.0 * bonds.half_modulus[n]).energy;
}

POTDEM::Evaluation BondPotdemTruss::law(int type, double r, double re, double modulus) const
{
  return coeffs[type].m > 0 ? POTDEM::truss(r, re, modulus, factors[type])
                            : POTDEM::truss(r, re, modulus);
}

/* ---------------------------------------------------------------------- */

// a bond of zero stiffness and type 0 (which has no strength) until the list is rebuilt
void BondPotdemTruss::cut(int i, tagint partner)
{
  for (int n = bonds.first[i]; n < bonds.first[i + 1]; n++) {
    if (atom->tag[bonds.partner[n]] != partner) continue;
    bonds.half_modulus[n] = 0.0;
    bonds.type[n] = 0;
    if (damped) bonds.dashpot[n] = 0.0;
    if (force->bond == this) neighbor->bondlist[bonds.listed[n]][2] = 0;
  }
}

/* ---------------------------------------------------------------------- */

// the rank of a ghost does the same bond for itself
void BondPotdemTruss::add_stiffness_to(PotdemStiffness &sum, double /*ahead*/)
{
  refresh();
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = bonds.first[i]; n < bonds.first[i + 1]; n++) {
      const int j = bonds.partner[n];
      const double *a = atom->x[i], *b = atom->x[j];
      const double r = sqrt(distance2(a, b)), inverse_r = 1.0 / r;
      const double re = 1.0 / sqrt(bonds.inverse_length2[n]);
      const auto at = law(bonds.type[n], r, re, 2.0 * bonds.half_modulus[n]);
      PotdemSpring spring{{}, at.stiffness, -at.force * inverse_r, 0.0, 0.0};
      for (int k = 0; k < 3; k++) spring.n[k] = inverse_r * (b[k] - a[k]);
      if (damped) spring.viscosity = bonds.dashpot[n];
      sum.add_pair(i, j, n < bonds.ghosts[i], spring);
    }
}

/* ---------------------------------------------------------------------- */

double BondPotdemTruss::single(int type, double rsq, int i, int j, double &fforce)
{
  fforce = 0.0;
  std::fill(svector, svector + single_extra, 0.0);
  if (type <= 0) return 0.0;
  if (!history) FixPotdemBondHistory::get(lmp, "bond_style potdem/truss");
  const int owned = i < atom->nlocal ? i : j, other = owned == i ? j : i;
  const int slot = history->slot(owned, atom->tag[other]);
  if (slot < 0 || history->length(owned, slot) <= 0.0) return 0.0;
  const double r = sqrt(rsq), re = history->length(owned, slot);
  const double area = section(type, owned, slot);
  const auto at = law(type, r, re, coeffs[type].E * area);
  fforce = at.force / r;
  svector[STRAIN] = POTDEM::truss_strain(rsq / (re * re));
  svector[STRESS] = -at.force / area;
  svector[SECTION] = area;
  svector[REFERENCE] = re;
  return at.energy;
}

/* ----------------------------------------------------------------------
   fix adapt changes the values that extract() gives it, and has init() called
------------------------------------------------------------------------- */

void *BondPotdemTruss::extract(const char *str, int &dim)
{
  dim = 1;
  const std::string wanted = str;
  if (!allocated || !coeff_named(1, wanted)) return nullptr;
  if (wanted == "damping") comm->ghost_velocity = 1;    // may be zero until now
  for (const auto &one : adaptable)
    if (one.name == wanted) return one.values;
  adaptable.push_back({wanted, nullptr});
  memory->create(adaptable.back().values, atom->nbondtypes + 1, "bond:adaptable");
  show_to_adapt();
  return adaptable.back().values;
}

double *BondPotdemTruss::coeff_named(int type, const std::string &wanted)
{
  if (wanted == "E") return &coeffs[type].E;
  if (wanted == "damping") return &coeffs[type].xi;
  return nullptr;
}

void BondPotdemTruss::show_to_adapt()
{
  for (auto &one : adaptable)
    for (int type = 1; type <= atom->nbondtypes; type++)
      one.values[type] = *coeff_named(type, one.name);
}

void BondPotdemTruss::take_adapted(int type)
{
  bool changed = false;
  for (const auto &one : adaptable) {
    double &value = *coeff_named(type, one.name);
    changed = changed || value != one.values[type];
    value = one.values[type];
  }
  if (!changed) return;
  PotdemWords words(coeff_line(type));
  PotdemMaterialInput input(lmp, "bond_style potdem/truss, coefficients changed by a fix",
                            words.narg(), words.arg());
  coeffs[type] = read(input);
}

/* ---------------------------------------------------------------------- */

void BondPotdemTruss::write_restart(FILE *fp)
{
  for (int type = 1; type <= atom->nbondtypes; type++)
    potdem_write_text(fp, setflag[type] ? coeff_line(type) : "");
}

void BondPotdemTruss::read_restart(FILE *fp)
{
  allocate();
  const std::string who = "bond_style potdem/truss, coefficients in a restart file";
  for (int type = 1; type <= atom->nbondtypes; type++) {
    PotdemWords words(potdem_read_text(lmp, fp, who));
    setflag[type] = words.narg() > 0;
    if (!setflag[type]) continue;
    PotdemMaterialInput input(lmp, who, words.narg(), words.arg());
    coeffs[type] = read(input);
  }
}

// as bond_coeff takes it
std::string BondPotdemTruss::coeff_line(int type) const
{
  const Coeff &c = coeffs[type];
  std::string line = fmt::format("{:.17g} area ", c.E);
  if (c.mode == FACTOR)
    line += fmt::format("factor {:.17g}", c.area);
  else if (c.mode == LATTICE)
    line += "lattice";
  else
    line += c.area > 0.0 ? fmt::format("body density {:.17g}", c.area) : "body";
  if (c.m > 0) line += fmt::format(" penetration {}{}", c.m, c.normalized ? " normalized" : "");
  if (c.xi != 0.0) line += fmt::format(" damping {:.17g}", c.xi);
  return line;
}

void BondPotdemTruss::write_data(FILE *fp)
{
  for (int type = 1; type <= atom->nbondtypes; type++)
    utils::print(fp, "{} {}\n", type, coeff_line(type));
}

double BondPotdemTruss::memory_usage()
{
  const double per_bond = 3.0 * sizeof(int) + (damped ? 3.0 : 2.0) * sizeof(double);
  return per_bond * bonds.partner.capacity() + 2.0 * sizeof(int) * bonds.first.capacity();
}
