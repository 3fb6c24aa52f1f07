/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What PairPotdem<Law> does with one pair, outside of the loop: single(), the critical step, and the alarms. */

#ifndef LMP_PAIR_POTDEM_CONTACT_H
#define LMP_PAIR_POTDEM_CONTACT_H

#include "core/stability/turning_point.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/output/potdem_stiffness.h"
#include "lammps/pair/fix_potdem_contacts.h"
#include "lammps/pair/pair_potdem.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "math_extra.h"
#include "neigh_list.h"
#include "update.h"

#include <algorithm>
#include <cmath>

namespace LAMMPS_NS {

template <class Law> double PairPotdem<Law>::hard_core(int i, int j) const
{
  return kernels[at(atom->type[i], atom->type[j])].hard_core(geometry(i, j));
}

/* ----------------------------------------------------------------------
   Pairs that the loop has to look at twice: nearer than any pair of these types that is neither collapsed, nor deep, nor too
   stiff for the step by itself. All others cost nothing.
------------------------------------------------------------------------- */

template <class Law> void PairPotdem<Law>::find_alarm(int i, int j)
{
  constexpr double rounding = 1e-9;
  const int pair = at(i, j);
  const POTDEM::ContactGeometry unit{0.5, 0.5, 1.0};
  double nearest = (1.0 + rounding) * kernels[pair].hard_core(unit);
  if (monitor && std::isfinite(least_mass[i]) && std::isfinite(least_mass[j]))
    nearest = std::max({nearest, FixPotdemMonitor::DEEP,
                        stiff_from(i, j, largest_radius[i], largest_radius[j]),
                        stiff_from(i, j, least_radius[i], least_radius[j])});
  alarm[pair] = alarm[at(j, i)] = nearest;
}

// distance over dbar from which on inwards two of the lightest particles of these types may be too stiff
template <class Law> double PairPotdem<Law>::stiff_from(int i, int j, double ri, double rj) const
{
  constexpr int pieces = 64;
  const auto &kernel = kernels[at(i, j)];
  const POTDEM::ContactGeometry partners{ri, rj, ri + rj};
  const double inner = kernel.hard_core(partners);
  const double width = (reach(i, j, ri + rj) - inner) / pieces;
  const double inverse_masses = (1.0 / least_mass[i] + 1.0 / least_mass[j]) / force->mvv2e;
  int k = pieces;
  while (k > 1 &&
         !monitor->too_stiff_for_step(
             kernel.evaluate(inner + (k - 0.5) * width, partners).stiffness, inverse_masses))
    k--;
  return (inner + k * width) / (ri + rj);
}

// a longer step makes more pairs doubtful; room for those that grow little by little
template <class Law> void PairPotdem<Law>::reset_dt()
{
  if (!monitor || update->dt <= monitored_step) return;
  constexpr double ahead = 1.5;
  const double step = update->dt;
  monitored_step = update->dt = ahead * step;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) find_alarm(i, j);
  update->dt = step;
}

template <class Law>
bool PairPotdem<Law>::is_deep(const Kernel &kernel, double r,
                              const POTDEM::ContactGeometry &partners)
{
  return r < FixPotdemMonitor::DEEP * partners.contact && kernel.hard_core(partners) == 0.0;
}

template <class Law>
void PairPotdem<Law>::suspect(ThreadShare &share, int i, int j, double r,
                              POTDEM::ContactGeometry partners) const
{
  if (share.doubtful_i >= 0) return;
  const auto &kernel = kernels[at(atom->type[i], atom->type[j])];
  if (!is_deep(kernel, r, partners) &&
      !monitor->pair_too_stiff_for_step(i, j, kernel.evaluate(r, partners).stiffness))
    return;
  share.doubtful_i = i;
  share.doubtful_j = j;
}

