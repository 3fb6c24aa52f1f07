/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/pair/pair_potdem.h"

#include "core/stability/turning_point.h"
#include "lammps/glue/find_styles.h"
#include "lammps/glue/fix_potdem_refresh.h"
#include "lammps/glue/lammps_compat.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/glue/potdem_material_file.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/potdem_stiffness.h"
#include "lammps/pair/fix_potdem_contacts.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "math_extra.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairPotdemBase::PairPotdemBase(LAMMPS *lmp) :
    PairWithCutoffsBySize(lmp), sliding(false), viscous(false), rotation(0), ledger(nullptr),
    contacts(nullptr), monitor(nullptr), atom_types(0), monitored_step(0.0),
    contacts_id(FixPotdemContacts::reserve(lmp)), lost_contacts(false)
{
  writedata = 1;
  single_enable = 1;
  single_extra = PotdemCompat::columns_in_single(lmp, force->pair_style) ? NEXTRA : 0;
  svector = new double[NEXTRA];
}

PairPotdemBase::~PairPotdemBase()
{
  FixPotdemContacts::release(lmp, contacts_id);
  delete[] svector;
  for (auto &one : adaptable) memory->destroy(one.values);
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

void PairPotdemBase::allocate()
{
  allocated = 1;
  atom_types = atom->ntypes;
  const int n = atom_types + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  std::fill(&setflag[0][0], &setflag[0][0] + n * n, 0);
  std::fill(&cutsq[0][0], &cutsq[0][0] + n * n, 0.0);
  friction.assign(n * n, POTDEM::Friction());
  alarm.assign(n * n, 0.0);
}

void PairPotdemBase::settings(int narg, char **arg)
{
  PotdemInput input(lmp, fmt::format("pair_style {}", name()), narg, arg);
  while (!input.done()) {
    if (input.next_is("rotation"))
      rotation = input.logical("rotation");
    else if (!read_setting(input)) {
      input.word();
      input.unknown(setting_names());
    }
  }
}

bool PairPotdemBase::lists_materials(int narg, char **arg) const
{
  return narg > 2 && strcmp(arg[0], "*") == 0 && strcmp(arg[1], "*") == 0 &&
      PotdemMaterialFile::is(arg[2]);
}

/* ----------------------------------------------------------------------
   * *  FILE.potdem  a material or NULL for each type  what follows in pair_coeff
   the same as a pair_coeff for each type; pairs of them are mixed
------------------------------------------------------------------------- */

void PairPotdemBase::coeff_by_material(int narg, char **arg)
{
  const int ntypes = atom->ntypes;
  PotdemInput input(lmp, fmt::format("pair_coeff {}", name()), narg, arg);
  const std::vector<std::string> words(arg + 3, arg + narg);
  PotdemMaterialFile(lmp, input, arg[2]).check_list(input, words);
  const auto given = [&words](int type) {
    return words[type - 1] != "NULL";
  };
  for (int i = 1; i <= ntypes; i++) {
    if (!given(i)) continue;
    const auto type = std::to_string(i);
    std::vector<std::string> line{type, type, arg[2], words[i - 1]};
    line.insert(line.end(), words.begin() + ntypes, words.end());
    PotdemWords one(line);
    coeff(one.narg(), one.arg());
  }
  for (int i = 1; i <= ntypes; i++)
    for (int j = i + 1; j <= ntypes; j++)
      if (given(i) && given(j)) leave_to_mixing(i, j);
  show_to_adapt();
}

// hybrid/overlay gives no pairs to mix: a pair that is not set is left out there
void PairPotdemBase::leave_to_mixing(int i, int j)
{
  setflag[i][j] = 0;
  if (force->pair == this) return;
  mix(i, j);
  mix_friction(i, j);
  setflag[i][j] = 1;
}

void PairPotdemBase::set_coeff(int ilo, int ihi, int jlo, int jhi, const POTDEM::Friction &slide)
{
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      friction[at(i, j)] = friction[at(j, i)] = slide;
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0)
    error->all(FLERR, "pair_coeff {}: no pair of types I <= J in the range given", name());
  show_to_adapt();
}

