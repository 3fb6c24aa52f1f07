/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_POTDEM_ENERGY_H
#define LMP_COMPUTE_POTDEM_ENERGY_H

#include "compute.h"

namespace LAMMPS_NS {

class ComputePotdemEnergy : public Compute {
 public:
  ComputePotdemEnergy(class LAMMPS *, int, char **);
  ~ComputePotdemEnergy() override;
  void init() override;
  double compute_scalar() override;
  void compute_vector() override;

 private:
  enum {
    KINETIC,
    GRAVITY,
    BONDS,
    CONTACTS,
    WALLS,
    FRACTURE,
    FRICTION,
    VISCOUS,
    DAMPING,
    WALL_WORK,
    SPRINGS,
    NTERMS
  };

  double inertia;    // of a particle, over m r^2
  class FixPotdemLedger *ledger() const;
  double kinetic() const;
  double of_gravity() const;
};

}    // namespace LAMMPS_NS

#endif
