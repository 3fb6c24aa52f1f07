/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_friction.h"

#include "lammps/glue/potdem_any_law.h"

#include <algorithm>
#include <utility>

using namespace LAMMPS_NS;

const char *const LAMMPS_NS::POTDEM_FRICTION_NAMES = "friction, rolling";

// the law that the keyword after mu says
static PotdemTangential::Laws::Any law_by_keyword(PotdemInput &input)
{
#define POTDEM_TRY(Law) \
  if (*POTDEM::Law::keyword && input.next_is(POTDEM::Law::keyword)) return POTDEM::Law{};
  TANGENTIAL_LAWS(POTDEM_TRY)
#undef POTDEM_TRY
  return {};
}

static PotdemTangential::Laws::Any read_law(PotdemMaterialInput &input)
{
  const double mu = input.friction_mu();
  auto found = law_by_keyword(input);
  std::visit(
      [&input, mu](auto &law) {
        auto rows = potdem_rows(law);
        rows.erase(rows.begin());
        potdem_read_required(input, rows);
        while (potdem_read_option(input, rows)) {}
        law.mu = mu;
        potdem_complete(law);
      },
      found);
  return found;
}

bool LAMMPS_NS::potdem_read_friction(PotdemMaterialInput &input, PotdemFriction &friction)
{
  if (!input.next_is("friction"))
    return potdem_read_option(input, potdem_rows(friction.resistance));
  friction.law = read_law(input);
  return true;
}

static std::string text_of(PotdemTangential::Laws::Any any)
{
  return std::visit(
      [](auto &law) -> std::string {
        auto rows = potdem_rows(law);
        const bool given = std::any_of(rows.begin(), rows.end(), [](const PotdemLawRow &row) {
          return *row.value != 0.0 || (row.word && *row.word_given != 0.0);
        });
        if (!given) return "";
        rows.erase(rows.begin());
        const auto rest = potdem_text(rows);
        std::string text = fmt::format(" friction {:.17g}", law.mu);
        if (*law.keyword) text += std::string(" ") + law.keyword;
        return rest.empty() ? text : text + " " + rest;
      },
      any);
}

std::string LAMMPS_NS::potdem_friction_text(const PotdemFriction &friction)
{
  auto resistance = friction.resistance;
  const auto rest = potdem_text(potdem_rows(resistance));
  return text_of(friction.law) + (rest.empty() ? "" : " " + rest);
}

double LAMMPS_NS::potdem_friction_mu(const PotdemFriction &friction)
{
  return std::visit(
      [](const auto &law) {
        return law.mu;
      },
      friction.law);
}

double *LAMMPS_NS::potdem_friction_coefficient(PotdemFriction &friction, const std::string &name)
{
  double *const of_law = potdem_coefficient(potdem_any_rows(friction.law), name);
  return of_law ? of_law : potdem_coefficient(potdem_rows(friction.resistance), name);
}

bool LAMMPS_NS::potdem_friction_is_auto(const PotdemFriction &friction)
{
  const auto *const sliding = std::get_if<POTDEM::Sliding>(&friction.law);
  return sliding && sliding->automatic != 0.0;
}

bool LAMMPS_NS::potdem_friction_acts(const PotdemFriction &friction)
{
  return potdem_friction_mu(friction) > 0.0 || friction.resistance.active();
}

static int sliding_state(const PotdemFriction &friction)
{
  return std::visit(
      [](const auto &law) {
        return law.STATE;
      },
      friction.law);
}

// with mu = 0 too: fix adapt may raise it
int LAMMPS_NS::potdem_friction_state(const PotdemFriction &friction)
{
  return sliding_state(friction) +
      (friction.resistance.given() ? POTDEM::RollingResistance::STATE : 0);
}

template <class Law>
static auto needs_shear_ratio(const Law &, int) -> decltype(Law::needs_shear_ratio, true)
{
  return Law::needs_shear_ratio;
}
template <class Law> static bool needs_shear_ratio(const Law &, long)
{
  return false;
}

bool LAMMPS_NS::potdem_friction_needs_shear_ratio(const PotdemFriction &friction)
{
  return std::visit(
      [](const auto &law) {
        return needs_shear_ratio(law, 0);
      },
      friction.law);
}

double LAMMPS_NS::potdem_friction_energy(const PotdemFriction &friction, const double *state)
{
  return potdem_visit(friction, [state](const auto &law) {
    if constexpr (std::decay_t<decltype(law)>::STATE > 0) return law.energy(state);
    return 0.0;
  });
}

bool LAMMPS_NS::potdem_mix_friction(const PotdemFriction &a, const PotdemFriction &b,
                                    PotdemFriction &mixed)
{
  mixed.resistance = POTDEM::RollingResistance::mixed(a.resistance, b.resistance);
  if (a.law.index() != b.law.index()) {
    const bool a_none = potdem_friction_mu(a) == 0.0, b_none = potdem_friction_mu(b) == 0.0;
    if (a_none || b_none) mixed.law = a_none ? a.law : b.law;
    return a_none || b_none;
  }
  mixed.law = potdem_any_mixed(a.law, b.law);
  return true;
}

// of several without friction, the law that keeps most
void LAMMPS_NS::potdem_align_friction(std::vector<PotdemFriction> &all)
{
  const auto rank = [](const PotdemFriction &one) {
    return std::pair(potdem_friction_mu(one) > 0.0, sliding_state(one));
  };
  const auto first =
      std::max_element(all.begin(), all.end(), [&rank](const auto &a, const auto &b) {
        return rank(a) < rank(b);
      });
  const auto law = std::visit(
      [](const auto &found) -> PotdemTangential::Laws::Any {
        return std::decay_t<decltype(found)>();
      },
      first->law);
  for (auto &one : all)
    if (potdem_friction_mu(one) == 0.0 && one.law.index() != law.index()) one.law = law;
}

bool LAMMPS_NS::potdem_same_law(const std::vector<PotdemFriction> &all, PotdemFrictions &found)
{
  const auto rolls = [](const PotdemFriction &one) {
    return one.resistance.active();
  };
  const bool rolling = std::any_of(all.begin(), all.end(), rolls);
  const auto matters = [&](const PotdemFriction &one) {
    return potdem_friction_mu(one) > 0.0 || rolls(one);
  };
  const auto law_of = [](const PotdemFriction &one) -> const auto &
  {
    return one.law;
  };
  const auto nothing = [&found] {
    found = std::monostate();
  };
  const auto make = [&](const auto &law) {
    using Law = std::decay_t<decltype(law)>;
    std::vector<Law> sliding;
    std::vector<POTDEM::Rolls<Law>> laws;
    for (const auto &one : all) {
      sliding.push_back(std::holds_alternative<Law>(one.law) ? std::get<Law>(one.law) : Law{});
      laws.push_back({sliding.back(), one.resistance});
    }
    if (rolling)
      found = std::move(laws);
    else
      found = std::move(sliding);
  };
  return potdem_one_law(all, matters, law_of, nothing, make);
}
