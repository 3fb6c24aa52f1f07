/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_POTDEM_TIMESTEP_H
#define LMP_COMPUTE_POTDEM_TIMESTEP_H

#include "lammps/output/potdem_stiffness.h"

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class ComputePotdemTimestep : public Compute {
 public:
  ComputePotdemTimestep(class LAMMPS *, int, char **);
  ~ComputePotdemTimestep() override;
  void init() override;
  double compute_scalar() override;
  void compute_vector() override;
  int pack_reverse_comm(int, int, double *) override;
  void unpack_reverse_comm(int, int *, double *) override;
  double memory_usage() override;

  void find_styles();    // all whose stiffness counts
  tagint particle() const { return static_cast<tagint>(vector[PARTICLE]); }

 private:
  enum { ELASTIC, STIFFEST, PARTICLE, NVALUES };

  double ahead;    // time
  std::vector<class StiffnessSource *> sources;
  std::vector<class ForceAmplifier *> amplifiers;
  PotdemStiffness stiffness;
  double step;

  void warn_of_others() const;
  void warn_of(const std::string &style) const;
  void gather();
  std::vector<double> inverse_root_masses() const;
};

}    // namespace LAMMPS_NS

#endif
