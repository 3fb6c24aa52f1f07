/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_POTDEM_PIECE_ATOM_H
#define LMP_COMPUTE_POTDEM_PIECE_ATOM_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class ComputePotdemPieceAtom : public Compute {
 public:
  ComputePotdemPieceAtom(class LAMMPS *, int, char **);
  ~ComputePotdemPieceAtom() override;
  void init() override;
  double compute_scalar() override;
  void compute_peratom() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  double memory_usage() override;

 private:
  int nmax;
  double *piece;
  // a part is what hangs together by the bonds of this rank's own particles; its root is the
  // member of lowest index
  std::vector<int> root;    // of owned and ghost particles; while bonds unite, a step towards it
  std::vector<tagint> lowest;    // of a root: the lowest ID known here; 0: not in the group
  bool lowered;                  // a part with own particles has heard of a lower ID

  class FixPotdemBondHistory *history() const;
  void start();
  void unite_bonded();
  void unite(int i, int j);
  int root_of(int i);
  bool lowered_anywhere();
};

}    // namespace LAMMPS_NS

#endif