/* ---------------------------------------------------------------------- */

void PairPotdemBase::init_style()
{
  potdem_refuse_respa(lmp, fmt::format("pair_style {}", name()));
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               "pair_style {} needs particle diameters, e.g. atom_style sphere or bpm/sphere",
               name());
  find_contacts();
  ledger = FixPotdemLedger::find(lmp);
  monitor = FixPotdemMonitor::ensure(lmp);
  FixPotdemRefresh::ensure(lmp);
  monitored_step = update->dt;
  find_sizes();
  find_needs();
  if (contact_only()) PotdemCompat::has_cutoffs_by_size(this, 0);
  if (rotation && !(atom->omega_flag && atom->torque_flag))
    error->all(FLERR,
               "pair_style {}: rotation needs an atom style with spin, e.g. atom_style sphere",
               name());
  if (rotation && sliding && monitor && atom->nbonds > 0)
    potdem_warn_of_rolling_bodies(lmp, fmt::format("pair_style {}", name()));
  if (sliding || viscous) comm->ghost_velocity = 1;
  neighbor->add_request(this, contact_only() ? NeighConst::REQ_SIZE : NeighConst::REQ_DEFAULT);
}

// where bonds can fail; or where a restart file has brought what contacts remember
void PairPotdemBase::find_contacts()
{
  if (lost_contacts)
    error->all(FLERR,
               "pair_style {}: fix {}, in which contacts remember where they begin, was removed "
               "with unfix: "
               "leave it, or begin anew",
               name(), contacts_id);
  const bool bonds = !potdem_find<BondMemory>(lmp).empty();
  if (bonds || modify->get_fix_by_id(contacts_id))
    contacts = FixPotdemContacts::ensure(lmp, contacts_id, this);
}

void PairPotdemBase::expect_contacts(const std::vector<PotdemNewContact> &announced)
{
  if (contacts) contacts->expect(announced);
}

void PairPotdemBase::lose_contacts()
{
  contacts = nullptr;
  lost_contacts = true;
}

// for neighbor multi with collections by size
double PairPotdemBase::atom2cut(int i)
{
  return 2.0 * atom->radius[i];
}

double PairPotdemBase::radii2cut(double ri, double rj)
{
  return ri + rj;
}

void PairPotdemBase::find_needs()
{
  sliding = false;
  for (const auto &slide : friction) sliding = sliding || slide.mu > 0.0;
  viscous = any_viscous();
  if (potdem_minimizes(lmp)) sliding = viscous = false;
}

void PairPotdemBase::find_sizes()
{
  const double none = std::numeric_limits<double>::infinity();
  const int ntypes = atom->ntypes;
  std::vector<double> mine(ntypes + 1, 0.0), radius(ntypes + 1, none), mass(ntypes + 1, none);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->radius[i] > 0.0))
      error->one(FLERR,
                 "pair_style {}: atom {} has diameter {}, it must be > 0; use set ... diameter",
                 name(), atom->tag[i], 2.0 * atom->radius[i]);
    const int type = atom->type[i];
    mine[type] = MAX(mine[type], atom->radius[i]);
    radius[type] = MIN(radius[type], atom->radius[i]);
    mass[type] = MIN(mass[type], atom->rmass[i]);
  }
  add_announced_radii(mine);
  const auto over_ranks = [this](const std::vector<double> &values, std::vector<double> &all,
                                 MPI_Op op) {
    all.resize(values.size());
    MPI_Allreduce(values.data(), all.data(), values.size(), MPI_DOUBLE, op, world);
  };
  over_ranks(mine, largest_radius, MPI_MAX);
  over_ranks(radius, least_radius, MPI_MIN);
  over_ranks(mass, least_mass, MPI_MIN);
}

