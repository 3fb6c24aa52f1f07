/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "lammps/glue/potdem_restart_block.h"

#include "error.h"
#include "fmt/format.h"
#include "lammps.h"

#include <algorithm>

using namespace LAMMPS_NS;

// before the numbers: the form of restart files, how many numbers, the same with a minus, because LAMMPS does not tell the size of what
// it has read, and their checksum
static constexpr double FORM = 6.0;
enum { FORM_AT, COUNT_AT, MINUS_COUNT_AT, SUM_AT, HEAD };

std::uint64_t LAMMPS_NS::potdem_checksum(const void *bytes, std::size_t count)
{
  const auto *const byte = static_cast<const unsigned char *>(bytes);
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t k = 0; k < count; k++) sum = (sum ^ byte[k]) * 1099511628211ULL;
  return sum;
}

// 48 bits of it, which a double holds exactly
static double shortened(std::uint64_t sum)
{
  return static_cast<double>((sum ^ (sum >> 48)) & 0xffffffffffffULL);
}

static double short_sum(const std::vector<double> &values)
{
  return shortened(potdem_checksum(values.data(), values.size() * sizeof(double)));
}

void PotdemSum::add(const double *row, std::size_t width)
{
  sum += potdem_checksum(row, width * sizeof(double));
  rows++;
}

double PotdemSum::value(MPI_Comm world) const
{
  std::uint64_t all;
  MPI_Allreduce(&sum, &all, 1, MPI_UINT64_T, MPI_SUM, world);
  return shortened(all);
}

std::int64_t PotdemSum::count(MPI_Comm world) const
{
  std::int64_t all;
  MPI_Allreduce(&rows, &all, 1, MPI_INT64_T, MPI_SUM, world);
  return all;
}

void LAMMPS_NS::potdem_write_block(FILE *fp, const std::vector<double> &values)
{
  const auto count = static_cast<double>(values.size());
  const double head[HEAD] = {FORM, count, -count, short_sum(values)};
  const int size = static_cast<int>(sizeof(head) + values.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(head, sizeof(head), 1, fp);
  if (!values.empty()) fwrite(values.data(), sizeof(double), values.size(), fp);
}

void LAMMPS_NS::potdem_refuse_version(LAMMPS *lmp, const std::string &owner)
{
  lmp->error->all(FLERR,
                  "{}: the restart file was written by another version of POTDEM, or is damaged; "
                  "continue it with that version, or from another file",
                  owner);
}

void LAMMPS_NS::potdem_refuse_damaged(LAMMPS *lmp, const std::string &owner)
{
  lmp->error->all(FLERR,
                  "{}: the restart file is damaged, its checksum does not fit; continue from "
                  "another file",
                  owner);
}

bool LAMMPS_NS::potdem_is_damaged(const std::vector<double> &in_file,
                                  const std::vector<double> &now)
{
  return in_file.size() == now.size() && std::equal(now.begin(), now.end() - 1, in_file.begin()) &&
      in_file.back() != now.back();
}

std::vector<double> LAMMPS_NS::potdem_read_block(LAMMPS *lmp, const std::string &owner,
                                                 const char *buf)
{
  const auto *const all = reinterpret_cast<const double *>(buf);
  if (!all || all[FORM_AT] != FORM || all[COUNT_AT] != -all[MINUS_COUNT_AT])
    potdem_refuse_version(lmp, owner);
  const std::vector<double> values(all + HEAD,
                                   all + HEAD + static_cast<std::size_t>(all[COUNT_AT]));
  if (all[SUM_AT] != short_sum(values)) potdem_refuse_damaged(lmp, owner);
  return values;
}

std::vector<double> LAMMPS_NS::potdem_read_block(LAMMPS *lmp, const std::string &owner,
                                                 const char *buf, std::size_t count)
{
  auto values = potdem_read_block(lmp, owner, buf);
  if (values.size() != count) potdem_refuse_version(lmp, owner);
  return values;
}
