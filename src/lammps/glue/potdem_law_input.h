/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Reading and writing the coefficients of the contact laws, for pairs and for walls. For each law: the required
   values, one optional keyword at a time, the keywords' names for the error message, the text that
   reads back as the same law, and the coefficient of a given name (null: none), for fix adapt. A law whose coefficient
   has been changed must be read back from its text, which checks it and completes what depends on it.
   'FILE.potdem MATERIAL' may stand for E and for E nu, and with 'length L' for K0. */

#ifndef LMP_POTDEM_LAW_INPUT_H
#define LMP_POTDEM_LAW_INPUT_H

#include "core/laws/hertz.h"
#include "core/laws/regularised_granular.h"
#include "core/laws/shifted_lj.h"
#include "core/laws/truss_contact.h"
#include "lammps/glue/potdem_input.h"

namespace LAMMPS_NS {

// E a  [penetration m [normalized]]
void read_law(PotdemInput &, POTDEM::TrussContact &);
bool read_option(PotdemInput &, POTDEM::TrussContact &);
std::string law_text(const POTDEM::TrussContact &);
double *law_coefficient(POTDEM::TrussContact &, const std::string &name);
constexpr const char *option_names(const POTDEM::TrussContact &)
{
  return "penetration";
}

// K0 R n alpha  [cut s_c] [linear s_min]
void read_law(PotdemInput &, POTDEM::ShiftedLJ &);
bool read_option(PotdemInput &, POTDEM::ShiftedLJ &);
std::string law_text(const POTDEM::ShiftedLJ &);
double *law_coefficient(POTDEM::ShiftedLJ &, const std::string &name);
constexpr const char *option_names(const POTDEM::ShiftedLJ &)
{
  return "cut, linear";
}

// K0 n alpha  [cut x] [linear x_min]
void read_law(PotdemInput &, POTDEM::RegularisedGranular &);
bool read_option(PotdemInput &, POTDEM::RegularisedGranular &);
std::string law_text(const POTDEM::RegularisedGranular &);
double *law_coefficient(POTDEM::RegularisedGranular &, const std::string &name);
constexpr const char *option_names(const POTDEM::RegularisedGranular &)
{
  return "cut, linear";
}

// E nu  [viscous H]
void read_law(PotdemInput &, POTDEM::Hertz &);
bool read_option(PotdemInput &, POTDEM::Hertz &);
std::string law_text(const POTDEM::Hertz &);
double *law_coefficient(POTDEM::Hertz &, const std::string &name);
constexpr const char *option_names(const POTDEM::Hertz &)
{
  return "viscous";
}

}    // namespace LAMMPS_NS

#endif
