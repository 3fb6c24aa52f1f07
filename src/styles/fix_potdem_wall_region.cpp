/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Walls on LAMMPS regions (thesis 5.3); the laws are laws/hertz_wall.h and laws/wall.h. */

#include "fix_potdem_wall_region.h"

#include "potdem_law_input.h"
#include "potdem_ledger.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "region.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;

// the thesis's soft layer, eq. 5.28
static constexpr double LAYER_OVER_RADIUS = 0.1;
static constexpr double LAYER_EXPONENT = 2.0;

/* ---------------------------------------------------------------------- */

FixPotdemWallRegion::FixPotdemWallRegion(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), region(nullptr), ledger(nullptr), viscosity(0.0), mine(), total(),
    summed(false)
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
   REGION  E nu  particle E nu  [layer gamma_over_r m | layer none] [viscous H]  [friction mu eta|auto]
   REGION  law lj|granular|truss  its coefficients and keywords as in pair_coeff  [friction mu eta|auto]
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
  const double Ewall = input.positive("E of the wall"), nuwall = input.poisson("nu of the wall");
  if (!input.next_is("particle"))
    input.fail("the particles' own elasticity is missing, give 'particle E nu' after E and nu of "
               "the wall");
  const double E = input.positive("particle E"), nu = input.poisson("particle nu");
  const double modulus = POTDEM::contact_modulus(E, nu, Ewall, nuwall);
  law = POTDEM::LayeredHertzWall{{modulus, LAYER_OVER_RADIUS, LAYER_EXPONENT}};
  while (!input.done())
    if (!read_hertz_option(input)) read_common(input, "layer or viscous");
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
  } else {
    input.word();
    input.unknown(fmt::format("friction or {}", names));
  }
}

int FixPotdemWallRegion::setmask()
{
  return POST_FORCE | MIN_POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixPotdemWallRegion::init()
{
  potdem_refuse_respa(lmp, "fix potdem/wall/region");
  ledger = PotdemLedger::find(lmp);
  region = domain->get_region_by_id(region_id);
  if (!region)
    error->all(FLERR, "Region {} for fix potdem/wall/region {} does not exist", region_id, id);
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               "Fix potdem/wall/region {} needs particle diameters, e.g. atom_style sphere or "
               "bpm/sphere",
               id);
  if (friction.mu > 0.0 && friction.automatic)
    potdem_require_last(lmp, this, "balances the other forces on a particle ('friction auto')",
                        "^potdem/");
}

void FixPotdemWallRegion::setup(int vflag)
{
  post_force(vflag);
}

void FixPotdemWallRegion::min_setup(int vflag)
{
  post_force(vflag);
}

void FixPotdemWallRegion::min_post_force(int vflag)
{
  post_force(vflag);
}

void FixPotdemWallRegion::post_force(int vflag)
{
  v_init(vflag);
  std::fill(mine, mine + 7, 0.0);
  summed = false;
  region->prematch();
  if (region->dynamic_check()) region->set_velocity();
  std::visit(
      [this](const auto &wall) {
        push_with(wall);
      },
      law);
}

/* ---------------------------------------------------------------------- */

// the smallest kernel that the keywords need
template <class Wall> void FixPotdemWallRegion::push_with(const Wall &wall)
{
  const bool sliding = friction.mu > 0.0, viscous = Wall::viscous && viscosity > 0.0;
  if (sliding)
    viscous ? push_all<true, Wall::viscous>(wall) : push_all<true, false>(wall);
  else
    viscous ? push_all<false, Wall::viscous>(wall) : push_all<false, false>(wall);
}

template <bool SLIDE, bool VISCOUS, class Wall> void FixPotdemWallRegion::push_all(const Wall &wall)
{
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *x = atom->x[i], ri = atom->radius[i];
    if (!region->match(x[0], x[1], x[2]))
      error->one(FLERR,
                 "Fix potdem/wall/region {}: the centre of atom {} has passed the wall at ({}, {}, "
                 "{}) on step {}; use "
                 "a smaller timestep, a stiffer wall, or start the particles inside the region",
                 id, atom->tag[i], x[0], x[1], x[2], update->ntimestep);
    const int ncontact = region->surface(x[0], x[1], x[2], wall.reach(ri));
    for (int c = 0; c < ncontact; c++) push<SLIDE, VISCOUS>(i, c, wall);
  }
}

