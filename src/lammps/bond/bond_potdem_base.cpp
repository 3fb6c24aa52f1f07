/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/bond/bond_potdem_base.h"

#include "core/laws/dashpot.h"
#include "core/laws/truss.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_bond_history.h"
#include "lammps/glue/fix_potdem_refresh.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/potdem_stiffness.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

// LAMMPS's own allowance for the stretch of bonds in its communication cutoff
static constexpr double STRETCH_ALLOWANCE = 1.5;

static double distance2(const double *a, const double *b)
{
  const double dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
  return dx * dx + dy * dy + dz * dz;
}

/* ---------------------------------------------------------------------- */

BondPotdemBase::BondPotdemBase(LAMMPS *lmp, const std::string &name, int nstate) :
    Bond(lmp), name(name), style("bond_style " + name), bonds(lmp, nstate), volume(lmp, bonds),
    softening(lmp, bonds), onset(lmp, bonds, softening), any_penetration(false), damped(false),
    ledger(nullptr), history(nullptr), lost(false), monitor(nullptr), generation(-1),
    new_bonds(true)
{
  potdem_needs_setup(lmp);
  partial_flag = 1;
  writedata = 1;
  single_extra = PotdemCompat::columns_in_single(lmp, force->bond_style) ? NEXTRA : 0;
  svector = new double[NEXTRA];
}

BondPotdemBase::~BondPotdemBase()
{
  potdem_needs_setup(lmp);
  delete[] svector;
  if (allocated) memory->destroy(setflag);
  for (auto &one : adaptable) memory->destroy(one.values);
}

void BondPotdemBase::settings(int narg, char **arg)
{
  if (narg > 0) error->all(FLERR, "{}: unknown keyword '{}', it takes none", style, arg[0]);
}

void BondPotdemBase::allocate()
{
  allocated = 1;
  const int n = atom->nbondtypes + 1;
  if (n > std::numeric_limits<PotdemBondNetwork::Type>::max())
    error->all(FLERR, "{}: {} bond types are too many", style, atom->nbondtypes);
  memory->create(setflag, n, "bond:setflag");
  std::fill(setflag, setflag + n, 0);
  beside.assign(n, BesideLaw());
  make_laws(atom->nbondtypes);
}

void BondPotdemBase::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  PotdemMaterialInput input(lmp, "bond_coeff " + name, narg, arg);
  int lo, hi;
  utils::bounds(FLERR, input.word(), 1, atom->nbondtypes, lo, hi, error);
  read(input, lo, hi);
  std::fill(setflag + lo, setflag + hi + 1, 1);
  show_to_adapt();
}

bool BondPotdemBase::read_beside(PotdemInput &input, BesideLaw &more) const
{
  if (!input.next_is("damping")) return false;
  more.xi = input.in_range("damping xi", POTDEM::nonnegative());
  return true;
}

/* ---------------------------------------------------------------------- */

void BondPotdemBase::init_style()
{
  check_settings();
  history = FixPotdemBondHistory::ensure(lmp, style);
  lost = false;
  for (int type = 1; type <= atom->nbondtypes; type++)
    if (owns(type)) beside[type].area.prepare(history);
  announce_contacts();
  ledger = FixPotdemLedger::find(lmp);
  monitor = FixPotdemMonitor::ensure(lmp);
  FixPotdemRefresh::ensure(lmp);
  new_bonds = true;

  reinit();
  if (strengths.any_softens()) history->keep_softening();
  set_communication();
}

void BondPotdemBase::check_settings() const
{
  potdem_refuse_respa(lmp, style);
  if (!atom->radius_flag)
    error->all(FLERR, "{} needs particle diameters, e.g. atom_style bpm/sphere", style);
  if (force->newton_bond)
    error->all(FLERR,
               "{} needs newton off for bonds: make the bonds with potdem_bonds, "
               "or put 'newton on off' before the box is created",
               style);
  const double *lj = force->special_lj, *coul = force->special_coul;
  if (lj[1] != 0.0 || lj[2] != 1.0 || lj[3] != 1.0 || coul[2] != 1.0 || coul[3] != 1.0)
    error->all(FLERR,
               "{} needs 'special_bonds lj 0 1 1 coul 0 1 1', as potdem_bonds sets it: "
               "bonded pairs do not touch, all others do",
               style);
}

