/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "kinds.h"

#include "constants.h"

#include <unordered_map>

using namespace POTDEM;

namespace {

constexpr int NONE = -1;

// down to a whole number; simple fractions are far from where this jumps. The middle makes all numbers positive, for which a cast does it
std::uint64_t rounded(double value)
{
  constexpr double MIDDLE = 1ul << 45;
  return static_cast<std::int64_t>(value / areas::ALIKE + 0.37 + MIDDLE);
}

// every bit of the answer depends on every bit of the argument
std::uint64_t mixed(std::uint64_t bits)
{
  for (int round = 0; round < 2; round++) {
    bits ^= bits >> 32;
    bits *= 0x9e3779b97f4a7c15u;    // 2^64 over the golden ratio, odd
  }
  return bits ^ bits >> 32;
}

}    // namespace

Surroundings::Surroundings(const BondedBody &bonded) : seen(bonded.nall), body(bonded), looked(0)
{
  find_units();
  prints.reserve(2 * body.bonds.size());
  for (int i = 0; i < body.nowned; i++) {
    seen[i] = mixed(rounded(body.diameter[i] / unit.diameter));
    if (!body.volume.empty()) seen[i] = mixed(seen[i] + rounded(body.volume[i] / unit.volume));
    for (const auto &to : body.neighbours(i)) prints.push_back(fingerprint(to));
  }
}

// means over all ranks
void Surroundings::find_units()
{
  double total[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < body.nowned; i++) {
    for (const auto &to : body.neighbours(i)) total[0] += body.bonds[to.bond].length;
    total[1] += body.neighbours(i).size();
    total[2] += body.diameter[i];
    if (!body.volume.empty()) total[3] += body.volume[i];
    total[4] += 1.0;
  }
  body.halo.sum(total, 5);
  unit = {total[0] / total[1], total[2] / total[4], total[3] / total[4]};
}

std::uint64_t Surroundings::fingerprint(const BondedBody::Neighbour &to) const
{
  std::uint64_t print = 0;
  for (const double component : body.separation(to))
    print = mixed(print + rounded(component / unit.length));
  return print;
}

// the sums over the neighbours do not depend on their order
void Surroundings::look(int bonds)
{
  for (; looked < bonds; looked++) {
    body.forward(seen);
    const auto last = seen;
    auto print = prints.begin();
    for (int i = 0; i < body.nowned; i++) {
      for (const auto &to : body.neighbours(i)) seen[i] += mixed(*print++ + last[to.particle]);
      seen[i] = mixed(seen[i]);
    }
  }
}

/* ---------------------------------------------------------------------- */

Kinds::Kinds(const BondedBody &bonded, const Surroundings &surroundings) :
    body(static_cast<BodyHalo &>(*this)), whole(bonded), prints(surroundings.prints),
    kind(bonded.nowned), reduced(bonded.bonds.size(), NONE),
    scratch(new double[static_cast<std::size_t>(bonded.nall) * BodyHalo::WIDEST])
{
  body.elasticity = whole.elasticity;
  list_kinds(surroundings.seen);
  reduce();
}

/* ---------------------------------------------------------------------- */

void Kinds::list_kinds(const std::vector<std::uint64_t> &seen)
{
  std::unordered_map<std::uint64_t, int> known;
  for (int i = 0; i < whole.nowned; i++) {
    const auto neighbours = whole.neighbours(i);
    const bool alone = std::any_of(neighbours.begin(), neighbours.end(), [this](const auto &to) {
      return to.particle >= whole.nowned;
    });
    const int next = first.size();
    if (alone) shared.push_back(next);
    kind[i] = alone ? next : known.emplace(seen[i], next).first->second;
    if (kind[i] == next) {
      first.push_back(i);
      body.alike.push_back(0.0);
    }
    body.alike[kind[i]] += 1.0;
  }
  body.nowned = first.size();
}

// the bonds of those that are solved
void Kinds::reduce()
{
  std::vector<int> copy(body.nowned + whole.nall - whole.nowned, NONE);
  const auto place = [&](int i) {
    if (i < whole.nowned && first[kind[i]] == i) return kind[i];
    int &at = copy[i < whole.nowned ? kind[i] : body.nowned + i - whole.nowned];
    if (at == NONE) {
      at = first.size();
      first.push_back(i);
    }
    return at;
  };
  const auto share = [this](int i) {
    return i < body.nowned ? 0.5 * body.alike[i] : 0.0;
  };
  const auto solved = [this](int i) {
    return i < whole.nowned && first[kind[i]] == i;
  };
  for (std::size_t b = 0; b < whole.bonds.size(); b++) {
    auto bond = whole.bonds[b];
    if (!solved(bond.low) && !solved(bond.high)) continue;
    bond.low = place(bond.low);
    bond.high = place(bond.high);
    bond.counted = share(bond.low) + share(bond.high);
    reduced[b] = body.bonds.size();
    body.bonds.push_back(bond);
  }
  body.nall = first.size();
  for (const int i : first) {
    body.diameter.push_back(whole.diameter[i]);
    if (!whole.volume.empty()) body.volume.push_back(whole.volume[i]);
    body.id.push_back(whole.id[i]);
  }
  body.list_neighbours();
}

// what copies have of other ranks goes through the whole body
void Kinds::forward(double *values, int width)
{
  const auto row = [width](auto *all, int i) {
    return all + static_cast<std::size_t>(i) * width;
  };
  for (const int k : shared) std::copy_n(row(values, k), width, row(scratch.get(), first[k]));
  whole.halo.forward(scratch.get(), width);
  for (int k = body.nowned; k < body.nall; k++) {
    const int i = first[k];
    const double *from = i < whole.nowned ? row(values, kind[i]) : row(scratch.get(), i);
    std::copy_n(from, width, row(values, k));
  }
}

/* ---------------------------------------------------------------------- */

void Kinds::give_volumes(BondedBody &answered) const
{
  answered.volume.resize(whole.nall);
  for (int i = 0; i < whole.nowned; i++) answered.volume[i] = body.volume[kind[i]];
  answered.forward(answered.volume);
}

// a bond has the mean of the areas that its two ends find, and of each end the weight that it finds
void Kinds::give_areas(BondedBody &answered) const
{
  for (auto &bond : answered.bonds) bond.area = bond.dilatation[0] = bond.dilatation[1] = 0.0;
  for (int i = 0; i < whole.nowned; i++)
    for (const auto &to : whole.neighbours(i)) {
      const double share = to.particle < whole.nowned ? 0.5 : 1.0;
      auto &bond = answered.bonds[to.bond];
      const auto &solved = body.bonds[solved_bond(i, to)];
      // the solved one may be the other way round
      const int end = to.sign > 0.0 ? 0 : 1, like = solved.low == kind[i] ? 0 : 1;
      bond.area += share * solved.area;
      bond.dilatation[end] = solved.dilatation[like];
      if (to.particle >= whole.nowned) bond.dilatation[1 - end] = solved.dilatation[1 - like];
    }
}

// like this one of particle i
int Kinds::solved_bond(int i, const BondedBody::Neighbour &to) const
{
  const int chosen = first[kind[i]];
  if (chosen == i) return reduced[to.bond];
  const auto print = prints[whole.place(to)];
  for (const auto &like : whole.neighbours(chosen))
    if (prints[whole.place(like)] == print) return reduced[like.bond];
  return NONE;
}