// LAMMPS's way to learn of particles that fix pour and fix deposit are going to insert
void PairPotdemBase::add_announced_radii(std::vector<double> &largest) const
{
  for (const auto &fix : modify->get_fix_list())
    for (int type = 1; type <= atom->ntypes; type++) {
      int asked = type;
      const auto *const radius = static_cast<const double *>(fix->extract("radius", asked));
      if (radius) largest[type] = MAX(largest[type], *radius);
    }
}

bool PairPotdemBase::outgrown() const
{
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double radius = atom->radius[i];
    if (radius > largest_radius[type] || radius < least_radius[type] ||
        atom->rmass[i] < least_mass[type])
      return true;
  }
  return false;
}

double PairPotdemBase::reach_per_size() const
{
  double most = 0.0;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) most = MAX(most, reach(i, j, 1.0) - reach(i, j, 0.0));
  return most;
}

// types without particles have no contacts
double PairPotdemBase::init_one(int i, int j)
{
  if (!adaptable.empty()) {
    take_adapted(i, i);
    take_adapted(j, j);
    take_adapted(i, j);
  }
  if (setflag[i][j] == 0) {
    if (!setflag[i][i] || !setflag[j][j])
      error->all(FLERR,
                 "pair_style {}: coefficients for types {} and {} are not set; use pair_coeff",
                 name(), i, j);
    mix(i, j);
    mix_friction(i, j);
  }
  const double dbar = largest_radius[i] + largest_radius[j];
  return reach(i, j, dbar);
}

// the more slippery material decides; a viscosity is in parallel with the limit, so the larger one
void PairPotdemBase::mix_friction(int i, int j)
{
  const auto &a = friction[at(i, i)], &b = friction[at(j, j)];
  POTDEM::Friction mixed;
  mixed.mu = MIN(a.mu, b.mu);
  mixed.eta = MAX(a.eta, b.eta);
  mixed.automatic = a.automatic || b.automatic;
  friction[at(i, j)] = friction[at(j, i)] = mixed;
  sliding = sliding || (mixed.mu > 0.0 && !potdem_minimizes(lmp));
}

void PairPotdemBase::cannot_mix(int i, int j, const std::string &coefficient) const
{
  error->all(FLERR,
             "pair_style {}: types {} and {} have different {}, which cannot be mixed; give "
             "pair_coeff {} {} explicitly",
             name(), i, j, coefficient, i, j);
}

// a pair whose bond failed within reach of this law has the law moved inwards, so that it begins where the bond
// ended: failure creates no energy. 0: it begins where particles of this size touch
POTDEM::ContactGeometry PairPotdemBase::pairing(int i, int j, double begins) const
{
  const double ri = atom->radius[i], rj = atom->radius[j], dbar = ri + rj;
  if (begins == 0.0) return {ri, rj, dbar};
  return {ri, rj, dbar - MAX(0.0, reach(atom->type[i], atom->type[j], dbar) - begins)};
}

POTDEM::ContactGeometry PairPotdemBase::pairing(int i, int j) const
{
  return pairing(i, j, begins_at(i, j));
}

// what a pair remembers, whichever of the two has it in its list
double PairPotdemBase::begins_at(int i, int j) const
{
  if (!contacts || !contacts->any()) return 0.0;
  for (int turn = 0; turn < 2; turn++, std::swap(i, j)) {
    if (i >= atom->nlocal) continue;
    const int *const first = list->firstneigh[i], *const last = first + list->numneigh[i];
    const int *const found = std::find_if(first, last, [j](int listed) {
      return (listed & NEIGHMASK) == j;
    });
    if (found != last) return contacts->distance(i, static_cast<int>(found - first));
  }
  return 0.0;
}

/* ----------------------------------------------------------------------
   Pairs that the loop has to look at twice: nearer than any pair of these types that is neither collapsed, nor deep, nor too
   stiff for the step by itself. All others cost nothing.
------------------------------------------------------------------------- */