// LAMMPS has the pair style initialised before this
void BondPotdemBase::announce_contacts()
{
  for (auto *const contacts : potdem_find<ContactMemory>(lmp))
    contacts->expect_contacts(history->new_contacts);
  history->new_contacts.clear();
}

// what fix adapt calls when it has changed coefficients, at any step
void BondPotdemBase::reinit()
{
  for (int type = 1; type <= atom->nbondtypes; type++) take_adapted(type);
  find_needs();
  if (damped) comm->ghost_velocity = 1;
  forget_packed();
}

void BondPotdemBase::find_needs()
{
  any_penetration = damped = false;
  std::vector<double> moduli(atom->nbondtypes + 1, 0.0), volume_moduli = moduli;
  for (int type = 1; type <= atom->nbondtypes; type++) {
    if (!owns(type)) continue;
    make_kernel(type);
    moduli[type] = modulus(type);
    volume_moduli[type] = beside[type].area.volume_modulus(modulus(type));
    if (has_penetration(type)) any_penetration = true;
    if (beside[type].xi > 0.0 && !potdem_minimizes(lmp)) damped = true;
  }
  volume.begin(volume_moduli);
  strengths.begin(moduli);
  for (const auto *criterion : potdem_find<FailureCriterion>(lmp))
    criterion->give_strengths_to(strengths);
}

/* ----------------------------------------------------------------------
   ghosts must reach the far end of every bond, stretched; a user's own comm_modify cutoff is kept if
   it covers the bonds as they are. What this style has set itself is known as such by the bonds' memory
------------------------------------------------------------------------- */

void BondPotdemBase::set_communication()
{
  const double longest = history->longest();
  const double need = longest + neighbor->skin;
  const bool users = comm->cutghostuser > 0.0 && !history->follows_bonds();
  if (users && comm->cutghostuser < need)
    error->all(FLERR,
               "{}: the longest bond ({}) and the neighbour skin ({}) are beyond the "
               "communication cutoff {}; increase it with comm_modify cutoff, or leave it out",
               style, longest, neighbor->skin, comm->cutghostuser);
  if (users) return;
  const double contacts = force->pair ? force->pair->cutforce : 0.0;
  history->reach_at_most(MAX(STRETCH_ALLOWANCE * longest, contacts) + neighbor->skin);
}

bool BondPotdemBase::has_new_bonds() const
{
  return history->has_new_bonds();
}

void BondPotdemBase::lose_memory()
{
  history = nullptr;
  lost = true;
}

void BondPotdemBase::expect_new_bonds()
{
  new_bonds = true;
  set_communication();
}

void BondPotdemBase::masses_changed()
{
  forget_packed();
}

void BondPotdemBase::return_state()
{
  if (history) bonds.return_state(*history);
}

void BondPotdemBase::forget_packed()
{
  return_state();
  generation = -1;
}

// its coefficients may have been given to another style of hybrid later
bool BondPotdemBase::owns(int type) const
{
  return type > 0 && allocated && setflag[type] && potdem_serves(force, this, type);
}

// each bond has its own. By this LAMMPS would only guess how far ghosts must reach, and warn of what is set here
double BondPotdemBase::equilibrium_distance(int /*type*/)
{
  return 0.0;
}

/* ----------------------------------------------------------------------
   after each rebuild of LAMMPS's bond list: what the loop needs, contiguous and in its order
------------------------------------------------------------------------- */

void BondPotdemBase::follow_lists()
{
  if (generation == history->generation) return;
  pack();
  choose_loop();
}

