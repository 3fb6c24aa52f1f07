/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* Most particles of a lattice have the same surroundings, and those of the same surroundings have the same answer: one of
   each kind is solved. Surroundings are the same if diameters, volumes and bonds are, of the particle and of all others as far
   as so many bonds reach. Particles that other ranks have copies of stand for themselves only, so that the ranks agree on
   the bonds between them.

   In the reduced body a bond may end on a particle that is not solved: that end is a copy, which takes its values from its
   kind. It needs no list of bonds, as if another rank had it. */

#ifndef POTDEM_AREAS_KINDS_H
#define POTDEM_AREAS_KINDS_H

#include "bonded_body.h"

#include <memory>

namespace POTDEM {

// what particles see, as numbers: the same for the same surroundings, whatever the rounding, the order of bonds and the rank
class Surroundings {
 public:
  std::vector<std::uint64_t> prints;    // of the bonds, from each end
  std::vector<std::uint64_t> seen;      // by each particle

  // lists neighbours already; lives on. Collective
  explicit Surroundings(const BondedBody &);
  void look(int bonds);    // as far as so many bonds reach, at least as far as before. Collective

 private:
  const BondedBody &body;
  int looked;
  struct {
    double length, diameter, volume;
  } unit;    // the same on all ranks

  void find_units();
  std::uint64_t fingerprint(const BondedBody::Neighbour &) const;
};

class Kinds : private BodyHalo {
 public:
  BondedBody body;    // owns one particle of each kind

  // of the body as it is seen now; body and bonds' fingerprints live on. Collective
  Kinds(const BondedBody &, const Surroundings &);
  // to the same body. Collective
  void give_volumes(BondedBody &) const;
  void give_areas(BondedBody &) const;

  // what the particles of other kinds of the same body have, those that see less far, is given to these, copies included.
  // Collective
  template <class T> std::vector<T> take(const Kinds &others, const std::vector<T> &values) const
  {
    std::vector<T> mine(body.nall);
    for (int k = 0; k < body.nowned; k++) mine[k] = values[others.kind[first[k]]];
    body.forward(mine);
    return mine;
  }

 private:
  const BondedBody &whole;
  const std::vector<std::uint64_t> &prints;
  std::vector<int> kind;                // of each owned particle of the whole
  std::vector<int> first;               // of each kind; then whom the copies are of
  std::vector<int> reduced;             // bond of the reduced body, of each bond; -1: none
  std::vector<int> shared;              // kinds that other ranks may have copies of
  std::unique_ptr<double[]> scratch;    // of all particles of the whole; few of them are touched

  void forward(double *, int width) override;
  void sum(double *values, int n) override { whole.halo.sum(values, n); }

  void list_kinds(const std::vector<std::uint64_t> &seen);
  void reduce();
  int solved_bond(int i, const BondedBody::Neighbour &) const;
};

}    // namespace POTDEM

#endif