void PairPotdemBase::find_alarm(int i, int j)
{
  constexpr double rounding = 1e-9;
  const int pair = at(i, j);
  double nearest = (1.0 + rounding) * hard_core(pair, {0.5, 0.5, 1.0});
  if (monitor && std::isfinite(least_mass[i]) && std::isfinite(least_mass[j]))
    nearest = std::max({nearest, FixPotdemMonitor::DEEP,
                        stiff_from(i, j, largest_radius[i], largest_radius[j]),
                        stiff_from(i, j, least_radius[i], least_radius[j])});
  alarm[pair] = alarm[at(j, i)] = nearest;
}

// distance over dbar from which on inwards two of the lightest particles of these types may be too stiff
double PairPotdemBase::stiff_from(int i, int j, double ri, double rj) const
{
  constexpr int pieces = 64;
  const POTDEM::ContactGeometry partners{ri, rj, ri + rj};
  const double inner = hard_core(at(i, j), partners),
               width = (reach(i, j, ri + rj) - inner) / pieces;
  const double inverse_masses = (1.0 / least_mass[i] + 1.0 / least_mass[j]) / force->mvv2e;
  int k = pieces;
  while (k > 1 &&
         !monitor->too_stiff_for_step(
             evaluate(at(i, j), inner + (k - 0.5) * width, partners).stiffness, inverse_masses))
    k--;
  return (inner + k * width) / (ri + rj);
}

// a longer step makes more pairs doubtful; room for those that grow little by little
void PairPotdemBase::reset_dt()
{
  if (!monitor || update->dt <= monitored_step) return;
  constexpr double ahead = 1.5;
  const double step = update->dt;
  monitored_step = update->dt = ahead * step;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) find_alarm(i, j);
  update->dt = step;
}

bool PairPotdemBase::is_deep(int pair, const POTDEM::ContactGeometry &partners, double r) const
{
  return r < FixPotdemMonitor::DEEP * partners.contact && hard_core(pair, partners) == 0.0;
}

void PairPotdemBase::suspect(ThreadShare &share_of_thread, int i, int j) const
{
  if (share_of_thread.doubtful_i >= 0) return;
  const int pair = at(atom->type[i], atom->type[j]);
  const auto partners = pairing(i, j);
  const double r = distance(i, j);
  if (!is_deep(pair, partners, r) &&
      !monitor->pair_too_stiff_for_step(i, j, evaluate(pair, r, partners).stiffness))
    return;
  share_of_thread.doubtful_i = i;
  share_of_thread.doubtful_j = j;
}

void PairPotdemBase::report(const ThreadShare &share_of_thread)
{
  if (share_of_thread.i >= 0) collapsed(share_of_thread.i, share_of_thread.j);
  if (share_of_thread.doubtful_i < 0) return;
  const int i = share_of_thread.doubtful_i, j = share_of_thread.doubtful_j,
            pair = at(atom->type[i], atom->type[j]);
  const auto partners = pairing(i, j);
  const double r = distance(i, j);
  if (is_deep(pair, partners, r))
    monitor->warn_of_deep_pair(i, j, r / partners.dbar());
  else
    monitor->warn_of_stiff_pair("The contact of", i, j, evaluate(pair, r, partners).stiffness);
}

double PairPotdemBase::distance(int i, int j) const
{
  double del[3];
  MathExtra::sub3(atom->x[i], atom->x[j], del);
  return MathExtra::len3(del);
}

void PairPotdemBase::collapsed(int i, int j) const
{
  error->one(FLERR,
             "pair_style {}: atoms {} and {} are {} apart on step {}, which is not beyond the "
             "smallest distance {} of this "
             "law (or their positions are not finite); use a smaller timestep, or a law that "
             "pushes harder",
             name(), atom->tag[i], atom->tag[j], distance(i, j), update->ntimestep,
             hard_core(at(atom->type[i], atom->type[j]), pairing(i, j)));
}

/* ---------------------------------------------------------------------- */