void BondPotdemBase::pack()
{
  generation = history->generation;
  if (new_bonds) {
    measure_new_bonds();
    find_areas();
    new_bonds = false;
  }
  std::vector<char> ours(atom->nbondtypes + 1, 0);
  for (int type = 1; type <= atom->nbondtypes; type++) ours[type] = owns(type);
  bonds.order(ours, damped, strengths.kind() == BondStrengths::BY_BOND);
  volume.make_room();
  softening.make_room(*history);
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = bonds.first[i]; n < bonds.first[i + 1]; n++) pack_bond(i, n);
  bonds.take_state(*history);
}

void BondPotdemBase::pack_bond(int i, int n)
{
  const int j = bonds.partner[n], type = bonds.type[n];
  const int slot = history->slot(i, atom->tag[j]);
  const auto part = history->dilatation(i, slot);
  check_solid(type, part.solid);
  if (volume.exists()) volume.take(n, part);
  if (history->keeps_softening()) softening.take(i, n, history->softening(i, slot));
  const double re = history->length(i, slot);
  const double EA = modulus(type) * section(type, i, j, slot);
  bonds.inverse_length2[n] = 1.0 / (re * re);
  bonds.half_modulus[n] = 0.5 * EA;
  if (j >= atom->nlocal) check_reach(i, j, re);
  if (monitor && monitor->pair_too_stiff_for_step(i, j, EA / re))
    monitor->warn_of_stiff_pair("The bond of", i, j, EA / re);
  if (!bonds.strength.empty())
    bonds.strength[n] = strengths.of_bond(type, atom->tag[i], atom->tag[j]);
  if (!damped) return;
  const double mi = atom->rmass[i], mj = atom->rmass[j];
  bonds.dashpot[n] = POTDEM::dashpot(beside[type].xi, EA / re, force->mvv2e * mi * mj / (mi + mj));
}

// sections and weights belong together, and to the nu that they were found for: 1 + nu, 0 for that of bonds alone
void BondPotdemBase::check_solid(int type, double found) const
{
  const auto &area = beside[type].area;
  if (found == (area.has_volume_term() ? 1.0 + area.poisson() : 0.0)) return;
  error->one(FLERR,
             "{}: the sections of bond type {} were found for nu = {:g}, and bond_coeff says {:g}: "
             "they stay as long as the bonds do, so give that nu, or make the bonds anew",
             style, type, found > 0.0 ? found - 1.0 : POTDEM::areas::POISSON, area.poisson());
}

// before the bond's far end leaves the ghosts and LAMMPS can only say that an atom is missing
void BondPotdemBase::check_reach(int i, int j, double re) const
{
  const double r = sqrt(distance2(atom->x[i], atom->x[j]));
  const double set = history->follows_bonds() ? history->widest : comm->cutghostuser;
  const double cutoff = MAX(set, neighbor->cutneighmax);
  if (r + neighbor->skin > cutoff)
    error->one(
        FLERR,
        "Bond between atoms {} and {} is {} long (reference {}): with the neighbour skin {} it is "
        "beyond the communication cutoff {}; increase it with comm_modify cutoff, or let bonds "
        "fail "
        "with fix potdem/failure",
        atom->tag[i], atom->tag[j], r, re, neighbor->skin, cutoff);
}

// at set-up it is worth a word: a body that is strained already is measured as it is
void BondPotdemBase::measure_new_bonds()
{
  bigint ends = history->measure_new_bonds(), all;
  if (!update->setupflag) return;
  MPI_Allreduce(&ends, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all > 0 && comm->me == 0)
    utils::logmesg(lmp, "{}: {} bonds that had no reference length take their present one\n", style,
                   all / 2);
}

void BondPotdemBase::find_areas()
{
  for (int type = 1; type <= atom->nbondtypes; type++)
    if (owns(type)) beside[type].area.find(lmp, history, style, type);
}

/* ---------------------------------------------------------------------- */

void BondPotdemBase::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  std::vector<ThreadShare> all{share(0, begin_work(), atom->f, nullptr, nullptr)};
  work(all[0]);
  end_work(all);
}

