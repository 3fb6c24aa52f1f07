/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The energy of the change of volume, of the bond types with a Poisson's ratio of their own (`nu x`):

     W = 1/2 kappa sum over particles root^2,    root = sqrt(V) theta = sum over the particle's bonds of w eps

   eps = (q - 1)/2 with q = (r/re)^2 is the strain of a bond, w = sqrt(V) c its weight at this end (core/areas/dilatation.h). So a bond
   has the tension  kappa (w root at one end + w root at the other) r/re^2  beside its own; in W its share is half of its strain times
   kappa (...), and the shares add up to W. theta of ghosts comes from their owners, once for each type and evaluation.

   Energies, forces and lengths in LAMMPS's units; root in sqrt(volume). */

#ifndef LMP_POTDEM_VOLUME_TERM_H
#define LMP_POTDEM_VOLUME_TERM_H

#include "core/laws/width.h"
#include "lammps/bond/potdem_bond_network.h"
#include "lammps/glue/fix_potdem_bond_history.h"

#include <map>
#include <vector>

namespace LAMMPS_NS {

class PotdemVolumeTerm : protected Pointers {
 public:
  PotdemVolumeTerm(LAMMPS *, const PotdemBondNetwork &);

  // moduli: kappa of each bond type, 0: it has no such energy
  void begin(const std::vector<double> &moduli);
  bool exists() const { return !terms.empty(); }
  bool exists(int type) const { return exists() && term_of[type] >= 0; }
  void make_room();    // for the packed bonds
  void take(int n, const FixPotdemBondHistory::Dilatation &part)
  {
    own[n] = part.own;
    other[n] = part.other;
  }
  // of the particles as they are. Collective
  void find_dilatations(FixPotdemBondHistory &);
  // for the loop over bonds: of each bond type kappa times the roots of all particles, null where it has no such energy; of each
  // packed bond w at its owned atom and at its partner. No types: there is no such energy
  const double *const *roots() const { return exists() ? root_of_type.data() : nullptr; }
  const double *weights_here() const { return own.data(); }
  const double *weights_there() const { return other.data(); }

  // A bond is no longer part of the dilatation of owned atom i: its w eps when that was found out, and in the next step, in which it goes.
  // The forces between the two are those with it for one half step and those without it for the other; so the mean of what it
  // sets free in both is what the motion loses. freed_energy: since the last call
  void expect_cut(int i, int type, double part) { leaving_at(i, type).then += part; }
  void cut(int i, int type, double part) { leaving_at(i, type).now += part; }
  double freed_energy(int type);

  // kappa times weights and roots of both ends, of these weights, of a type that has the energy
  double tension(int type, int i, int j, const FixPotdemBondHistory::Dilatation &) const;
  // not below what it adds. Collective
  void add_stiffness_to(class PotdemStiffness &, FixPotdemBondHistory &) const;

  double memory_usage() const;

 private:
  struct Term {
    double kappa = 0.0;
    std::vector<double> root;    // kappa times it, of owned and ghost particles
    double freed = 0.0;
  };
  // parts of bonds that leave the root of a particle
  struct Leaving {
    int term;
    double root_then, then, now;    // kappa times the root, before any has left
  };
  const PotdemBondNetwork &bonds;
  std::vector<Term> terms;
  std::vector<int> term_of;    // of a bond type; -1: none
  std::vector<double *> root_of_type;
  std::vector<double> own, other;

  std::multimap<tagint, Leaving> leaving;

  Leaving &leaving_at(int i, int type);
  void free_energy();
  void add_stiffness_to(PotdemStiffness &, FixPotdemBondHistory &, int term) const;
  void add_strains();
#ifdef POTDEM_WIDE_CODE
  void add_strains_avx2();
#endif
  void add_each_strain();
  void add_strain(int i, int n);
  int add_four_strains(int i, int n, int end);
};

}    // namespace LAMMPS_NS

#endif
