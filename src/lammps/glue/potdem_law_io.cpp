/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_law_io.h"

using namespace LAMMPS_NS;

using Row = PotdemLawRow;

std::string PotdemLawRow::label() const
{
  if (!*symbol) return std::string(name) + owner;
  return kind == REQUIRED ? symbol : fmt::format("{} {}", name, symbol);
}

static double read_number(PotdemInput &input, const Row &row)
{
  if (row.word) {
    *row.word_given = input.next_is(row.word);
    if (*row.word_given != 0.0) return 0.0;
  }
  auto range = row.range;
  if (row.bound) {
    range.high = *row.bound;
    range.high_open = true;
  }
  return input.in_range(row.label(), range);
}

// of one material, as far as the rows of one owner go; how many of them
static std::size_t read_properties(PotdemMaterialInput &input, const PotdemLawRows &rows,
                                   std::size_t first)
{
  std::vector<const char *> names;
  std::size_t last = first;
  do {
    names.push_back(rows[last++].name);
  } while (last < rows.size() && rows[last].kind == Row::REQUIRED &&
           rows[last].source == Row::MATERIAL && !rows[last].after);
  const auto values = input.properties(names, rows[first].owner);
  for (std::size_t k = first; k < last; k++) *rows[k].value = values[k - first];
  return last - first;
}

void LAMMPS_NS::potdem_read_required(PotdemMaterialInput &input, const PotdemLawRows &rows)
{
  for (std::size_t k = 0; k < rows.size();) {
    const auto &row = rows[k];
    if (row.after && !input.next_is(row.after)) input.fail(row.missing);
    if (row.kind != Row::REQUIRED) {
      k++;
    } else if (row.source == Row::MATERIAL) {
      k += read_properties(input, rows, k);
    } else {
      *row.value = row.source == Row::MATERIAL_LENGTH ? input.stiffness(row.label())
                                                      : read_number(input, row);
      k++;
    }
  }
}

bool LAMMPS_NS::potdem_read_option(PotdemMaterialInput &input, const PotdemLawRows &rows)
{
  for (std::size_t k = 0; k < rows.size(); k++) {
    const auto &row = rows[k];
    if (row.kind != Row::OPTION || !input.next_is(row.name)) continue;
    *row.value = 0.0;
    if (row.can_be_none && input.next_is("none")) return true;
    *row.value = read_number(input, row);
    for (k++; k < rows.size(); k++) {
      if (rows[k].kind == Row::CONTINUED)
        *rows[k].value = read_number(input, rows[k]);
      else if (rows[k].kind == Row::FLAG)
        *rows[k].value = input.next_is(rows[k].name);
      else
        break;
    }
    return true;
  }
  return false;
}

bool LAMMPS_NS::potdem_read_setting(PotdemInput &input, const PotdemLawRows &rows)
{
  for (const auto &row : rows)
    if (row.kind == Row::SETTING && input.next_is(row.name)) {
      *row.value = input.logical(row.name);
      return true;
    }
  return false;
}

/* ---------------------------------------------------------------------- */

// an option was given if it is not 0; or 0 by its value, which further ones follow
static bool is_given(const PotdemLawRows &rows, std::size_t k)
{
  if (*rows[k].value != 0.0) return true;
  if (!rows[k].range.has(0.0)) return false;
  while (++k < rows.size() && rows[k].kind == Row::CONTINUED)
    if (*rows[k].value != 0.0) return true;
  return false;
}

std::string LAMMPS_NS::potdem_text(const PotdemLawRows &rows)
{
  std::string text;
  bool given = false;
  for (std::size_t k = 0; k < rows.size(); k++) {
    const auto &row = rows[k];
    const bool by_word = row.word && *row.word_given != 0.0;
    const auto number = by_word ? std::string(row.word) : fmt::format("{:.17g}", *row.value);
    if (row.kind == Row::OPTION) given = is_given(rows, k);
    std::string words;
    if (row.kind == Row::REQUIRED || (row.kind == Row::CONTINUED && given))
      words = number;
    else if (row.kind == Row::OPTION && given)
      words = fmt::format("{} {}", row.name, number);
    else if (row.kind == Row::FLAG && given && *row.value != 0.0)
      words = row.name;
    if (words.empty()) continue;
    text += (text.empty() ? "" : " ") + words;
  }
  return text;
}

std::string LAMMPS_NS::potdem_setting_text(const PotdemLawRows &rows)
{
  std::string text;
  for (const auto &row : rows)
    if (row.kind == Row::SETTING && *row.value != 0.0) text += fmt::format(" {} yes", row.name);
  return text;
}

static std::string names(const PotdemLawRows &rows, Row::Kind kind)
{
  std::string text;
  for (const auto &row : rows)
    if (row.kind == kind) text += (text.empty() ? "" : ", ") + std::string(row.name);
  return text;
}

std::string LAMMPS_NS::potdem_option_names(const PotdemLawRows &rows)
{
  return names(rows, Row::OPTION);
}

std::string LAMMPS_NS::potdem_setting_names(const PotdemLawRows &rows)
{
  return names(rows, Row::SETTING);
}

/* ---------------------------------------------------------------------- */

double *LAMMPS_NS::potdem_coefficient(const PotdemLawRows &rows, const std::string &name)
{
  for (const auto &row : rows)
    if ((row.kind == Row::REQUIRED || row.kind == Row::OPTION) && name == row.name)
      return row.value;
  return nullptr;
}

const char *LAMMPS_NS::potdem_disagreement(const PotdemLawRows &a, const PotdemLawRows &b)
{
  const char *option = nullptr;
  for (std::size_t k = 0; k < a.size(); k++) {
    if (a[k].kind != Row::FLAG) option = a[k].name;
    if (a[k].agree && *a[k].value != *b[k].value) return option;
  }
  return nullptr;
}