// the atoms whose bonds there are
int BondPotdemBase::begin_work()
{
  follow_lists();
  if (volume.exists()) volume.find_dilatations(*history);
  softening.follow(*history, !potdem_minimizes(lmp));
  return atom->nlocal;
}

void BondPotdemBase::end_work(const std::vector<ThreadShare> &shares)
{
  over.clear();
  for (const auto &one : shares) collect(one);
  bonds.state_changes();
}

void BondPotdemBase::collect(const ThreadShare &share)
{
  if (share.i >= 0) collapsed(share.i, share.j);
  if (monitor && share.crushed >= 0) suspect(share.crushed_i, share.crushed);
  over.insert(over.end(), share.over.begin(), share.over.end());
  energy += share.energy;
  for (int k = 0; k < 6; k++) virial[k] += share.virial[k];
}

// the rank of a ghost does the same bond for itself
void BondPotdemBase::take_damage(const ThreadShare &share)
{
  const auto *const end = softening.end(share.to);
  for (const auto *bond = softening.begin(share.from); bond != end; ++bond) {
    const int i = bond->i, n = bond->n, j = bonds.partner[n], type = bonds.type[n];
    const double loss = bond->loss();
    if (loss == 0.0 || type == 0) continue;
    const double re = bonds.length(n), r = sqrt(bond->q) * re;
    const auto at = evaluate(type, r, re, bonds.modulus(n), bonds.state_of(n));
    double del[3], apart[3];
    MathExtra::sub3(atom->x[j], atom->x[i], del);
    double pull = loss * at.force / r;
    if (evflag) tally(share, i, j, -loss * at.energy, pull, del);
    if (damped) {
      MathExtra::sub3(atom->v[j], atom->v[i], apart);
      const double damp = loss * bonds.dashpot[n] / (r * r) * MathExtra::dot3(apart, del);
      if (ledger) note(i, j, -damp * del[0], -damp * del[1], -damp * del[2]);
      pull -= damp;
    }
    for (int k = 0; k < 3; k++) {
      share.f[i][k] += pull * del[k];
      if (j < atom->nlocal) share.f[j][k] -= pull * del[k];
    }
  }
}

// viscous force on i; the rank of a ghost notes its own
void BondPotdemBase::note(int i, int j, double fx, double fy, double fz)
{
  ledger->add(FixPotdemLedger::VISCOUS, i, fx, fy, fz);
  if (j < atom->nlocal) ledger->add(FixPotdemLedger::VISCOUS, j, -fx, -fy, -fz);
}

// the factor of penetration keeps a crushed bond stiff, perhaps too stiff for the step; without it nothing does
void BondPotdemBase::suspect(int i, int n)
{
  const int type = bonds.type[n], j = bonds.partner[n];
  if (type == 0) return;    // cut
  const double r = sqrt(distance2(atom->x[i], atom->x[j])), re = bonds.length(n);
  const double stiffness = evaluate(type, r, re, bonds.modulus(n), bonds.state_of(n)).stiffness;
  if (!has_penetration(type))
    monitor->warn_of_crushed_bond(i, j, r / re);
  else if (monitor->pair_too_stiff_for_step(i, j, stiffness))
    monitor->warn_of_stiff_pair("The crushed bond of", i, j, stiffness);
}

void BondPotdemBase::collapsed(int i, int j) const
{
  error->one(FLERR,
             "Bond between atoms {} and {} has length {} on step {}: its ends are at the same "
             "place or their positions "
             "are not finite; use a smaller timestep, or keep the ends apart with 'penetration' in "
             "bond_coeff",
             atom->tag[i], atom->tag[j], sqrt(distance2(atom->x[i], atom->x[j])),
             update->ntimestep);
}

void BondPotdemBase::tally(const ThreadShare &, int i, int j, double of_bond, double pull,
                           const double *del)
{
  ev_tally(i, j, atom->nlocal, 0, of_bond, -pull, del[0], del[1], del[2]);
}

