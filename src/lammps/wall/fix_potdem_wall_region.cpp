/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Walls on LAMMPS regions (thesis 5.3); the laws are laws/hertz_wall.h and laws/wall.h. */

#include "lammps/wall/fix_potdem_wall_region.h"

#include "core/stability/turning_point.h"
#include "lammps/glue/potdem_law_input.h"
#include "lammps/output/fix_potdem_ledger.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/potdem_stiffness.h"

#include "atom.h"
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

// the thesis's soft layer, eq. 5.28
static constexpr double LAYER_OVER_RADIUS = 0.1;
static constexpr double LAYER_EXPONENT = 2.0;
// friction of a particle that touches several faces: at most so many rounds, to this fraction of its limit
static constexpr int MAX_ROUNDS = 200;
static constexpr double ROUNDING = 1e-14;
// a normal within this of the plane z = 0 lies in it
static constexpr double UPRIGHT = 1e-9;

/* ---------------------------------------------------------------------- */

FixPotdemWallRegion::FixPotdemWallRegion(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), region(nullptr), surface(lmp), ledger(nullptr), monitor(nullptr),
    viscosity(0.0), rotation(false), inertia(POTDEM::SPHERE_INERTIA), mine(), total(), summed(false)
{
  scalar_flag = vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extscalar = extvector = 1;
  energy_global_flag = 1;
  virial_global_flag = virial_peratom_flag = 1;
  dynamic_group_allow = 1;
  read(narg - 3, arg + 3);
}

/* ----------------------------------------------------------------------
   REGION  E nu  particle E nu  [layer gamma_over_r m | layer none] [viscous H]
   REGION  law lj|granular|truss  its coefficients and keywords as in pair_coeff
   both:  [friction mu eta|auto] [rotation no|yes|disc]
------------------------------------------------------------------------- */

void FixPotdemWallRegion::read(int narg, char **arg)
{
  PotdemInput input(lmp, "fix potdem/wall/region", narg, arg);
  region_id = input.word();
  if (!domain->get_region_by_id(region_id))
    input.fail(fmt::format("there is no region '{}'", region_id));
  if (!input.next_is("law")) {
    read_hertz(input);
  } else if (input.next_is("lj")) {
    read_wall<POTDEM::ShiftedLJ>(input);
  } else if (input.next_is("granular")) {
    read_wall<POTDEM::RegularisedGranular>(input);
  } else if (input.next_is("truss")) {
    read_wall<POTDEM::TrussContact>(input);
  } else {
    input.word();
    input.unknown("lj, granular or truss (Hertz is what E and nu without 'law' give)");
  }
}

void FixPotdemWallRegion::read_hertz(PotdemInput &input)
{
  const auto wall = input.properties({"E", "nu"}, " of the wall");
  if (!input.next_is("particle"))
    input.fail("the particles' own elasticity is missing, give 'particle E nu' after E and nu of "
               "the wall");
  const auto grain = input.properties({"E", "nu"}, " of the particle");
  const double modulus = POTDEM::contact_modulus(grain[0], grain[1], wall[0], wall[1]);
  law = POTDEM::LayeredHertzWall{{modulus, LAYER_OVER_RADIUS, LAYER_EXPONENT}};
  while (!input.done())
    if (!read_hertz_option(input)) read_common(input, "layer, viscous");
}

bool FixPotdemWallRegion::read_hertz_option(PotdemInput &input)
{
  if (input.next_is("viscous")) {
    viscosity = input.nonnegative("viscous H");
    return true;
  }
  if (!input.next_is("layer")) return false;
  auto &hertz = std::get<POTDEM::LayeredHertzWall>(law).law;
  hertz.layer = 0.0;
  if (input.next_is("none")) return true;
  hertz.layer = input.positive("layer gamma_over_r");
  hertz.m = input.number("layer m");
  if (hertz.m < 1.0)
    input.fail(fmt::format("layer m = {} is out of range, it must be >= 1", hertz.m));
  return true;
}

