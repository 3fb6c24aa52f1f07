/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_POTDEM_STRAIN_ATOM_H
#define LMP_COMPUTE_POTDEM_STRAIN_ATOM_H

#include "compute.h"

#include <string>

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

  void keep_reference();
  void check_reference(double **reference);
  double **reference() const;
  void fit(int i, double **reference, double *out);
  void check_length(int i, int j, double re, double reference) const;
};

}    // namespace LAMMPS_NS

#endif
