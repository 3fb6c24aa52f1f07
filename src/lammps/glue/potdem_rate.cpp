/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_rate.h"

using namespace LAMMPS_NS;

std::string LAMMPS_NS::potdem_rate_text(PotdemRate rate)
{
  return potdem_text(potdem_any_rows(rate));
}

double *LAMMPS_NS::potdem_rate_coefficient(PotdemRate &rate, const std::string &name)
{
  return potdem_coefficient(potdem_any_rows(rate), name);
}

bool LAMMPS_NS::potdem_rate_is_active(const PotdemRate &rate)
{
  return std::visit(
      [](const auto &law) {
        return law.active();
      },
      rate);
}

// one that was not given is the other one's law without effect
static PotdemRate like(const PotdemRate &rate, const PotdemRate &other)
{
  if (rate.index() == other.index() || !potdem_rate_text(rate).empty()) return rate;
  return std::visit(
      [](const auto &law) -> PotdemRate {
        return std::decay_t<decltype(law)>();
      },
      other);
}

bool LAMMPS_NS::potdem_mix_rates(const PotdemRate &a, const PotdemRate &b, PotdemRate &mixed)
{
  const auto first = like(a, b), second = like(b, first);
  if (first.index() != second.index()) return false;
  mixed = potdem_any_mixed(first, second);
  return true;
}

bool LAMMPS_NS::potdem_same_rate(const std::vector<PotdemRate> &all, PotdemRates &found)
{
  const auto itself = [](const PotdemRate &rate) -> const PotdemRate & {
    return rate;
  };
  const auto nothing = [&found] {
    found = std::monostate();
  };
  const auto make = [&](const auto &law) {
    using Law = std::decay_t<decltype(law)>;
    if constexpr (!std::is_same_v<Law, POTDEM::Elastic>) {
      std::vector<Law> laws;
      for (const auto &one : all)
        laws.push_back(std::holds_alternative<Law>(one) ? std::get<Law>(one) : Law());
      found = std::move(laws);
    }
  };
  return potdem_one_law(all, potdem_rate_is_active, itself, nothing, make);
}
