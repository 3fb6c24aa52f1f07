/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Walls on LAMMPS regions (thesis 5.3): Hertz under a soft layer (core/laws/hertz_wall.h), or any law of contact. */

#include "lammps/wall/fix_potdem_wall_region.h"

#include "core/stability/turning_point.h"
#include "lammps/glue/potdem_input.h"
#include "lammps/glue/potdem_law_io.h"
#include "lammps/glue/potdem_restart_block.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/potdem_stiffness.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "math_extra.h"
#include "neighbor.h"
#include "region.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;
using namespace FixConst;

// friction of a particle that touches several faces: at most so many rounds, to this fraction of its limit
static constexpr int MAX_ROUNDS = 200;
static constexpr double ROUNDING = 1e-14;
// particles that a thread does before it leaves the next ones to another: those that touch come together
static constexpr std::size_t PIECE = 64;
// a normal within this of the plane z = 0 lies in it
static constexpr double UPRIGHT = 1e-9;

/* ---------------------------------------------------------------------- */

FixPotdemWallRegion::FixPotdemWallRegion(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), region(nullptr), surface(lmp), ledger(nullptr), monitor(nullptr),
    rub(nullptr), rotation(false), inertia(POTDEM::SPHERE_INERTIA), step(0.0), listed(-1), mine(),
    total(), summed(false)
{
  potdem_needs_setup(lmp);
  scalar_flag = vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extscalar = extvector = 1;
  energy_global_flag = 1;
  virial_global_flag = virial_peratom_flag = 1;
  dynamic_group_allow = 1;
  restart_global = 1;
  read(narg - 3, arg + 3);
}

FixPotdemWallRegion::~FixPotdemWallRegion()
{
  potdem_needs_setup(lmp);
}

/* ----------------------------------------------------------------------
   REGION  E nu  particle E nu  [layer gamma_over_r m | layer none] [viscous H]
   REGION  law NAME  its coefficients and keywords as in pair_coeff
   both:  [friction mu ...] [rolling ...] [twisting ...] [restitution e] [rotation no|yes|disc]
------------------------------------------------------------------------- */

void FixPotdemWallRegion::read(int narg, char **arg)
{
  PotdemMaterialInput input(lmp, "fix potdem/wall/region", narg, arg);
  region_id = input.word();
  if (!domain->get_region_by_id(region_id))
    input.fail(fmt::format("there is no region '{}'", region_id));
  input.next_is("law") ? read_named(input) : read_wall<POTDEM::HertzWall>(input);
}