template <class Law> void PairPotdem<Law>::report(const ThreadShare &share)
{
  if (share.i >= 0) collapsed(share.i, share.j, hard_core(share.i, share.j));
  if (share.doubtful_i < 0) return;
  const int i = share.doubtful_i, j = share.doubtful_j;
  const auto &kernel = kernels[at(atom->type[i], atom->type[j])];
  const auto partners = geometry(i, j);
  const double r = distance(i, j);
  if (is_deep(kernel, r, partners))
    monitor->warn_of_deep_pair(i, j, r / partners.dbar());
  else
    monitor->warn_of_stiff_pair("The contact of", i, j, kernel.evaluate(r, partners).stiffness);
}

/* ---------------------------------------------------------------------- */

template <class Law> POTDEM::ContactMotion PairPotdem<Law>::motion(int i, int j) const
{
  POTDEM::ContactMotion found{};
  MathExtra::sub3(atom->x[i], atom->x[j], found.del);
  MathExtra::sub3(atom->v[i], atom->v[j], found.v);
  found.r = MathExtra::len3(found.del);
  if (!rotation) return found;
  POTDEM::spin_of(atom->omega[i], atom->omega[j], atom->radius[i], atom->radius[j], found);
  return found;
}

// arm: of friction, over the radius
template <class Law> POTDEM::ContactMasses PairPotdem<Law>::masses(int i, int j, double arm) const
{
  const double mi = atom->rmass[i], mj = atom->rmass[j];
  const double step = update->dt / force->mvv2e;
  if (!rotation) return {mi * mj, mi + mj, step, update->dt};
  const double share = POTDEM::sliding_mass(arm, POTDEM::SPHERE_INERTIA);
  return POTDEM::with_rolling({share * mi * mj, mi + mj, step, update->dt, share}, mi, mj,
                              atom->radius[i], atom->radius[j]);
}

template <class Law>
double PairPotdem<Law>::single(int i, int j, int itype, int jtype, double rsq,
                               double /*factor_coul*/, double factor_lj, double &fforce)
{
  fforce = 0.0;
  std::fill(svector, svector + single_extra, 0.0);
  if (MAX(i, j) >= atom->nlocal + atom->nghost) return without_particles();
  if (i >= atom->nlocal) std::swap(i, j);
  const double dbar = atom->radius[i] + atom->radius[j], r = sqrt(rsq);
  if (r >= reach(itype, jtype, dbar)) return 0.0;
  const auto partners = geometry(i, j);
  const auto &kernel = kernels[at(itype, jtype)];
  if (!(r > kernel.hard_core(partners))) collapsed(i, j, kernel.hard_core(partners));
  const auto law = kernel.evaluate(r, partners);
  fforce = factor_lj * law.force / r;
  svector[OVERLAP] = partners.contact - r;
  svector[STIFFNESS] = factor_lj * law.stiffness;
  if (sliding || viscous) dissipative(at(itype, jtype), i, j, r, factor_lj);
  return factor_lj * law.energy;
}

// the columns of single() for the forces that have no potential; friction is that on i
template <class Law>
void PairPotdem<Law>::dissipative(int pair, int i, int j, double r, double weight)
{
  const auto find = [&](const auto &rough, const auto &rate) {
    using Tangential = std::decay_t<decltype(rough)>;
    double state[Tangential::STATE + 1] = {};
    bool turned;
    const double *const memory = remembered(i, j, turned);
    if constexpr (Tangential::STATE > 0)
      if (memory) {
        std::copy_n(memory + 1, rough.STATE, state);
        if (turned) rough.turn(state);
      }
    const auto state_of_motion = [&] {
      return motion(i, j);
    };
    const auto both = [&] {
      return masses(i, j, 1.0);
    };
    return rotation ? POTDEM::contact_forces<true>(kernels[pair], r, geometry(i, j), weight, rate,
                                                   rough, state, false, state_of_motion, both)
                    : POTDEM::contact_forces<false>(kernels[pair], r, geometry(i, j), weight, rate,
                                                    rough, state, false, state_of_motion, both);
  };
  const auto found = std::visit(
      [&](const auto &rate) {
        if (!sliding) return find(POTDEM::Frictionless(), rate);
        return potdem_visit(friction[pair], [&](const auto &rough) {
          return find(rough, rate);
        });
      },
      viscous ? rates[pair] : PotdemRate());
  const auto &rubs = found.surface;
  double n[3];
  MathExtra::sub3(atom->x[i], atom->x[j], n);
  MathExtra::norm3(n);
  const double across = MathExtra::len3(rubs.friction), twist = MathExtra::dot3(rubs.torque, n);
  constexpr double rounding = 1e-9;
  const double limit = potdem_friction_mu(friction[pair]) * found.pressing;
  svector[VISCOUS] = found.viscous;
  svector[FRICTION] = across;
  for (int k = 0; k < 3; k++) svector[FRICTION + 1 + k] = rubs.friction[k];
  svector[SLIDES] = across > 0.0 && across >= (1.0 - rounding) * limit;
  svector[ROLLING] = sqrt(fmax(0.0, MathExtra::lensq3(rubs.torque) - twist * twist));
  svector[TWISTING] = twist;
}

