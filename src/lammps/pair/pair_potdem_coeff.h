/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The coefficients of PairPotdem<Law>, all by the tables of the laws: read, mixed, written, restarted, adapted. */

#ifndef LMP_PAIR_POTDEM_COEFF_H
#define LMP_PAIR_POTDEM_COEFF_H

#include "lammps/glue/potdem_law_io.h"
#include "lammps/glue/potdem_material_file.h"
#include "lammps/glue/potdem_width.h"
#include "lammps/output/fix_potdem_monitor.h"
#include "lammps/pair/pair_potdem.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "update.h"

#include <cmath>
#include <cstring>

namespace LAMMPS_NS {

template <class Law>
PairPotdem<Law>::PairPotdem(LAMMPS *lmp) :
    PairPotdemBase(lmp), of_style(potdem_default_rate<Law>()), kernel_known(false), sliding(false),
    viscous(false), width(potdem_width(lmp)), monitored_step(0.0)
{
  writedata = 1;
  single_enable = 1;
  single_extra = PotdemCompat::columns_in_single(lmp, force->pair_style) ? NEXTRA : 0;
  svector = new double[NEXTRA];
}

template <class Law> PairPotdem<Law>::~PairPotdem()
{
  delete[] svector;
  for (auto &one : adaptable) memory->destroy(one.values);
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

template <class Law> const char *PairPotdem<Law>::name() const
{
  static const std::string text = std::string("potdem/") + POTDEM::law_name<Law>();
  return text.c_str();
}

template <class Law> void PairPotdem<Law>::allocate()
{
  allocated = 1;
  atom_types = atom->ntypes;
  const int n = atom_types + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  std::fill(&setflag[0][0], &setflag[0][0] + n * n, 0);
  std::fill(&cutsq[0][0], &cutsq[0][0] + n * n, 0.0);
  laws.assign(n * n, Law{});
  law_mixed.assign(n * n, false);
  rates.assign(n * n, PotdemRate());
  friction.assign(n * n, PotdemFriction());
  kernels.resize(n * n);
  alarm.assign(n * n, 0.0);
}

template <class Law> void PairPotdem<Law>::settings(int narg, char **arg)
{
  PotdemInput input(lmp, fmt::format("pair_style {}", name()), narg, arg);
  const auto rows = potdem_any_rows(of_style);
  while (!input.done()) {
    if (input.next_is("rotation")) {
      rotation = input.logical("rotation");
    } else if (!potdem_read_setting(input, rows)) {
      const auto more = potdem_setting_names(rows);
      input.word();
      input.unknown(more.empty() ? "rotation" : "rotation or " + more);
    }
  }
}

/* ----------------------------------------------------------------------
   I J  the law's coefficients and keywords, or 'mixed'  [viscous ..., restitution ...]  [friction mu ...] [rolling ...] [twisting ...]
------------------------------------------------------------------------- */

template <class Law> void PairPotdem<Law>::coeff(int narg, char **arg)
{
  if (!allocated) allocate();
  if (lists_materials(narg, arg)) return coeff_by_material(narg, arg);
  PotdemMaterialInput input(lmp, fmt::format("pair_coeff {}", name()), narg, arg);
  int ilo, ihi, jlo, jhi, first = 0;
  input.type_ranges(ilo, ihi, jlo, jhi);
  for (int i = ilo; i <= ihi; i++)
    for (int j = MAX(jlo, i); j <= jhi; j++) {
      const int pair = at(i, j);
      if (!first) {
        read(input, pair);
        first = pair;
      }
      if (law_mixed[first] && i == j)
        error->all(FLERR, "pair_coeff {}: 'mixed' is for types I != J, {} has its own law", name(),
                   i);
      laws[pair] = laws[first];
      law_mixed[pair] = law_mixed[first];
      rates[pair] = rates[first];
      friction[pair] = friction[first];
      mirror(i, j);
      setflag[i][j] = 1;
    }
  if (!first)
    error->all(FLERR, "pair_coeff {}: no pair of types I <= J in the range given", name());
  show_to_adapt();
}

template <class Law> void PairPotdem<Law>::mirror(int i, int j)
{
  laws[at(j, i)] = laws[at(i, j)];
  law_mixed[at(j, i)] = law_mixed[at(i, j)];
  rates[at(j, i)] = rates[at(i, j)];
  friction[at(j, i)] = friction[at(i, j)];
}

template <class Law> void PairPotdem<Law>::read(PotdemMaterialInput &input, int pair)
{
  Law law{};
  PotdemRate rate = of_style;
  PotdemFriction rough;
  const bool mixed = input.next_is("mixed");
  const auto of_law = mixed ? PotdemLawRows() : potdem_rows(law);
  potdem_read_required(input, of_law);
  if (!mixed) potdem_complete(law);
  while (!input.done()) {
    if (potdem_read_option(input, of_law) || potdem_read_rate<Law>(input, of_style, rate) ||
        potdem_read_friction(input, rough))
      continue;
    input.word();
    input.unknown(potdem_law_names<Law>(of_law) + POTDEM_FRICTION_NAMES + " or twisting");
  }
  potdem_check_friction<Law>(input, rough, rotation);
  laws[pair] = law;
  law_mixed[pair] = mixed;
  rates[pair] = rate;
  friction[pair] = rough;
}

template <class Law> bool PairPotdem<Law>::lists_materials(int narg, char **arg) const
{
  return narg > 2 && strcmp(arg[0], "*") == 0 && strcmp(arg[1], "*") == 0 &&
      PotdemMaterialFile::is(arg[2]);
}

/* ----------------------------------------------------------------------
   * *  FILE.potdem  a material or NULL for each type  what follows in pair_coeff
   the same as a pair_coeff for each type; pairs of them are mixed
------------------------------------------------------------------------- */

template <class Law> void PairPotdem<Law>::coeff_by_material(int narg, char **arg)
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
template <class Law> void PairPotdem<Law>::leave_to_mixing(int i, int j)
{
  setflag[i][j] = 0;
  if (force->pair == this) return;
  mix(i, j);
  setflag[i][j] = 1;
}

template <class Law> void PairPotdem<Law>::mix_law(int i, int j)
{
  if (!setflag[i][i] || !setflag[j][j])
    error->all(FLERR, "pair_style {}: coefficients for types {} and {} are not set; use pair_coeff",
               name(), i, j);
  auto &a = laws[at(i, i)], &b = laws[at(j, j)];
  if (const char *differs = potdem_disagreement(potdem_rows(a), potdem_rows(b)))
    cannot_mix(i, j, differs);
  laws[at(i, j)] = Law::mixed(a, b);
}

template <class Law> void PairPotdem<Law>::mix(int i, int j)
{
  mix_law(i, j);
  if (!potdem_mix_rates(rates[at(i, i)], rates[at(j, j)], rates[at(i, j)]))
    error->all(
        FLERR,
        "pair_style {}: types {} and {} lose energy by different laws; give pair_coeff {} {} "
        "explicitly, all of one law",
        name(), i, j, i, j);
  if (!potdem_mix_friction(friction[at(i, i)], friction[at(j, j)], friction[at(i, j)]))
    error->all(
        FLERR,
        "pair_style {}: types {} and {} have different laws of friction; give all pair_coeff "
        "of one style the same one, or use pair_style hybrid",
        name(), i, j);
  mirror(i, j);
}

/* ---------------------------------------------------------------------- */

template <class Law> void PairPotdem<Law>::init_style()
{
  find_needs();
  potdem_align_friction(friction);
  int state = 0;
  for (const auto &one : friction) state = MAX(state, potdem_friction_state(one));
  find_contacts(state);
  require_particles(Law::contact_only, sliding, viscous);
  monitored_step = update->dt;
}

template <class Law> void PairPotdem<Law>::find_needs()
{
  sliding = viscous = kernel_known = false;
  if (potdem_minimizes(lmp)) return;
  for (const auto &one : friction) sliding = sliding || potdem_friction_acts(one);
  for (const auto &one : rates) viscous = viscous || potdem_rate_is_active(one);
}

// types without particles have no contacts
template <class Law> double PairPotdem<Law>::init_one(int i, int j)
{
  if (!adaptable.empty()) {
    take_adapted(i, i);
    take_adapted(j, j);
    take_adapted(i, j);
  }
  if (setflag[i][j] == 0) {
    mix(i, j);
    find_needs();
  } else if (law_mixed[at(i, j)]) {
    mix_law(i, j);
  }
  mirror(i, j);
  kernels[at(i, j)] = kernels[at(j, i)] = laws[at(i, j)].kernel(offset_flag != 0);
  find_alarm(i, j);
  return reach(i, j, largest_radius[i] + largest_radius[j]);
}

/* ----------------------------------------------------------------------
   fix adapt changes the values that extract() gives it, and has init_one() called
------------------------------------------------------------------------- */

template <class Law> void *PairPotdem<Law>::extract(const char *str, int &dim)
{
  dim = 2;
  const std::string wanted = str;
  if (!allocated || !coeff_named(at(1, 1), wanted)) return nullptr;
  if (velocity_coeff_named(at(1, 1), wanted)) comm->ghost_velocity = 1;    // may be zero until now
  if (wanted == "eta")
    for (const auto &one : friction)
      if (potdem_friction_is_auto(one))
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

// those of forces that depend on velocities
template <class Law>
double *PairPotdem<Law>::velocity_coeff_named(int pair, const std::string &wanted)
{
  double *const found = potdem_friction_coefficient(friction[pair], wanted);
  return found ? found : potdem_rate_coefficient(rates[pair], wanted);
}

template <class Law> double *PairPotdem<Law>::coeff_named(int pair, const std::string &wanted)
{
  double *const found = velocity_coeff_named(pair, wanted);
  return found || law_mixed[pair] ? found : potdem_coefficient(potdem_rows(laws[pair]), wanted);
}

template <class Law> void PairPotdem<Law>::show_to_adapt()
{
  for (auto &one : adaptable)
    for (int i = 1; i <= atom_types; i++)
      for (int j = 1; j <= atom_types; j++) {
        const double *const value = coeff_named(at(MIN(i, j), MAX(i, j)), one.name);
        one.values[i][j] = value ? *value : 0.0;
      }
}

// mixed pairs follow their types
template <class Law> void PairPotdem<Law>::take_adapted(int i, int j)
{
  if (!setflag[i][j]) return;
  bool changed = false;
  for (const auto &one : adaptable) {
    double *const value = coeff_named(at(i, j), one.name);
    if (!value) continue;
    changed = changed || *value != one.values[i][j];
    *value = one.values[i][j];
  }
  if (!changed) return;
  PotdemWords words(coeff_line(at(i, j)));
  PotdemMaterialInput input(lmp,
                            fmt::format("pair_style {}, coefficients changed by a fix", name()),
                            words.narg(), words.arg());
  read(input, at(i, j));
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

template <class Law> void PairPotdem<Law>::write_restart_settings(FILE *fp)
{
  potdem_write_text(fp,
                    fmt::format("shift {} mix {} rotation {}{}", offset_flag, mix_flag,
                                rotation ? "yes" : "no",
                                potdem_setting_text(potdem_any_rows(of_style))));
}

// what pair_modify said comes first
template <class Law> void PairPotdem<Law>::read_restart_settings(FILE *fp)
{
  auto words = utils::split_words(potdem_read_text(lmp, fp, fmt::format("pair_style {}", name())));
  offset_flag = utils::inumeric(FLERR, words.at(1), true, lmp);
  mix_flag = utils::inumeric(FLERR, words.at(3), true, lmp);
  words.erase(words.begin(), words.begin() + 4);
  PotdemWords rest(words);
  settings(rest.narg(), rest.arg());
}

// a line for each pair of types, empty where it was not given
template <class Law> void PairPotdem<Law>::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      potdem_write_text(fp, setflag[i][j] ? coeff_line(at(i, j)) : "");
}

template <class Law> void PairPotdem<Law>::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  const auto who = fmt::format("pair_style {}, coefficients in a restart file", name());
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      PotdemWords words(potdem_read_text(lmp, fp, who));
      setflag[i][j] = words.narg() > 0;
      if (!setflag[i][j]) continue;
      PotdemMaterialInput input(lmp, who, words.narg(), words.arg());
      read(input, at(i, j));
      mirror(i, j);
    }
}

// as pair_coeff takes it
template <class Law> std::string PairPotdem<Law>::coeff_line(int pair) const
{
  auto law = laws[pair];
  const auto of_law = law_mixed[pair] ? "mixed" : potdem_text(potdem_rows(law));
  const auto of_rate = potdem_rate_text(rates[pair]);
  return of_law + (of_rate.empty() ? "" : " " + of_rate) + potdem_friction_text(friction[pair]);
}

template <class Law> void PairPotdem<Law>::write_data(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++) utils::print(fp, "{} {}\n", i, coeff_line(at(i, i)));
}

template <class Law> void PairPotdem<Law>::write_data_all(FILE *fp)
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      utils::print(fp, "{} {} {}\n", i, j, coeff_line(at(i, j)));
}

}    // namespace LAMMPS_NS

#endif
