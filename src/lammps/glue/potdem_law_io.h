/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Any law by its table of coefficients (core/laws/coefficients.h): read from the arguments of a command, written as the text
   that reads back as the same law, which is also what restart and data files keep, and one coefficient by its name, for
   extract() and fix adapt. A law whose coefficient has been changed must be read back from its text, which checks it and
   completes what depends on it. */

#ifndef LMP_POTDEM_LAW_IO_H
#define LMP_POTDEM_LAW_IO_H

#include "core/laws/coefficients.h"
#include "lammps/glue/potdem_material_input.h"

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

// a coefficient of one law
struct PotdemLawRow : public POTDEM::CoefficientTraits {
  double *value;
  const double *bound;    // null: none
  double *word_given;     // null: no word may stand for it

  std::string label() const;    // as errors name it
};
using PotdemLawRows = std::vector<PotdemLawRow>;

template <class Law> PotdemLawRows potdem_rows(Law &law)
{
  PotdemLawRows rows;
  for (const auto &one : Law::coefficients())
    rows.push_back({one, &(law.*one.value), one.bound ? &(law.*one.bound) : nullptr,
                    one.word_given ? &(law.*one.word_given) : nullptr});
  return rows;
}

void potdem_read_required(PotdemMaterialInput &, const PotdemLawRows &);
bool potdem_read_option(PotdemMaterialInput &,
                        const PotdemLawRows &);    // the next one, if it is of this law
bool potdem_read_setting(PotdemInput &, const PotdemLawRows &);

std::string potdem_text(const PotdemLawRows &);            // as the command takes it
std::string potdem_setting_text(const PotdemLawRows &);    // likewise, after a blank
std::string potdem_option_names(const PotdemLawRows &);
std::string potdem_setting_names(const PotdemLawRows &);

double *potdem_coefficient(const PotdemLawRows &, const std::string &name);    // null: no such one

// the coefficient in which two laws differ that must agree in it; null: they can be mixed
const char *potdem_disagreement(const PotdemLawRows &, const PotdemLawRows &);

template <class Law> auto potdem_complete(Law &law, int) -> decltype(law.complete())
{
  law.complete();
}

template <class Law> void potdem_complete(Law &, long) {}

template <class Law> void potdem_complete(Law &law)
{
  potdem_complete(law, 0);
}

}    // namespace LAMMPS_NS

#endif