PotdemMotion PairPotdemBase::motion() const
{
  const auto rows = [](double **array) {
    return array ? (const double(*)[3]) array[0] : nullptr;
  };
  return {rows(atom->v), rows(atom->omega), atom->radius, atom->rmass, update->dt / force->mvv2e};
}

// dissipative force share * f on i, and its reaction on j
void PairPotdemBase::note(FixPotdemLedger::Kind kind, const PotdemTouch &touch, double share,
                          const double *f)
{
  ledger->add(kind, touch.i, share * f[0], share * f[1], share * f[2]);
  if (force->newton_pair || touch.j < atom->nlocal)
    ledger->add(kind, touch.j, -share * f[0], -share * f[1], -share * f[2]);
}

void PairPotdemBase::note_torque(const PotdemTouch &touch, const double *turn)
{
  ledger->add_torque(touch.i, atom->radius[touch.i], turn);
  if (force->newton_pair || touch.j < atom->nlocal)
    ledger->add_torque(touch.j, atom->radius[touch.j], turn);
}

void PairPotdemBase::tally(const ThreadShare &, const PotdemTouch &touch, double energy,
                           const double *f)
{
  ev_tally_xyz(touch.i, touch.j, atom->nlocal, force->newton_pair, energy, 0.0, f[0], f[1], f[2],
               touch.del[0], touch.del[1], touch.del[2]);
}

/* ---------------------------------------------------------------------- */

// pair_write asks every rank for the pair of its first two particles, and prints what the first rank says
double PairPotdemBase::without_particles() const
{
  if (comm->me == 0)
    error->one(FLERR,
               "pair_style {}: pair_write needs the diameters of two particles on the first "
               "processor; create two of the diameters in question, and run it on one",
               name());
  return 0.0;
}

double PairPotdemBase::single(int i, int j, int itype, int jtype, double rsq,
                              double /*factor_coul*/, double factor_lj, double &fforce)
{
  fforce = 0.0;
  std::fill(svector, svector + single_extra, 0.0);
  if (MAX(i, j) >= atom->nlocal + atom->nghost) return without_particles();
  if (i >= atom->nlocal) std::swap(i, j);
  const double dbar = atom->radius[i] + atom->radius[j], r = sqrt(rsq);
  if (r >= reach(itype, jtype, dbar)) return 0.0;
  const auto partners = pairing(i, j);
  const int pair = at(itype, jtype);
  if (!(r > hard_core(pair, partners))) collapsed(i, j);
  const auto law = evaluate(pair, r, partners);
  fforce = factor_lj * law.force / r;
  svector[OVERLAP] = partners.contact - r;
  svector[STIFFNESS] = factor_lj * law.stiffness;
  if (sliding || viscous) dissipative(pair, {i, j, {}, r}, law.force, factor_lj);
  return factor_lj * law.energy;
}

// the columns of single() for the forces that have no potential; friction is that on i
void PairPotdemBase::dissipative(int pair, PotdemTouch touch, double elastic, double weight)
{
  for (int k = 0; k < 3; k++) touch.del[k] = atom->x[touch.i][k] - atom->x[touch.j][k];
  const auto state = motion();
  const auto partners = pairing(touch.i, touch.j);
  double normal = elastic, drag[3] = {0.0, 0.0, 0.0};
  if (viscous && touch.r < partners.contact)
    normal = with_rate(pair, elastic, touch.r, partners, potdem_rate(state, touch));
  svector[VISCOUS] = weight * (normal - elastic);
  normal *= weight;
  if (friction[pair].mu > 0.0 && normal > 0.0)
    rotation ? potdem_drag<true>(state, touch, friction[pair], normal, drag)
             : potdem_drag<false>(state, touch, friction[pair], normal, drag);
  svector[FRICTION] = sqrt(drag[0] * drag[0] + drag[1] * drag[1] + drag[2] * drag[2]);
  for (int k = 0; k < 3; k++) svector[FRICTION + 1 + k] = drag[k];
}