/* ---------------------------------------------------------------------- */

template <class Law> void PairPotdem<Law>::add_stiffness_to(PotdemStiffness &sum, double ahead)
{
  const int *type = atom->type;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const double weight = force->special_lj[sbmask(list->firstneigh[i][jj])];
      if (weight == 0.0) continue;
      const double most = reach(type[i], type[j], atom->radius[i] + atom->radius[j]);
      if (ahead == 0.0 && distance(i, j) >= most) continue;
      const auto state = motion(i, j);
      const double r = ahead > 0.0 ? closest(i, j, state, most, ahead) : state.r;
      if (r < most)
        sum.add_pair(i, j, force->newton_pair || j < atom->nlocal, spring(i, j, state, r, weight));
    }
  }
}

// of springs: both ranks have a pair of two ranks in their lists, unless newton is on
template <class Law> void PairPotdem<Law>::add_energy_to(PotdemEnergies &all)
{
  if (!contacts || !contacts->has_state()) return;
  double mine = 0.0, over_ranks;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const double *const memory = contacts->memory(i, jj);
      if (!memory) continue;
      const double share = force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
      const auto &rough = friction[at(atom->type[i], atom->type[j])];
      mine += share * potdem_friction_energy(rough, memory + 1);
    }
  }
  MPI_Allreduce(&mine, &over_ranks, 1, MPI_DOUBLE, MPI_SUM, world);
  all.springs += over_ranks;
}

// of two particles that approach each other and touch within a time, where they turn back
template <class Law>
double PairPotdem<Law>::closest(int i, int j, const POTDEM::ContactMotion &state, double most,
                                double ahead) const
{
  const auto &kernel = kernels[at(atom->type[i], atom->type[j])];
  const auto partners = geometry(i, j);
  const auto between = masses(i, j, 1.0);
  return POTDEM::closest_approach(
      state.r, POTDEM::rate_of_distance(state), ahead, most, kernel.hard_core(partners),
      force->mvv2e * between.product / (between.sum * between.spin_share), [&](double r) {
        return kernel.evaluate(r, partners);
      });
}

// at the distance r
template <class Law>
POTDEM::Spring PairPotdem<Law>::spring(int i, int j, const POTDEM::ContactMotion &state, double r,
                                       double weight) const
{
  const int pair = at(atom->type[i], atom->type[j]);
  const auto partners = geometry(i, j);
  if (!(r > kernels[pair].hard_core(partners))) collapsed(i, j, kernels[pair].hard_core(partners));
  double n[3];
  MathExtra::scale3(1.0 / state.r, state.del, n);
  const auto between = masses(i, j, r / partners.dbar());
  return std::visit(
      [&](const auto &rate) {
        return potdem_visit(friction[pair], [&](const auto &rough) {
          return POTDEM::contact_spring(kernels[pair], r, partners, weight, rate, rough, between,
                                        n);
        });
      },
      rates[pair]);
}

}    // namespace LAMMPS_NS

#endif
