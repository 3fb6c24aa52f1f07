/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The body whose bonds want areas: particles, bonds, and who neighbours whom. Plain data; the classes beside it
   (cells, surfaces, volumes, admissible states, targets, least squares) read it.

   Lengths in any one unit; areas come out in its square, volumes in its cube, moduli do not enter. A rank owns the first
   `nowned` particles, the others are copies; each rank holds all bonds of its own particles. */

#ifndef POTDEM_BONDED_BODY_H
#define POTDEM_BONDED_BODY_H

#include "elasticity.h"
#include "mandel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace POTDEM {

// exchange of per-particle values between ranks; by itself: one rank, no copies
struct BodyHalo {
  static constexpr int WIDEST = 54;    // values per particle at a time
  virtual ~BodyHalo() = default;
  virtual void forward(double *, int) {}    // copies take the owner's values; width per particle
  virtual void sum(double *, int) {}        // over ranks
};

struct BondedBody {
  struct Bond {
    int low, high;     // ends (0 to nall - 1, one of them owned), the one with the lower ID first
    Vector3 n;         // unit vector from low to high
    double length;     // at rest, > 0
    double counted;    // so often in sums over all bonds; the ranks' shares add up
    double area;       // the answer
    // weight in the dilatation of the low and of the high end; of the answer, too, where there is a volume term
    double dilatation[2] = {0.0, 0.0};
  };
  // a bond seen from one of its ends
  struct Neighbour {
    int bond, particle;
    double sign;    // of n, outwards
  };
  struct Neighbours {
    const Neighbour *from, *to;
    const Neighbour *begin() const { return from; }
    const Neighbour *end() const { return to; }
    int size() const { return static_cast<int>(to - from); }
    const Neighbour &operator[](int k) const { return from[k]; }
  };

  BodyHalo &halo;
  Elasticity elasticity;    // of the solid
  int nowned = 0, nall = 0;
  std::vector<double> diameter;    // of nall particles, > 0; only their ratios matter
  std::vector<double>
      volume;    // of nall particles, their sum counts; empty: from the inner particles' cells
  std::vector<std::int64_t> id;    // of nall particles
  std::vector<Bond> bonds;
  std::vector<double> alike;    // how many each owned particle stands for; empty: one

  explicit BondedBody(BodyHalo &exchange) : halo(exchange) {}

  void list_neighbours();    // once the bonds are there
  // of an owned particle, the nearest first
  Neighbours neighbours(int i) const
  {
    return {list.data() + first[i], list.data() + first[i + 1]};
  }
  std::size_t place(const Neighbour &to) const { return &to - list.data(); }    // among all
  bool bonded(int i) const { return first[i] < first[i + 1]; }

  // values of nall particles, doubles or arrays of them: copies take the owner's
  template <class T> void forward(std::vector<T> &values) const
  {
    halo.forward(reinterpret_cast<double *>(values.data()), width<T>());
  }

  Vector3 separation(const Neighbour &to) const
  {
    const Bond &bond = bonds[to.bond];
    const double r = to.sign * bond.length;
    return {r * bond.n[0], r * bond.n[1], r * bond.n[2]};
  }

 private:
  template <class T> static constexpr int width()
  {
    static_assert(sizeof(T) % sizeof(double) == 0, "doubles only");
    static_assert(sizeof(T) <= BodyHalo::WIDEST * sizeof(double), "the halo carries it");
    return sizeof(T) / sizeof(double);    // NOLINT(bugprone-sizeof-expression): T may be double
  }

  std::vector<int> first;
  std::vector<Neighbour> list;
};

}    // namespace POTDEM

#endif
