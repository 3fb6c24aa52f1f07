/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_friction.h"

using namespace LAMMPS_NS;

// the law that the keyword after mu says
static PotdemFriction law_by_keyword(PotdemInput &input)
{
#define POTDEM_TRY(Law) \
  if (*POTDEM::Law::keyword && input.next_is(POTDEM::Law::keyword)) return POTDEM::Law{};
  TANGENTIAL_LAWS(POTDEM_TRY)
#undef POTDEM_TRY
  return {};
}

PotdemFriction LAMMPS_NS::potdem_read_friction(PotdemMaterialInput &input)
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

std::string LAMMPS_NS::potdem_friction_text(const PotdemFriction &friction)
{
  return std::visit(
      [](auto law) -> std::string {
        auto rows = potdem_rows(law);
        bool given = false;
        for (const auto &row : rows)
          given = given || *row.value != 0.0 || (row.word && *row.word_given != 0.0);
        if (!given) return "";
        rows.erase(rows.begin());
        const auto rest = potdem_text(rows);
        std::string text = fmt::format(" friction {:.17g}", law.mu);
        if (*law.keyword) text += std::string(" ") + law.keyword;
        return rest.empty() ? text : text + " " + rest;
      },
      friction);
}

double LAMMPS_NS::potdem_friction_mu(const PotdemFriction &friction)
{
  return std::visit(
      [](const auto &law) {
        return law.mu;
      },
      friction);
}

double *LAMMPS_NS::potdem_friction_coefficient(PotdemFriction &friction, const std::string &name)
{
  return std::visit(
      [&name](auto &law) {
        return potdem_coefficient(potdem_rows(law), name);
      },
      friction);
}

bool LAMMPS_NS::potdem_friction_is_auto(const PotdemFriction &friction)
{
  const auto *const sliding = std::get_if<POTDEM::Sliding>(&friction);
  return sliding && sliding->automatic != 0.0;
}

int LAMMPS_NS::potdem_friction_state(const PotdemFriction &friction)
{
  return std::visit(
      [](const auto &law) {
        return law.STATE;    // with mu = 0 too: fix adapt may raise it
      },
      friction);
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
      friction);
}

double LAMMPS_NS::potdem_friction_energy(const PotdemFriction &friction, const double *state)
{
  return std::visit(
      [state](const auto &law) {
        if constexpr (std::decay_t<decltype(law)>::STATE > 0) return law.energy(state);
        return 0.0;
      },
      friction);
}

bool LAMMPS_NS::potdem_mix_friction(const PotdemFriction &a, const PotdemFriction &b,
                                    PotdemFriction &mixed)
{
  if (a.index() != b.index()) {
    const bool a_none = potdem_friction_mu(a) == 0.0, b_none = potdem_friction_mu(b) == 0.0;
    if (a_none || b_none) mixed = a_none ? a : b;
    return a_none || b_none;
  }
  mixed = std::visit(
      [&b](const auto &law) -> PotdemFriction {
        using Law = std::decay_t<decltype(law)>;
        return Law::mixed(law, std::get<Law>(b));
      },
      a);
  return true;
}

bool LAMMPS_NS::potdem_same_law(const std::vector<PotdemFriction> &all, PotdemFrictions &found)
{
  found = std::monostate();
  const PotdemFriction *first = nullptr;
  for (const auto &one : all) {
    if (potdem_friction_mu(one) == 0.0) continue;
    if (!first) first = &one;
    if (first->index() != one.index()) return false;
  }
  if (!first) return true;
  std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        std::vector<Law> laws;
        for (const auto &one : all)
          laws.push_back(std::holds_alternative<Law>(one) ? std::get<Law>(one) : Law{});
        found = std::move(laws);
      },
      *first);
  return true;
}