template <class Law> void FixPotdemWallRegion::read_wall(PotdemInput &input)
{
  Law coeffs{};
  read_law(input, coeffs);
  while (!input.done())
    if (!read_option(input, coeffs)) read_common(input, option_names(coeffs));
  law = POTDEM::LawWall<Law>{coeffs, coeffs.kernel(false)};
}

void FixPotdemWallRegion::read_common(PotdemInput &input, const char *names)
{
  if (input.next_is("friction")) {
    friction = input.friction();
  } else if (input.next_is("rotation")) {
    read_rotation(input);
  } else {
    input.word();
    input.unknown(fmt::format("{}, friction or rotation", names));
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
  check_rotation();
  if (friction.mu > 0.0 && friction.automatic)
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
  if (!monitor || friction.mu == 0.0) return;
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
  surface.follow();
  too_stiff = monitor ? monitor->stiffest_over_mass() : std::numeric_limits<double>::infinity();
  too_near = monitor ? FixPotdemMonitor::DEEP : 0.0;
  std::visit(
      [this](const auto &wall) {
        this->template push_with<MOTION>(wall);
      },
      law);
}

/* ---------------------------------------------------------------------- */

// the smallest kernel that the keywords need
template <bool MOTION, class Wall> void FixPotdemWallRegion::push_with(const Wall &wall)
{
  const bool sliding = MOTION && friction.mu > 0.0;
  const bool viscous = MOTION && Wall::viscous && viscosity > 0.0;
  if (sliding && rotation)
    viscous ? push_all<true, true, Wall::viscous>(wall) : push_all<true, true, false>(wall);
  else if (sliding)
    viscous ? push_all<true, false, Wall::viscous>(wall) : push_all<true, false, false>(wall);
  else
    viscous ? push_all<false, false, Wall::viscous>(wall) : push_all<false, false, false>(wall);
}

// friction comes after the normal forces of all faces: it has to balance them
template <bool SLIDE, bool SPIN, bool VISCOUS, class Wall>
void FixPotdemWallRegion::push_all(const Wall &wall)
{
  const bool periodic = domain->xperiodic || domain->yperiodic || domain->zperiodic;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    if (periodic && !domain->inside(x)) bring_back(x);
    if (!surface.is_free(x))
      error->one(FLERR,
                 "Fix potdem/wall/region {}: the centre of atom {} has passed the wall at ({}, {}, "
                 "{}) on step {}; use "
                 "a smaller timestep, a stiffer wall, or start the particles inside the region",
                 id, atom->tag[i], x[0], x[1], x[2], update->ntimestep);
    touches.clear();
    for (const auto &face : surface.faces(x, wall.reach(atom->radius[i]))) {
      Touch touch;
      if (normal_force<SLIDE, VISCOUS>(i, face, wall, touch)) touches.push_back(touch);
    }
    if (SLIDE && !touches.empty()) add_friction<SPIN>(i);
  }
}

// between two neighbour lists a particle may be outside of a periodic box, though not by a period
void FixPotdemWallRegion::bring_back(double *x) const
{
  for (int k = 0; k < 3; k++)
    if (x[k] < domain->boxlo[k] - domain->prd[k] || x[k] > domain->boxhi[k] + domain->prd[k])
      return;
  domain->remap(x);
}

