/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What a fix of the package keeps in restart files: its numbers, after the form in which they are written and a checksum. */

#ifndef LMP_POTDEM_RESTART_BLOCK_H
#define LMP_POTDEM_RESTART_BLOCK_H

#include <mpi.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class LAMMPS;

// of bytes: changes with any bit of them, and with their order (FNV-1a with 64 bits)
std::uint64_t potdem_checksum(const void *bytes, std::size_t count);

// of rows of numbers that are spread over the ranks, in any order
class PotdemSum {
 public:
  void add(const double *row, std::size_t width);
  double value(MPI_Comm) const;
  std::int64_t count(MPI_Comm) const;    // of rows

 private:
  std::uint64_t sum = 0;
  std::int64_t rows = 0;
};

// of what is kept with the particles: have as many rows, and such as fit here (all numbers but the last), another checksum than in the file?
bool potdem_is_damaged(const std::vector<double> &in_file, const std::vector<double> &now);

// the errors for all that the package reads from such a file; owner: what it is
[[noreturn]] void potdem_refuse_version(LAMMPS *, const std::string &owner);
[[noreturn]] void potdem_refuse_damaged(LAMMPS *, const std::string &owner);

// by the first rank, in Fix::write_restart()
void potdem_write_block(FILE *, const std::vector<double> &values);

// in Fix::restart(): ends with an error that names `owner` if they are not those that were written, or not `count` of them
std::vector<double> potdem_read_block(LAMMPS *, const std::string &owner, const char *buf);
std::vector<double> potdem_read_block(LAMMPS *, const std::string &owner, const char *buf,
                                      std::size_t count);

}    // namespace LAMMPS_NS

#endif