/* ---------------------------------------------------------------------- */

void PairPotdemBase::add_stiffness_to(PotdemStiffness &sum, double ahead)
{
  double **x = atom->x;
  const int *type = atom->type;
  const auto state = motion();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const double weight = force->special_lj[sbmask(list->firstneigh[i][jj])];
      PotdemTouch touch{i, j, {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]}, 0.0};
      touch.r = MathExtra::len3(touch.del);
      const double most = reach(type[i], type[j], atom->radius[i] + atom->radius[j]);
      if (weight == 0.0 || (touch.r >= most && ahead == 0.0)) continue;
      const double r = ahead > 0.0 ? closest(state, touch, most, ahead) : touch.r;
      if (r < most)
        sum.add_pair(i, j, force->newton_pair || j < atom->nlocal, spring(touch, r, weight));
    }
  }
}

// of two particles that approach each other and touch within a time, where they turn back
double PairPotdemBase::closest(const PotdemMotion &state, const PotdemTouch &touch, double most,
                               double ahead) const
{
  const double rate = potdem_rate(state, touch);
  if (rate >= 0.0 || touch.r + rate * ahead >= most) return touch.r;
  const int i = touch.i, j = touch.j, pair = at(atom->type[i], atom->type[j]);
  const auto partners = pairing(i, j);
  const double mass = atom->rmass[i] * atom->rmass[j] / (atom->rmass[i] + atom->rmass[j]);
  return POTDEM::turning_point(MIN(touch.r, most), hard_core(pair, partners),
                               0.5 * force->mvv2e * mass * rate * rate, [&](double r) {
                                 return evaluate(pair, r, partners);
                               });
}

// at the distance r
PotdemSpring PairPotdemBase::spring(const PotdemTouch &touch, double r, double weight) const
{
  const int i = touch.i, j = touch.j, pair = at(atom->type[i], atom->type[j]);
  const auto partners = pairing(i, j);
  if (!(r > hard_core(pair, partners))) collapsed(i, j);
  const auto law = evaluate(pair, r, partners);
  PotdemSpring spring{{}, weight * law.stiffness, -weight * law.force / r, 0.0, 0.0};
  for (int k = 0; k < 3; k++) spring.n[k] = touch.del[k] / touch.r;
  if (viscous && r < partners.contact)
    spring.viscosity = weight * (with_rate(pair, law.force, r, partners, -1.0) - law.force);
  if (law.force > 0.0) spring.friction = sticking_viscosity(pair, r, partners);
  return spring;
}

// force over velocity of sticking friction; where it turns spheres as well, as their mass at the contact feels it.
// 'auto' follows the step and does not limit it
double PairPotdemBase::sticking_viscosity(int pair, double r,
                                          const POTDEM::ContactGeometry &partners) const
{
  const auto &slide = friction[pair];
  if (slide.mu == 0.0 || slide.automatic) return 0.0;
  const double arm = r / partners.dbar();    // over the radius
  return rotation ? slide.eta / POTDEM::sliding_mass(arm, POTDEM::SPHERE_INERTIA) : slide.eta;
}

/* ----------------------------------------------------------------------
   fix adapt changes the values that extract() gives it, and has init_one() called
------------------------------------------------------------------------- */

void *PairPotdemBase::extract(const char *str, int &dim)
{
  dim = 2;
  const std::string wanted = str;
  if (!allocated || !coeff_named(at(1, 1), wanted)) return nullptr;
  if (wanted == "mu" || wanted == "viscous") comm->ghost_velocity = 1;    // may be zero until now
  if (wanted == "eta")
    for (const auto &slide : friction)
      if (slide.automatic)
        error->all(FLERR,
                   "pair_style {}: eta is 'auto' for some types and cannot be changed by a fix",
                   name());
  for (const auto &one : adaptable)
    if (one.name == wanted) return one.values;
  adaptable.push_back({wanted, nullptr});
  memory->create(adaptable.back().values, atom_types + 1, atom_types + 1, "pair:adaptable");
  show_to_adapt();
  return adaptable.back().values;
}