void FixPotdemWallRegion::read_named(PotdemMaterialInput &input)
{
  std::vector<std::string> names;
#define POTDEM_TRY(name, Law)                                     \
  if (input.next_is(#name)) return read_wall<POTDEM::Law>(input); \
  names.emplace_back(#name);
  CONTACT_LAWS(POTDEM_TRY)
#undef POTDEM_TRY
  const auto last = names.back();
  names.pop_back();
  input.word();
  input.unknown(utils::join_words(names, ", ") + " or " + last +
                " (Hertz under a soft layer is what E and nu without 'law' give)");
}

template <class Law> void FixPotdemWallRegion::read_wall(PotdemMaterialInput &input)
{
  PotdemWallLaw<Law> wall{};
  const auto of_law = potdem_rows(wall.law);
  potdem_read_required(input, of_law);
  potdem_complete(wall.law);
  while (!input.done())
    if (!potdem_read_option(input, of_law) && !potdem_read_rate<Law>(input, PotdemRate(), rate))
      read_common(input, potdem_law_names<Law>(of_law));
  potdem_check_friction<Law>(input, friction, rotation);
  wall.kernel = wall.law.kernel(false);
  law = wall;
}

void FixPotdemWallRegion::read_common(PotdemMaterialInput &input, const std::string &names)
{
  if (input.next_is("rotation")) {
    read_rotation(input);
  } else if (!potdem_read_friction(input, friction)) {
    input.word();
    input.unknown(names + POTDEM_FRICTION_NAMES + ", twisting or rotation");
  }
}

void FixPotdemWallRegion::read_rotation(PotdemInput &input)
{
  rotation = !input.next_is("no");
  if (!rotation || input.next_is("yes")) return;
  if (!input.next_is("disc"))
    input.fail(fmt::format("rotation must be no, yes or disc, not '{}'", input.word()));
  if (domain->dimension != 2) input.fail("rotation disc is for two dimensions, use rotation yes");
  inertia = POTDEM::DISC_INERTIA;
}

// here, because a fix cannot be made while another one is
void FixPotdemWallRegion::post_constructor()
{
  FixPotdemMonitor::ensure(lmp);
  const int state = potdem_friction_state(friction),
            faces = domain->get_region_by_id(region_id)->cmax;
  if (state > 0) memory = std::make_unique<PotdemWallMemory>(lmp, id, faces, state);
}

int FixPotdemWallRegion::setmask()
{
  return POST_FORCE | MIN_POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixPotdemWallRegion::init()
{
  potdem_refuse_respa(lmp, "fix potdem/wall/region");
  ledger = FixPotdemLedger::find(lmp);
  monitor = FixPotdemMonitor::ensure(lmp);
  region = domain->get_region_by_id(region_id);
  if (!region)
    error->all(FLERR, "Region {} for fix potdem/wall/region {} does not exist", region_id, id);
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               "Fix potdem/wall/region {} needs particle diameters, e.g. atom_style sphere or "
               "bpm/sphere",
               id);
  surface.init(region);
  surface.go_on(way_in_file);
  way_in_file.clear();
  listed = -1;
  if (memory) memory->init();
  friction_kernel = make_friction_kernel();
  check_rotation();
  if (potdem_friction_mu(friction) > 0.0 && potdem_friction_is_auto(friction))
    potdem_require_last(lmp, this, "balances the other forces on a particle ('friction auto')",
                        "^potdem/");
}

void FixPotdemWallRegion::check_rotation()
{
  if (!rotation) return;
  if (!(atom->omega_flag && atom->torque_flag))
    error->all(FLERR,
               "Fix potdem/wall/region {}: rotation needs an atom style with spin, e.g. atom_style "
               "sphere",
               id);
  if (!monitor || !potdem_friction_acts(friction)) return;
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal && atom->num_bond; i++)
    if (atom->mask[i] & groupbit)
      mine |= std::any_of(atom->bond_type[i], atom->bond_type[i] + atom->num_bond[i], [](int type) {
        return type > 0;
      });
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (any) potdem_warn_of_rolling_bodies(lmp, fmt::format("Fix potdem/wall/region {}", id));
}

void FixPotdemWallRegion::setup(int vflag)
{
  post_force(vflag);
  if (ledger) ledger->setup(vflag);
}

void FixPotdemWallRegion::min_setup(int vflag)
{
  post_force(vflag);
}

void FixPotdemWallRegion::post_force(int vflag)
{
  act<true>(vflag);
}

// what depends on velocities is no part of a minimum
void FixPotdemWallRegion::min_post_force(int vflag)
{
  act<false>(vflag);
}

template <bool MOTION> void FixPotdemWallRegion::act(int vflag)
{
  v_init(vflag);
  std::fill(mine, mine + 7, 0.0);
  summed = false;
  shares.resize(threads());
  for (auto &share : shares) share.begin();
  step = update->dt / force->mvv2e;
  surface.follow();
  too_stiff = monitor ? monitor->stiffest_over_mass() : std::numeric_limits<double>::infinity();
  too_near = monitor ? FixPotdemMonitor::DEEP : -std::numeric_limits<double>::infinity();
  rub = MOTION && potdem_friction_acts(friction) ? &friction_kernel : nullptr;
  std::visit(
      [this](const auto &wall, const auto &dashpot) {
        if (MOTION && dashpot.active())
          this->choose(wall, dashpot);
        else
          this->choose(wall, POTDEM::Elastic());
      },
      law, rate);
  for (const auto &share : shares) gather(share);
}

void FixPotdemWallRegion::ThreadShare::begin()
{
  std::fill(sums, sums + 7, 0.0);
  std::fill(virial, virial + 6, 0.0);
  std::fill(slip, slip + FixPotdemLedger::NKINDS, 0.0);
  power = 0.0;
  suspects.clear();
  passed.clear();
  error = nullptr;
}

void FixPotdemWallRegion::gather(const ThreadShare &share)
{
  for (int k = 0; k < 7; k++) mine[k] += share.sums[k];
  if (evflag && vflag_global)
    for (int k = 0; k < 6; k++) virial[k] += share.virial[k];
  for (const auto &one : share.suspects) suspect(one.i, one.nearness, one.stiffness);
  if (!ledger) return;
  ledger->add_wall(share.power);
  for (int kind = 0; kind < FixPotdemLedger::NKINDS; kind++)
    ledger->add_slip(static_cast<FixPotdemLedger::Kind>(kind), share.slip[kind]);
}

/* ---------------------------------------------------------------------- */

// the smallest kernel that the keywords need
template <class Law, class Rate>
void FixPotdemWallRegion::choose(const PotdemWallLaw<Law> &wall, const Rate &dashpot)
{
  constexpr bool elastic = std::is_same_v<Rate, POTDEM::Elastic>;
  if constexpr (Rate::template serves<Law>()) {
    if (rub)
      push_all<true, true>(wall, dashpot);
    else if (!elastic || ledger)
      push_all<false, true>(wall, dashpot);
    else
      push_all<false, false>(wall, POTDEM::Elastic());
  }
}

template <bool SLIDE, bool MOVE, class Wall, class Rate>
void FixPotdemWallRegion::push_all(const Wall &wall, const Rate &dashpot)
{
  if (!is_listed()) list_near(wall);
  if (listed < 0) {
    for (int i = 0; i < atom->nlocal; i++) push<SLIDE, MOVE>(i, wall, dashpot);
    return;
  }
  push_from_planes<SLIDE, MOVE>(wall, dashpot);
  for (const int i : near) push<SLIDE, MOVE>(i, wall, dashpot);
}

// LAMMPS's regions serve one thread at a time, planes all
template <bool SLIDE, bool MOVE, class Wall, class Rate>
void FixPotdemWallRegion::push_from_planes(const Wall &wall, const Rate &dashpot)
{
  const int nparts = static_cast<int>(shares.size());
#pragma omp parallel for num_threads(nparts) schedule(static) if (nparts > 1)
  for (int part = 0; part < nparts; part++) {
    try {
      push_part<SLIDE, MOVE>(part, wall, dashpot);
    } catch (...) {
      shares[part].error = std::current_exception();
    }
  }
  for (const auto &share : shares) {
    if (share.error) std::rethrow_exception(share.error);
    for (const int i : share.passed) push<SLIDE, MOVE>(i, wall, dashpot);
  }
}

template <bool SLIDE, bool MOVE, class Wall, class Rate>
void FixPotdemWallRegion::push_part(int part, const Wall &wall, const Rate &dashpot)
{
  const std::size_t count = near_planes.size(), stride = PIECE * shares.size();
  for (std::size_t begin = PIECE * part; begin < count; begin += stride)
    for (std::size_t k = begin; k < std::min(begin + PIECE, count); k++)
      push_near<SLIDE, MOVE>(near_planes[k], wall, dashpot, shares[part]);
}

template <bool SLIDE, bool MOVE, class Wall, class Rate>
void FixPotdemWallRegion::push_near(NearPlanes &one, const Wall &wall, const Rate &dashpot,
                                    ThreadShare &share)
{
  const int i = one.i;
  if (!(atom->mask[i] & groupbit)) return;
  share.faces.clear();
  if (!surface.faces_of(one.which, atom->x[i], wall.reach(atom->radius[i]), share.faces)) {
    share.passed.push_back(i);
    one.remembers = true;
  } else if (!share.faces.empty() || one.remembers) {
    push<SLIDE, MOVE>(i, share.faces, wall, dashpot, share);
    one.remembers = SLIDE && remembers(i);
  }
}

// as far as it has moved, the wall may have come nearer
bool FixPotdemWallRegion::is_listed() const
{
  return listed >= 0 && listed == neighbor->lastcall && neighbor->ago > 0 &&
      surface.moved() < 0.5 * neighbor->skin;
}

// What cannot be told: walls that change their shape, radii that change, neighbour lists that do not look how far particles went
bool FixPotdemWallRegion::can_be_listed() const
{
  return neighbor->dist_check && atom->avec->comm_x_only && surface.can_be_listed() &&
      !domain->triclinic && !domain->box_change;
}

// Before a centre has moved by half the skin there is another neighbour list, so that it is a skin at most from where a list in between
// found it; two skins are looked at.
template <class Wall> void FixPotdemWallRegion::list_near(const Wall &wall)
{
  listed = -1;
  if (!can_be_listed()) return;
  near.clear();
  near_planes.clear();
  surface.begin_list();
  const bool flat = surface.is_flat();
  for (int i = 0; i < atom->nlocal; i++) {
    const double reach = wall.reach(atom->radius[i]) + 2.0 * neighbor->skin;
    find_images(atom->x[i]);
    PotdemWallSurface::Planes which;
    const auto is_near = [this, reach](const auto &place) {
      return surface.is_near(place.data(), reach);
    };
    const bool kept = remembers(i);    // to be forgotten, if it has left
    if (flat && images.size() == 1 && surface.find_planes(atom->x[i], reach, which)) {
      if (which || kept) near_planes.push_back({i, kept, which});
    } else if (kept || std::any_of(images.begin(), images.end(), is_near)) {
      near.push_back(i);
    }
  }
  listed = neighbor->lastcall;
}

// a particle that leaves a periodic box before the next list is looked for on the other side
void FixPotdemWallRegion::find_images(const double *x)
{
  const double margin = 2.0 * neighbor->skin;
  images.assign(1, {x[0], x[1], x[2]});
  for (int k = 0; k < 3; k++) {
    if (!domain->periodicity[k]) continue;
    const auto add = [this, k, count = images.size()](double shift) {
      for (std::size_t m = 0; m < count; m++) {
        images.push_back(images[m]);
        images.back()[k] += shift;
      }
    };
    if (x[k] < domain->boxlo[k] + margin) add(domain->prd[k]);
    if (x[k] > domain->boxhi[k] - margin) add(-domain->prd[k]);
  }
}

template <bool SLIDE, bool MOVE, class Wall, class Rate>
void FixPotdemWallRegion::push(int i, const Wall &wall, const Rate &dashpot)
{
  if (!(atom->mask[i] & groupbit)) return;
  double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
  if (!domain->inside(x)) bring_back(x);
  const auto *faces = faces_at(x, wall, atom->radius[i], 0.0);
  if (!faces) passed(i, x);
  push<SLIDE, MOVE>(i, *faces, wall, dashpot, shares[0]);
}

// friction comes after the normal forces of all faces: it may have to balance them. MOVE: velocities matter
template <bool SLIDE, bool MOVE, class Wall, class Rate>
void FixPotdemWallRegion::push(int i, const std::vector<PotdemWallSurface::Face> &faces,
                               const Wall &wall, const Rate &dashpot, ThreadShare &share)
{
  auto &touches = share.touches;
  touches.clear();
  for (const auto &face : faces) {
    if constexpr (SLIDE) {
      touches.emplace_back();
      if (!normal_force<MOVE>(i, face, wall, dashpot, touches.back(), share)) touches.pop_back();
    } else {
      Touch touch;
      if (!normal_force<MOVE>(i, face, wall, dashpot, touch, share)) continue;
      double f[3];
      for (int k = 0; k < 3; k++) f[k] = touch.normal * touch.n[k];
      book(i, touch, f, share);
    }
  }
  if (SLIDE && (!touches.empty() || remembers(i))) (*rub)(i, share);
}

// those within reach and further; or the one that the centre has passed, if the law goes on there; null: it has left the region
template <class Wall>
const std::vector<PotdemWallSurface::Face> *
FixPotdemWallRegion::faces_at(const double *x, const Wall &wall, double ri, double further)
{
  bool free;
  const auto *faces = &surface.faces(x, wall.reach(ri) + further, free);
  if (free) return faces;
  faces = &surface.face_before(x, std::fmax(0.0, -wall.kernel.hard_core(wall.geometry(ri))));
  return faces->empty() ? nullptr : faces;
}

void FixPotdemWallRegion::passed(int i, const double *x) const
{
  error->one(FLERR,
             "Fix potdem/wall/region {}: the centre of atom {} has passed the wall at ({}, {}, "
             "{}) on step {}; use "
             "a smaller timestep, a stiffer wall, or start the particles inside the region",
             id, atom->tag[i], x[0], x[1], x[2], update->ntimestep);
}

// between two neighbour lists a particle may be outside of a periodic box, though not by a period
void FixPotdemWallRegion::bring_back(double *x) const
{
  for (int k = 0; k < 3; k++)
    if (x[k] < domain->boxlo[k] - domain->prd[k] || x[k] > domain->boxhi[k] + domain->prd[k])
      return;
  domain->remap(x);
}

// along the normal, for a distance of 1
void FixPotdemWallRegion::find_motion(int i, const PotdemWallSurface::Face &face,
                                      Touch &touch) const
{
  auto &motion = touch.motion;
  motion.r = 1.0;
  MathExtra::copy3(face.n, motion.del);
  surface.velocity(face, touch.wall);
  MathExtra::sub3(atom->v[i], touch.wall, motion.v);
  if (memory) surface.velocity(face, touch.wall_between, -0.5 * update->dt);
  if (memory || rotation) surface.spin(face, touch.wall_spin);
  if (!rotation) return;
  MathExtra::copy3(atom->omega[i], motion.spin);
  MathExtra::scale3(face.r, motion.spin);
  MathExtra::sub3(atom->omega[i], touch.wall_spin, motion.spin_between);
  for (int k = 0; k < 3; k++)
    motion.spin_of_both[k] = 0.5 * (atom->omega[i][k] + touch.wall_spin[k]);
}

template <bool MOVE, class Wall, class Rate>
bool FixPotdemWallRegion::normal_force(int i, const PotdemWallSurface::Face &face, const Wall &wall,
                                       const Rate &dashpot, Touch &touch, ThreadShare &share)
{
  const double ri = atom->radius[i], r = face.r;
  const auto geometry = wall.geometry(ri);
  const double hard_core = wall.kernel.hard_core(geometry);
  if (domain->dimension == 2 && out_of_plane(i, face)) return false;
  if (r == 0.0) passed(i, atom->x[i]);    // the normal is not known there
  if (!(r > hard_core))
    error->one(FLERR,
               "Fix potdem/wall/region {}: atom {} is {} from the wall on step {}, which is not "
               "beyond the smallest "
               "distance {} of the law; use a smaller timestep or a law that pushes harder",
               id, atom->tag[i], r, update->ntimestep, hard_core);
  MathExtra::copy3(face.n, touch.n);
  touch.key = face.key;
  MathExtra::scale3(r, face.n, touch.del);
  touch.r = r;
  if constexpr (MOVE) find_motion(i, face, touch);
  const auto found = POTDEM::contact_forces<false>(
      wall.kernel, r, geometry, 1.0, dashpot, POTDEM::Frictionless(), nullptr, false,
      [&touch]() -> const POTDEM::ContactMotion & {
        return touch.motion;
      },
      [this, i, r, ri] {
        return masses_of(i, r / ri);
      });
  touch.pressed = {found.pressing, found.elastic.stiffness, POTDEM::shear_ratio_of(wall.kernel, 0),
                   ri, !update->setupflag};
  if (found.elastic.stiffness > too_stiff * atom->rmass[i] || r < too_near * ri)
    share.suspects.push_back({i, hard_core > 0.0 ? 1.0 : r / ri, found.elastic.stiffness});
  touch.normal = found.normal;
  for (int k = 0; k < 3; k++) atom->f[i][k] += touch.normal * touch.n[k];
  if (MOVE && ledger) note(i, touch, found.viscous, share);
  share.sums[0] += found.elastic.energy;
  return true;
}

// the normal force in the ledger, `viscous` of it without a potential
void FixPotdemWallRegion::note(int i, const Touch &touch, double viscous, ThreadShare &share) const
{
  const double *n = touch.n, along = MathExtra::dot3(n, touch.wall);
  ledger->add(FixPotdemLedger::VISCOUS, i, viscous * n[0], viscous * n[1], viscous * n[2]);
  share.slip[FixPotdemLedger::VISCOUS] += viscous * along;
  share.power += touch.normal * along;
}

// a particle too deep in the wall or, with a law that has no depth to lose, too stiff for the step
void FixPotdemWallRegion::suspect(int i, double nearness, double stiffness) const
{
  const auto wall = fmt::format("wall {}", id);
  if (nearness < FixPotdemMonitor::DEEP) monitor->warn_of_deep_wall(wall, i, nearness);
  if (monitor->wall_too_stiff_for_step(i, stiffness))
    monitor->warn_of_stiff_wall(wall, i, stiffness);
}

// in two dimensions a face z = const is no wall
bool FixPotdemWallRegion::out_of_plane(int i, const PotdemWallSurface::Face &face) const
{
  if (face.n[0] == 0.0 && face.n[1] == 0.0 && face.n[2] != 0.0) return true;
  if (fabs(face.n[2]) > UPRIGHT)
    error->one(
        FLERR,
        "Fix potdem/wall/region {}: the surface of region {} at atom {} is not normal to the "
        "plane of a simulation in two dimensions",
        id, region_id, atom->tag[i]);
  return false;
}

// the whole force at the foot
void FixPotdemWallRegion::book(int i, const Touch &touch, const double *f, ThreadShare &share)
{
  const double *const del = touch.del;
  double foot[3], turn[3];
  MathExtra::sub3(atom->x[i], del, foot);
  MathExtra::cross3(foot, f, turn);
  for (int k = 0; k < 3; k++) {
    share.sums[1 + k] -= f[k];
    share.sums[4 + k] -= turn[k];
  }
  if (!evflag) return;
  const double of_touch[6] = {f[0] * del[0], f[1] * del[1], f[2] * del[2],
                              f[0] * del[1], f[0] * del[2], f[1] * del[2]};
  for (int k = 0; k < 6; k++) {
    share.virial[k] += of_touch[k];
    if (vflag_atom) vatom[i][k] += of_touch[k];
  }
}

/* ---------------------------------------------------------------------- */

POTDEM::ContactMasses FixPotdemWallRegion::masses_of(int i, double r_over_ri) const
{
  const double m = atom->rmass[i], share = spin_share(r_over_ri);
  return {share * m, 1.0, step, update->dt, share, inertia * m, 1.0 / inertia};
}

// what spin leaves of the mass at the surface
double FixPotdemWallRegion::spin_share(double r_over_ri) const
{
  return rotation ? POTDEM::sliding_mass(r_over_ri, inertia) : 1.0;
}

template <bool SPIN, class Tangential>
void FixPotdemWallRegion::add_friction(int i, const Tangential &rough, const Tangential &alone,
                                       ThreadShare &share)
{
  auto &touches = share.touches;
  if constexpr (Tangential::STATE > 0) follow_faces(i, share);
  for (auto &touch : touches) {
    touch.surface = {};
    double *state = nullptr;
    if constexpr (Tangential::STATE > 0) state = memory->of_face(i, touch.key);
    rub_face<SPIN>(i, alone, state, touch, share);
  }
  if constexpr (std::is_base_of_v<POTDEM::Sliding, Tangential>)
    if (rough.automatic != 0.0) hold_at_rest<SPIN>(i, rough, touches);
  for (const auto &touch : touches) {
    const double *const drag = touch.surface.friction;
    double f[3];
    MathExtra::scaleadd3(touch.normal, touch.n, drag, f);
    book(i, touch, f, share);
    MathExtra::add3(atom->f[i], drag, atom->f[i]);
    if (SPIN) {
      double torque[3];
      POTDEM::torque_over_lever(touch.del, drag, torque);
      turn(i, torque);
    }
    if (!ledger) continue;
    const double across = MathExtra::dot3(drag, touch.wall);
    ledger->add(FixPotdemLedger::FRICTION, i, drag[0], drag[1], drag[2]);
    share.slip[FixPotdemLedger::FRICTION] += across;
    share.power += across;
  }
}

void FixPotdemWallRegion::follow_faces(int i, ThreadShare &share)
{
  share.keys.clear();
  for (const auto &touch : share.touches) share.keys.push_back(touch.key);
  memory->follow(i, share.keys, surface);
}

// for what adds up the way of the surfaces. The particle's velocity is that between this step and the one before, and so must the
// wall's be: on a turntable a grain at rest would else seem to slide. What does not spin turns with the wall
template <bool SPIN>
POTDEM::ContactMotion FixPotdemWallRegion::motion_over_step(int i, const Touch &touch) const
{
  auto motion = touch.motion;
  MathExtra::sub3(atom->v[i], touch.wall_between, motion.v);
  if (!SPIN) {
    MathExtra::zero3(motion.spin);
    MathExtra::copy3(touch.wall_spin, motion.spin_of_both);
  }
  return motion;
}

// what a face does by itself
template <bool SPIN, class Tangential>
void FixPotdemWallRegion::rub_face(int i, const Tangential &rough, double *state, Touch &touch,
                                   ThreadShare &share)
{
  constexpr bool REMEMBERS = Tangential::STATE > 0;
  const auto motion = [&] {
    if constexpr (REMEMBERS) return motion_over_step<SPIN>(i, touch);
    return touch.motion;
  };
  const auto masses = [this, i, &touch] {
    return masses_of(i, touch.r / atom->radius[i]);
  };
  // springs turn about the normal without spin, too
  POTDEM::surface_forces<SPIN || REMEMBERS>(rough, touch.pressed, state, touch.surface, motion,
                                            masses);
  if constexpr (POTDEM::is_rolling<Tangential>) {
    turn(i, touch.surface.torque);
    if (!ledger) return;
    const double by_wall = MathExtra::dot3(touch.surface.torque, touch.wall_spin);
    share.slip[FixPotdemLedger::FRICTION] += by_wall;
    share.power += by_wall;
  }
}

void FixPotdemWallRegion::turn(int i, const double *torque)
{
  MathExtra::add3(atom->torque[i], torque, atom->torque[i]);
  if (ledger) ledger->add_torque(i, 1.0, torque);
}

// the forces that end the sliding at all faces within the step, the other forces (and torques) balanced, as far as
// friction can: face by face, until nothing changes
template <bool SPIN>
void FixPotdemWallRegion::hold_at_rest(int i, const POTDEM::Sliding &rough,
                                       std::vector<Touch> &touches) const
{
  const double mass_over_step = force->mvv2e * atom->rmass[i] / update->dt, ri = atom->radius[i];
  double f[3], torque[3] = {0.0, 0.0, 0.0}, change = 0.0, largest = 0.0;
  MathExtra::copy3(atom->f[i], f);
  if (SPIN) MathExtra::copy3(atom->torque[i], torque);
  for (auto &touch : touches) {
    MathExtra::zero3(touch.surface.friction);
    largest = std::fmax(largest, rough.mu * touch.pressed.normal);
  }
  for (int round = 0; round < MAX_ROUNDS; round++) {
    change = 0.0;
    for (auto &touch : touches) {
      double stop[3], more[3], *const drag = touch.surface.friction;
      POTDEM::sliding_velocity<SPIN>(touch.motion, stop);
      const double pressed = MathExtra::dot3(f, touch.n);
      for (int k = 0; k < 3; k++)
        stop[k] = -mass_over_step * stop[k] - (f[k] - pressed * touch.n[k]);
      if (SPIN) {
        double roll[3];
        MathExtra::cross3(touch.del, torque, roll);
        const double share = spin_share(touch.r / ri);
        for (int k = 0; k < 3; k++) stop[k] = share * (stop[k] - roll[k] / (inertia * ri * ri));
      }
      MathExtra::add3(stop, drag, stop);
      MathExtra::scale3(rough.share(MathExtra::len3(stop), touch.pressed.normal), stop);
      MathExtra::sub3(stop, drag, more);
      MathExtra::copy3(stop, drag);
      MathExtra::add3(f, more, f);
      if (SPIN) {
        POTDEM::torque_over_lever(touch.del, more, stop);
        MathExtra::add3(torque, stop, torque);
      }
      change = std::fmax(change, MathExtra::len3(more));
    }
    if (touches.size() == 1 || change <= ROUNDING * largest) return;
  }
}

// 'auto' waits for the forces of all faces. Clang 14 compiles what the inner functions call only if it knows that already
FixPotdemWallRegion::FrictionKernel FixPotdemWallRegion::make_friction_kernel()
{
  return potdem_visit(friction, [this](const auto &rough) -> FrictionKernel {
    using Tangential = std::decay_t<decltype(rough)>;
    auto alone = rough;
    if constexpr (std::is_base_of_v<POTDEM::Sliding, Tangential>)
      if (rough.automatic != 0.0) alone.mu = 0.0;
    if (rotation)
      return [this, rough, alone](int i, ThreadShare &share) {
        add_friction<true>(i, rough, alone, share);
      };
    return [this, rough, alone](int i, ThreadShare &share) {
      add_friction<false>(i, rough, alone, share);
    };
  });
}

/* ---------------------------------------------------------------------- */

void FixPotdemWallRegion::add_stiffness_to(PotdemStiffness &sum, double ahead)
{
  surface.follow();
  std::visit(
      [this, &sum, ahead](const auto &wall) {
        add_stiffness_of(wall, sum, ahead);
      },
      law);
}

template <class Wall>
void FixPotdemWallRegion::add_stiffness_of(const Wall &wall, PotdemStiffness &sum, double ahead)
{
  const double further = ahead > 0.0 ? neighbor->skin : 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    if (!domain->inside(x)) bring_back(x);
    const double reach = wall.reach(atom->radius[i]);
    const auto *faces = faces_at(x, wall, atom->radius[i], further);
    if (!faces) continue;
    for (const auto &face : *faces) {
      const double r = ahead > 0.0 ? closest(i, face, ahead, wall) : face.r;
      if (r < reach && !(domain->dimension == 2 && out_of_plane(i, face)))
        sum.add_wall(i, spring(i, face, r, wall));
    }
  }
}

// of a particle that approaches the wall and touches it within a time, where it turns back
template <class Wall>
double FixPotdemWallRegion::closest(int i, const PotdemWallSurface::Face &face, double ahead,
                                    const Wall &wall) const
{
  Touch state;
  find_motion(i, face, state);
  const auto geometry = wall.geometry(atom->radius[i]);
  return POTDEM::closest_approach(face.r, POTDEM::rate_of_distance(state.motion), ahead,
                                  wall.reach(geometry.ri), wall.kernel.hard_core(geometry),
                                  force->mvv2e * atom->rmass[i], [&](double r) {
                                    return wall.kernel.evaluate(r, geometry);
                                  });
}

// at the distance r
template <class Wall>
POTDEM::Spring FixPotdemWallRegion::spring(int i, const PotdemWallSurface::Face &face, double r,
                                           const Wall &wall) const
{
  const auto geometry = wall.geometry(atom->radius[i]);
  const auto masses = masses_of(i, r / geometry.ri);
  return std::visit(
      [&](const auto &dashpot) {
        return potdem_visit(friction, [&](const auto &rough) {
          return POTDEM::contact_spring(wall.kernel, r, geometry, 1.0, dashpot, rough, masses,
                                        face.n);
        });
      },
      rate);
}

/* ---------------------------------------------------------------------- */

double FixPotdemWallRegion::sum(int n)
{
  if (!summed) MPI_Allreduce(mine, total, 7, MPI_DOUBLE, MPI_SUM, world);
  summed = true;
  return total[n];
}

void FixPotdemWallRegion::add_energy_to(PotdemEnergies &all)
{
  all.walls += compute_scalar();
  if (!memory) return;
  double stored = 0.0, over_ranks;
  for (int i = 0; i < atom->nlocal; i++)
    memory->for_each(i, [this, &stored](const double *state) {
      stored += potdem_friction_energy(friction, state);
    });
  MPI_Allreduce(&stored, &over_ranks, 1, MPI_DOUBLE, MPI_SUM, world);
  all.springs += over_ranks;
}

double FixPotdemWallRegion::compute_scalar()
{
  return sum(0);
}

double FixPotdemWallRegion::compute_vector(int n)
{
  return sum(1 + n);
}

/* ---------------------------------------------------------------------- */

void FixPotdemWallRegion::write_restart(FILE *fp)
{
  if (comm->me == 0) potdem_write_block(fp, surface.way());
}

void FixPotdemWallRegion::restart(char *buf)
{
  way_in_file = potdem_read_block(lmp, fmt::format("Fix potdem/wall/region {}", id), buf);
}
