/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* What the styles of this package ask of each other. A style that offers one of these derives from it as well as from
   LAMMPS's own class, and is found by it (find_styles.h): nobody asks for a style by its name. */

#ifndef LMP_POTDEM_INTERFACES_H
#define LMP_POTDEM_INTERFACES_H

#include "core/laws/softening.h"
#include "core/laws/strength_scatter.h"

#include "lmptype.h"

#include <vector>

namespace LAMMPS_NS {

// never owned
class Interface {
 protected:
  ~Interface() = default;
};

// adds the springs that it has between particles now, for the critical step; what touches within the time `ahead` as it
// will be where it turns back
class StiffnessSource : public Interface {
 public:
  virtual void add_stiffness_to(class PotdemStiffness &, double ahead) = 0;
};

// raises forces by a factor at most, as smaller masses would
class ForceAmplifier : public Interface {
 public:
  virtual double amplification() const = 0;
  virtual bool amplifies(int i) const = 0;    // force on particle i
};

// energy that is not in what pair and bond style tally, over all ranks
struct PotdemEnergies {
  double walls = 0.0;
  double fracture = 0.0;    // lost since the first run
  double springs = 0.0;     // of friction that remembers
};

class EnergySource : public Interface {
 public:
  virtual void add_energy_to(PotdemEnergies &) = 0;
};

// reaches as far as its particles are large
class SizedReach : public Interface {
 public:
  // a particle of this rank is larger, smaller or lighter than find_sizes() saw them
  virtual bool outgrown() const = 0;
  // of the particles that there are, and of those that fixes are to insert
  virtual void find_sizes() = 0;
  // how much further it reaches, at most, over how much larger particles are
  virtual double reach_per_size() const = 0;
};

// of two particles, by their IDs: their distance at which the law of contact begins; 0: where they touch, as any others
struct PotdemNewContact {
  tagint first, second;
  double distance;
};

// contacts that remember
class ContactMemory : public Interface {
 public:
  // at once, on each rank that owns one of the two
  virtual void expect_contacts(const std::vector<PotdemNewContact> &) = 0;
  virtual void lose_contacts() = 0;    // somebody removes the fix that keeps them
};

// bonds that remember, and fail
class BondMemory : public Interface {
 public:
  virtual bool
  has_new_bonds() const = 0;    // on this rank: such as have come since the last rebuild
  virtual void
  expect_new_bonds() = 0;    // on all ranks, before a rebuild: ghosts will reach their ends
  virtual void masses_changed() = 0;
  virtual void lose_memory() = 0;    // somebody removes the fix that keeps it
  virtual bool lost_memory() const = 0;
  // what bonds have learnt in the last steps goes into the memory: before particles change their places in this rank
  virtual void return_state() = 0;
};

// decides what bonds of a type bear
class FailureCriterion : public Interface {
 public:
  virtual void give_strengths_to(class BondStrengths &) const = 0;
};

// bonds that such a criterion takes away
class BreakableBonds : public Interface {
 public:
  struct Listed {
    int i, j, type;    // owned atom, its partner
    int packed;        // its number in the style
    bool tension;
  };
  virtual bool owns(int type) const = 0;
  virtual double youngs_modulus(int type) const = 0;
  virtual const std::vector<Listed> &overstretched() const = 0;            // in the last forces
  virtual double energy_of_bond(int type, double r2, int i, int j) = 0;    // its own
  // of owned atom i, for each end that this rank has: it is to go in the next step; it goes, its ends at this distance, and has no
  // force from here on
  virtual void expect_cut(int i, tagint partner) = 0;
  virtual void cut(int i, tagint partner, double r2) = 0;
  // what those that went have set free beside their own energy since the last call, on this rank
  virtual double freed_energy(int type) = 0;

  // which bonds of a type a crack may reach, and at which stress
  struct CrackQuestion {
    int type, groupbit;
    double strength;
    const POTDEM::StrengthScatter &scatter;
    const std::vector<int> &owner_of_ghost;
    std::vector<int> sharing;    // ranks that have ends of bonds of atoms of this one
  };
  // one that it has reached; between two atoms of this rank once
  struct Reached {
    int i, j;         // owned atom, its partner
    double strain;    // of the bond
    double stress;    // that has reached the strength
    double cosine;    // between the bond and the direction of the largest stress, >= 0
  };
  // of those that are overstretched. Collective among the ranks that share bonds
  virtual std::vector<Reached> reached_by_cracks(const CrackQuestion &) = 0;

  // why those of a type cannot soften: what bond_coeff gives them; null: they can
  virtual const char *cannot_soften(int type) const = 0;
  // from now on, at each end that this rank owns
  virtual void soften(int i, int j, const POTDEM::Softening &) = 0;
  virtual const std::vector<Listed> &spent() const = 0;    // by the end of their softening
  virtual double
  softening_energy(int type) const = 0;               // lost by bonds that are left, on this rank
  virtual int softening_bonds(int type) const = 0;    // how many, on this rank
};

// asks to be told when the fix that warns is removed
class MonitorUser : public Interface {
 public:
  virtual void lose_monitor() = 0;
};

}    // namespace LAMMPS_NS

#endif