double *PairPotdemBase::coeff_named(int pair, const std::string &wanted)
{
  if (wanted == "mu") return &friction[pair].mu;
  if (wanted == "eta") return &friction[pair].eta;
  return coeff_of_law(pair, wanted);
}

void PairPotdemBase::show_to_adapt()
{
  for (auto &one : adaptable)
    for (int i = 1; i <= atom_types; i++)
      for (int j = 1; j <= atom_types; j++)
        one.values[i][j] = *coeff_named(at(MIN(i, j), MAX(i, j)), one.name);
}

// mixed pairs follow their types
void PairPotdemBase::take_adapted(int i, int j)
{
  if (!setflag[i][j]) return;
  bool changed = false;
  for (const auto &one : adaptable) {
    double &value = *coeff_named(at(i, j), one.name);
    changed = changed || value != one.values[i][j];
    value = one.values[i][j];
  }
  if (!changed) return;
  PotdemWords words(coeff_line(at(i, j)));
  PotdemInput input(lmp, fmt::format("pair_style {}, coefficients changed by a fix", name()),
                    words.narg(), words.arg());
  reread(at(i, j), input);
  find_needs();
  const double now = reach(i, j, largest_radius[i] + largest_radius[j]);
  if (now * now > cutsq[i][j])
    error->all(FLERR,
               "pair_style {}: coefficients changed by a fix make types {} and {} interact up to a "
               "distance {}, beyond {}, for which the neighbour list is made; begin with the "
               "coefficients that reach furthest",
               name(), i, j, now, sqrt(cutsq[i][j]));
}

/* ---------------------------------------------------------------------- */

void PairPotdemBase::write_restart_settings(FILE *fp)
{
  potdem_write_text(fp,
                    fmt::format("shift {} mix {} rotation {}{}", offset_flag, mix_flag,
                                rotation ? "yes" : "no", setting_text()));
}

// what pair_modify said comes first
void PairPotdemBase::read_restart_settings(FILE *fp)
{
  auto words = utils::split_words(potdem_read_text(lmp, fp, fmt::format("pair_style {}", name())));
  offset_flag = utils::inumeric(FLERR, words.at(1), true, lmp);
  mix_flag = utils::inumeric(FLERR, words.at(3), true, lmp);
  words.erase(words.begin(), words.begin() + 4);
  PotdemWords rest(words);
  settings(rest.narg(), rest.arg());
}

// a line for each pair of types, empty where it was not given
void PairPotdemBase::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      potdem_write_text(fp, setflag[i][j] ? coeff_line(at(i, j)) : "");
}

void PairPotdemBase::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  const auto who = fmt::format("pair_style {}, coefficients in a restart file", name());
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      PotdemWords words(potdem_read_text(lmp, fp, who));
      setflag[i][j] = words.narg() > 0;
      if (!setflag[i][j]) continue;
      PotdemInput input(lmp, who, words.narg(), words.arg());
      reread(at(i, j), input);
      friction[at(j, i)] = friction[at(i, j)];
    }
}

/* ---------------------------------------------------------------------- */

// as pair_coeff takes it
std::string PairPotdemBase::coeff_line(int pair) const
{
  const auto &slide = friction[pair];
  std::string line = coeff_text(pair);
  if (slide.mu != 0.0 || slide.eta != 0.0 || slide.automatic)
    line += fmt::format(" friction {:.17g} {}", slide.mu,
                        slide.automatic ? "auto" : fmt::format("{:.17g}", slide.eta));
  return line;
}

void PairPotdemBase::write_data(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++) utils::print(fp, "{} {}\n", i, coeff_line(at(i, i)));
}

void PairPotdemBase::write_data_all(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      utils::print(fp, "{} {} {}\n", i, j, coeff_line(at(i, j)));
}