void BondPotdemBase::expect_cut(int i, tagint partner)
{
  const int slot = history->slot(i, partner), type = atom->bond_type[i][slot];
  if (!volume.exists(type)) return;
  const double *const far = atom->x[domain->closest_image(i, atom->map(partner))];
  volume.expect_cut(i, type, part_of_volume(i, slot, distance2(atom->x[i], far)));
}

void BondPotdemBase::cut(int i, tagint partner, double r2)
{
  const int slot = history->slot(i, partner), type = atom->bond_type[i][slot];
  if (volume.exists(type)) volume.cut(i, type, part_of_volume(i, slot, r2));
  softening.remove(i, partner);
  bonds.cut(i, partner, force->bond == this);
}

// of a bond of owned atom i, in the root of its volume term
double BondPotdemBase::part_of_volume(int i, int slot, double r2) const
{
  const double re = history->length(i, slot);
  return history->dilatation(i, slot).own * POTDEM::truss_strain(r2 / (re * re));
}

/* ---------------------------------------------------------------------- */

// the rank of a ghost does the same bond for itself
void BondPotdemBase::add_stiffness_to(PotdemStiffness &sum, double /*ahead*/)
{
  follow_lists();
  volume.add_stiffness_to(sum, *history);
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = bonds.first[i]; n < bonds.first[i + 1]; n++) {
      const int j = bonds.partner[n];
      const double *a = atom->x[i], *b = atom->x[j];
      const double r = sqrt(distance2(a, b)), inverse_r = 1.0 / r;
      const auto at =
          evaluate(bonds.type[n], r, bonds.length(n), bonds.modulus(n), bonds.state_of(n));
      PotdemSpring spring{{}, at.stiffness, -at.force * inverse_r, 0.0, 0.0};
      for (int k = 0; k < 3; k++) spring.n[k] = inverse_r * (b[k] - a[k]);
      if (damped) spring.viscosity = bonds.dashpot[n];
      sum.add_pair(i, j, n < bonds.ghosts[i], spring);
    }
}

/* ---------------------------------------------------------------------- */

double BondPotdemBase::single(int type, double rsq, int i, int j, double &fforce)
{
  fforce = 0.0;
  std::fill(svector, svector + single_extra, 0.0);
  if (type <= 0) return 0.0;
  if (!history) history = FixPotdemBondHistory::get(lmp, style);
  const int owned = i < atom->nlocal ? i : j, other = owned == i ? j : i;
  const int slot = history->slot(owned, atom->tag[other]);
  if (slot < 0 || history->length(owned, slot) <= 0.0) return 0.0;
  const double r = sqrt(rsq), re = history->length(owned, slot);
  auto at = own_evaluation(type, r, owned, other, slot);
  const double strain = POTDEM::truss_strain(rsq / (re * re));
  const double damage = history->softening(owned, slot).damage;
  if (strain > 0.0) {
    at.force *= 1.0 - damage;
    at.energy *= 1.0 - damage;
  }
  const double of_volume = volume.exists(type)
      ? volume.tension(type, owned, other, history->dilatation(owned, slot))
      : 0.0;
  fforce = at.force / r - of_volume / (re * re);
  svector[STRAIN] = strain;
  svector[SECTION] = section(type, owned, other, slot);
  svector[STRESS] = -at.force / svector[SECTION];
  svector[REFERENCE] = re;
  svector[DAMAGE] = damage;
  return at.energy + 0.5 * strain * of_volume;
}

double BondPotdemBase::section(int type, int i, int j, int slot) const
{
  return beside[type].area.section(*history, i, slot, atom->radius[i] + atom->radius[j]);
}

// without what it has of the change of volume
POTDEM::Evaluation BondPotdemBase::own_evaluation(int type, double r, int i, int j, int slot)
{
  return evaluate(type, r, history->length(i, slot), modulus(type) * section(type, i, j, slot),
                  state_of(i, j, slot));
}

