/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_POTDEM_STRAIN_ATOM_H
#define LMP_COMPUTE_POTDEM_STRAIN_ATOM_H

#include "core/laws/green_lagrange.h"
#include "core/laws/width.h"

#include "compute.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class ComputePotdemStrainAtom : public Compute {
 public:
  ComputePotdemStrainAtom(class LAMMPS *, int, char **);
  ~ComputePotdemStrainAtom() override;
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  int nmax;
  double **strain;
  std::string fix_id;    // of the reference positions
  class FixPotdemBondHistory *history;

  // of one particle, of the bonds that it had when they were taken
  struct Row {
    int listed = -1, first = 0, bonds = 0, rank = 0;
    bool crosses = false;    // a periodic boundary, in the reference state
    POTDEM::StrainInverse inverse{};
  };
  int generation;    // of the bonds' memory, that the rows are of
  std::vector<Row> rows;
  std::vector<int> partner;
  std::vector<double> inverse_length2;

  void keep_reference();
  void check_reference(double **reference);
  double **reference() const;
  void take_new_bonds(double **reference);
  void take_bonds(int i, double **reference, Row &);
  void fit_all(double **reference);
#ifdef POTDEM_WIDE_CODE
  void fit_all_avx2(double **reference);
#endif
  void fit_each(double **reference);
  template <class Places>
  void add_bonds(int i, const Row &, const double (*x)[3], Places reference, double *sum) const;
  void check_length(int i, int j, double re, double reference) const;
};

}    // namespace LAMMPS_NS

#endif