template <bool SLIDE, bool VISCOUS, class Wall>
bool FixPotdemWallRegion::normal_force(int i, const PotdemWallSurface::Face &face, const Wall &law,
                                       Touch &touch)
{
  const double ri = atom->radius[i], r = face.r;
  if (domain->dimension == 2 && out_of_plane(i, face)) return false;
  if (!(r > law.hard_core(ri)))
    error->one(FLERR,
               "Fix potdem/wall/region {}: atom {} is {} from the wall on step {}, which is not "
               "beyond the smallest "
               "distance {} of the law; use a smaller timestep or a law that pushes harder",
               id, atom->tag[i], r, update->ntimestep, law.hard_core(ri));
  const auto at = law.evaluate(r, ri);
  if (at.stiffness > too_stiff * atom->rmass[i] || r < too_near * ri)
    suspect(i, law.hard_core(ri) > 0.0 ? 1.0 : r / ri, at.stiffness);
  MathExtra::copy3(face.n, touch.n);
  MathExtra::scale3(-r, face.n, touch.arm);
  touch.normal = at.force;
  if (SLIDE || VISCOUS || ledger) surface.velocity(face, touch.wall);
  if (VISCOUS) {
    double u[3];
    MathExtra::sub3(atom->v[i], touch.wall, u);
    const double leaving = MathExtra::dot3(u, touch.n);
    touch.normal = std::fmax(0.0, at.force - at.force / (law.reach(ri) - r) * viscosity * leaving);
  }
  double f[3];
  for (int k = 0; k < 3; k++) f[k] = touch.normal * touch.n[k];
  if (ledger) {
    const double viscous = touch.normal - at.force, *n = touch.n;
    const double along = MathExtra::dot3(n, touch.wall);
    ledger->add(FixPotdemLedger::VISCOUS, i, viscous * n[0], viscous * n[1], viscous * n[2]);
    ledger->add_slip(FixPotdemLedger::VISCOUS, viscous * along);
    ledger->add_wall(touch.normal * along);
  }
  mine[0] += at.energy;
  add(i, touch, f);
  return true;
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

// a force at the foot
void FixPotdemWallRegion::add(int i, const Touch &touch, const double *f)
{
  double foot[3], turn[3];
  MathExtra::add3(atom->x[i], touch.arm, foot);
  MathExtra::cross3(foot, f, turn);
  for (int k = 0; k < 3; k++) {
    atom->f[i][k] += f[k];
    mine[1 + k] -= f[k];
    mine[4 + k] -= turn[k];
  }
  if (evflag) {
    const double *arm = touch.arm;
    double virial[6] = {-f[0] * arm[0], -f[1] * arm[1], -f[2] * arm[2],
                        -f[0] * arm[1], -f[0] * arm[2], -f[1] * arm[2]};
    v_tally(i, virial);
  }
}

/* ---------------------------------------------------------------------- */

// of the surface of particle i at the foot, along the wall
template <bool SPIN> void FixPotdemWallRegion::sliding(int i, const Touch &touch, double *u) const
{
  MathExtra::sub3(atom->v[i], touch.wall, u);
  if (SPIN) {
    double surface[3];
    MathExtra::cross3(atom->omega[i], touch.arm, surface);
    MathExtra::add3(u, surface, u);
  }
  MathExtra::scaleadd3(-MathExtra::dot3(u, touch.n), touch.n, u, u);
}

template <bool SPIN> void FixPotdemWallRegion::add_friction(int i)
{
  if (friction.automatic) {
    hold_at_rest<SPIN>(i);
  } else {
    for (auto &touch : touches) {
      sliding<SPIN>(i, touch, touch.drag);
      const double speed = MathExtra::len3(touch.drag);
      const double b = speed > 0.0 ? friction.factor(speed, touch.normal, friction.eta) : 0.0;
      MathExtra::scale3(-b, touch.drag);
    }
  }
  for (const auto &touch : touches) {
    add(i, touch, touch.drag);
    double turn[3];
    MathExtra::cross3(touch.arm, touch.drag, turn);
    if (SPIN) MathExtra::add3(atom->torque[i], turn, atom->torque[i]);
    if (!ledger) continue;
    const double across = MathExtra::dot3(touch.drag, touch.wall);
    ledger->add(FixPotdemLedger::FRICTION, i, touch.drag[0], touch.drag[1], touch.drag[2]);
    if (SPIN) ledger->add_torque(i, 1.0, turn);
    ledger->add_slip(FixPotdemLedger::FRICTION, across);
    ledger->add_wall(across);
  }
}

// the forces that end the sliding at all faces within the step, the other forces (and torques) balanced, as far as
// friction can: face by face, until nothing changes
template <bool SPIN> void FixPotdemWallRegion::hold_at_rest(int i)
{
  const double mass_over_step = force->mvv2e * atom->rmass[i] / update->dt, ri = atom->radius[i];
  double f[3], torque[3] = {0.0, 0.0, 0.0}, change = 0.0, largest = 0.0;
  MathExtra::copy3(atom->f[i], f);
  if (SPIN) MathExtra::copy3(atom->torque[i], torque);
  for (auto &touch : touches) {
    MathExtra::zero3(touch.drag);
    largest = std::fmax(largest, friction.mu * touch.normal);
  }
  for (int round = 0; round < MAX_ROUNDS; round++) {
    change = 0.0;
    for (auto &touch : touches) {
      double stop[3], more[3];
      sliding<SPIN>(i, touch, stop);
      const double pressed = MathExtra::dot3(f, touch.n);
      for (int k = 0; k < 3; k++)
        stop[k] = -mass_over_step * stop[k] - (f[k] - pressed * touch.n[k]);
      if (SPIN) {
        double roll[3];
        MathExtra::cross3(torque, touch.arm, roll);
        const double share = POTDEM::sliding_mass(MathExtra::len3(touch.arm) / ri, inertia);
        for (int k = 0; k < 3; k++) stop[k] = share * (stop[k] - roll[k] / (inertia * ri * ri));
      }
      MathExtra::add3(stop, touch.drag, stop);
      MathExtra::scale3(friction.share(MathExtra::len3(stop), touch.normal), stop);
      MathExtra::sub3(stop, touch.drag, more);
      MathExtra::copy3(stop, touch.drag);
      MathExtra::add3(f, more, f);
      MathExtra::cross3(touch.arm, more, stop);
      MathExtra::add3(torque, stop, torque);
      change = std::fmax(change, MathExtra::len3(more));
    }
    if (touches.size() == 1 || change <= ROUNDING * largest) return;
  }
}

/* ---------------------------------------------------------------------- */

void FixPotdemWallRegion::add_stiffness_to(PotdemStiffness &sum, double ahead)
{
  surface.follow();
  std::visit(
      [this, &sum, ahead](const auto &wall) {
        stiffen_with(wall, sum, ahead);
      },
      law);
}

template <class Wall>
void FixPotdemWallRegion::stiffen_with(const Wall &wall, PotdemStiffness &sum, double ahead)
{
  const double further = ahead > 0.0 ? neighbor->skin : 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    if (!domain->inside(x)) bring_back(x);
    const double reach = wall.reach(atom->radius[i]);
    for (const auto &face : surface.faces(x, reach + further)) {
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
  const double ri = atom->radius[i];
  double u[3];
  surface.velocity(face, u);
  MathExtra::sub3(atom->v[i], u, u);
  const double rate = MathExtra::dot3(u, face.n);
  if (rate >= 0.0 || face.r + rate * ahead >= wall.reach(ri)) return face.r;
  return POTDEM::turning_point(MIN(face.r, wall.reach(ri)), wall.hard_core(ri),
                               0.5 * force->mvv2e * atom->rmass[i] * rate * rate, [&](double r) {
                                 return wall.evaluate(r, ri);
                               });
}

// at the distance r; friction 'auto' follows the step and does not limit it
template <class Wall>
PotdemSpring FixPotdemWallRegion::spring(int i, const PotdemWallSurface::Face &face, double r,
                                         const Wall &wall) const
{
  const double ri = atom->radius[i];
  const auto at = wall.evaluate(r, ri);
  PotdemSpring spring{{face.n[0], face.n[1], face.n[2]}, at.stiffness, 0.0, 0.0, 0.0};
  if (Wall::viscous) spring.viscosity = at.force / (wall.reach(ri) - r) * viscosity;
  if (friction.mu > 0.0 && !friction.automatic)
    spring.friction = rotation ? friction.eta / POTDEM::sliding_mass(r / ri, inertia)
                               : friction.eta;
  return spring;
}

/* ---------------------------------------------------------------------- */

double FixPotdemWallRegion::sum(int n)
{
  if (!summed) MPI_Allreduce(mine, total, 7, MPI_DOUBLE, MPI_SUM, world);
  summed = true;
  return total[n];
}

double FixPotdemWallRegion::compute_scalar()
{
  return sum(0);
}

double FixPotdemWallRegion::compute_vector(int n)
{
  return sum(1 + n);
}