const double *BondPotdemBase::state_of(int i, int j, int slot)
{
  const int n = bonds.state_is_newer() ? bonds.find(i, j) : -1;
  return n >= 0 ? bonds.state_of(n) : history->state(i, slot);
}

// with what damage has taken of it
double BondPotdemBase::energy_of_bond(int type, double r2, int i, int j)
{
  const int slot = history->slot(i, atom->tag[j]);
  const double stored = own_evaluation(type, sqrt(r2), i, j, slot).energy;
  const auto law = history->softening(i, slot);
  if (!law.begun()) return stored;
  const double re = history->length(i, slot),
               modulus_now = modulus(type) * section(type, i, j, slot);
  return (r2 > re * re ? 1.0 - law.damage : 1.0) * stored + law.lost() * modulus_now * re;
}

std::vector<BreakableBonds::Reached>
BondPotdemBase::reached_by_cracks(const CrackQuestion &question)
{
  return onset.find(question, modulus(question.type), over, generation);
}

// the other parts would take an open crack for a strain of the material
const char *BondPotdemBase::cannot_soften(int type) const
{
  if (volume.exists(type)) return "nu";
  return has_penetration(type) ? "penetration" : nullptr;
}

void BondPotdemBase::soften(int i, int j, const POTDEM::Softening &law)
{
  softening.add(*history, i, j, law);
}

/* ----------------------------------------------------------------------
   fix adapt changes the values that extract() gives it, and has init() called
------------------------------------------------------------------------- */

void *BondPotdemBase::extract(const char *str, int &dim)
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

double *BondPotdemBase::coeff_named(int type, const std::string &wanted)
{
  if (wanted == "damping") return &beside[type].xi;
  return potdem_coefficient(rows(type), wanted);
}

void BondPotdemBase::show_to_adapt()
{
  for (auto &one : adaptable)
    for (int type = 1; type <= atom->nbondtypes; type++)
      one.values[type] = *coeff_named(type, one.name);
}

void BondPotdemBase::take_adapted(int type)
{
  bool changed = false;
  for (const auto &one : adaptable) {
    double &value = *coeff_named(type, one.name);
    changed = changed || value != one.values[type];
    value = one.values[type];
  }
  if (!changed) return;
  PotdemWords words(coeff_line(type));
  PotdemMaterialInput input(lmp, style + ", coefficients changed by a fix", words.narg(),
                            words.arg());
  read(input, type, type);
}

/* ---------------------------------------------------------------------- */

void BondPotdemBase::write_restart(FILE *fp)
{
  for (int type = 1; type <= atom->nbondtypes; type++)
    potdem_write_text(fp, setflag[type] ? coeff_line(type) : "");
}

void BondPotdemBase::read_restart(FILE *fp)
{
  allocate();
  const std::string who = style + ", coefficients in a restart file";
  for (int type = 1; type <= atom->nbondtypes; type++) {
    PotdemWords words(potdem_read_text(lmp, fp, who));
    setflag[type] = words.narg() > 0;
    if (!setflag[type]) continue;
    PotdemMaterialInput input(lmp, who, words.narg(), words.arg());
    read(input, type, type);
  }
}

std::string BondPotdemBase::coeff_line(int type)
{
  PotdemLawRows values, options;
  for (const auto &row : rows(type))
    (row.kind == PotdemLawRow::REQUIRED ? values : options).push_back(row);
  std::string line = potdem_text(values) + " " + beside[type].area.text();
  const std::string keywords = potdem_text(options);
  if (!keywords.empty()) line += " " + keywords;
  if (beside[type].xi != 0.0) line += fmt::format(" damping {:.17g}", beside[type].xi);
  return line;
}

void BondPotdemBase::write_data(FILE *fp)
{
  for (int type = 1; type <= atom->nbondtypes; type++)
    utils::print(fp, "{} {}\n", type, coeff_line(type));
}

double BondPotdemBase::memory_usage()
{
  return bonds.memory_usage() + volume.memory_usage() + softening.memory_usage() +
      onset.memory_usage();
}