template <bool SLIDE, bool VISCOUS, class Wall>
void FixPotdemWallRegion::push(int i, int c, const Wall &law)
{
  const auto &contact = region->contact[c];
  const double ri = atom->radius[i], r = contact.r;
  if (r >= law.reach(ri)) return;
  if (!(r > law.core(ri)))
    error->one(FLERR,
               "Fix potdem/wall/region {}: atom {} is {} from the wall on step {}, which is not "
               "beyond the smallest "
               "distance {} of the law; use a smaller timestep or a law that pushes harder",
               id, atom->tag[i], r, update->ntimestep, law.core(ri));
  const double n[3] = {contact.delx / r, contact.dely / r, contact.delz / r};
  const auto at = law.evaluate(r, ri);

  double normal = at.force, drag[3] = {0.0, 0.0, 0.0}, wall[3] = {0.0, 0.0, 0.0};
  if (SLIDE || VISCOUS || ledger) region->velocity_contact(wall, atom->x[i], c);
  if (SLIDE || VISCOUS) {
    const double u[3] = {atom->v[i][0] - wall[0], atom->v[i][1] - wall[1], atom->v[i][2] - wall[2]};
    const double leaving = u[0] * n[0] + u[1] * n[1] + u[2] * n[2];
    if (VISCOUS)
      normal = std::fmax(0.0, normal - at.force / (law.reach(ri) - r) * viscosity * leaving);
    if (SLIDE && normal > 0.0) {
      const double sliding[3] = {u[0] - leaving * n[0], u[1] - leaving * n[1],
                                 u[2] - leaving * n[2]};
      rub(i, n, normal, sliding, drag);
    }
  }
  if (ledger) book(i, n, normal - at.force, drag, normal, wall);

  const double f[3] = {normal * n[0] + drag[0], normal * n[1] + drag[1], normal * n[2] + drag[2]};
  const double del[3] = {contact.delx, contact.dely, contact.delz};
  double foot[3];
  for (int k = 0; k < 3; k++) {
    atom->f[i][k] += f[k];
    foot[k] = atom->x[i][k] - del[k];
    mine[1 + k] -= f[k];
  }
  mine[0] += at.energy;
  mine[4] -= foot[1] * f[2] - foot[2] * f[1];
  mine[5] -= foot[2] * f[0] - foot[0] * f[2];
  mine[6] -= foot[0] * f[1] - foot[1] * f[0];
  if (evflag) {
    double virial[6] = {f[0] * del[0], f[1] * del[1], f[2] * del[2],
                        f[0] * del[1], f[0] * del[2], f[1] * del[2]};
    v_tally(i, virial);
  }
}

// viscous force along n and drag are dissipative; where the wall moves, part of their work is the wall's
void FixPotdemWallRegion::book(int i, const double *n, double viscous, const double *drag,
                               double normal, const double *wall)
{
  const double along = n[0] * wall[0] + n[1] * wall[1] + n[2] * wall[2];
  const double across = drag[0] * wall[0] + drag[1] * wall[1] + drag[2] * wall[2];
  ledger->add(PotdemLedger::VISCOUS, i, viscous * n[0], viscous * n[1], viscous * n[2]);
  ledger->add(PotdemLedger::FRICTION, i, drag[0], drag[1], drag[2]);
  ledger->add_slip(PotdemLedger::VISCOUS, viscous * along);
  ledger->add_slip(PotdemLedger::FRICTION, across);
  ledger->add_wall(normal * along + across);
}

// friction of particle i on a wall with normal n
void FixPotdemWallRegion::rub(int i, const double *n, double normal, const double *sliding,
                              double *drag) const
{
  const double speed =
      sqrt(sliding[0] * sliding[0] + sliding[1] * sliding[1] + sliding[2] * sliding[2]);
  if (!friction.automatic) {
    const double b = speed > 0.0 ? friction.factor(speed, normal, friction.eta) : 0.0;
    for (int k = 0; k < 3; k++) drag[k] = -b * sliding[k];
    return;
  }
  const double *f = atom->f[i], mass_over_step = force->mvv2e * atom->rmass[i] / update->dt;
  const double pressed = f[0] * n[0] + f[1] * n[1] + f[2] * n[2];
  for (int k = 0; k < 3; k++) drag[k] = -mass_over_step * sliding[k] - (f[k] - pressed * n[k]);
  const double stop = sqrt(drag[0] * drag[0] + drag[1] * drag[1] + drag[2] * drag[2]);
  const double share = friction.share(stop, normal);
  for (int k = 0; k < 3; k++) drag[k] *= share;
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
