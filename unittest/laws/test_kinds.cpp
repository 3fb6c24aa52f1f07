/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "blocks.h"
#include "core/areas/body_area.h"
#include "core/areas/kinds.h"

#include <gtest/gtest.h>

using namespace POTDEM;

namespace {

// a bar of 5 x 5 particles whose bonds reach two layers
const Block BAR = {5, 5, 100, false, 1.0, 2.0};
constexpr int FACE = 25, LAYERS = 100;

struct Seen {
  Surroundings surroundings;
  const Kinds kinds;

  Seen(const BondedBody &body, int bonds) : surroundings(body), kinds(body, look(bonds)) {}
  const BondedBody &solved() const { return kinds.body; }

 private:
  const Surroundings &look(int bonds)
  {
    surroundings.look(bonds);
    return surroundings;
  }
};

TEST(Kinds, CountSurroundingsAsFarAsBondsReach)
{
  BodyHalo alone;
  BondedBody bar(alone), crystal(alone);
  fill(bar, BAR);
  fill(crystal, {6, 6, 6, true, 1.0, 2.0});
  for (auto *body : {&bar, &crystal}) body->list_neighbours();
  for (const int bonds : {1, 2, 7}) {
    // the ends are seen from 2 layers for each bond, and all others have the same neighbours along the bar
    const Seen kinds(bar, bonds);
    EXPECT_EQ(kinds.solved().nowned, FACE * (2 * 2 * bonds + 1));
    double all = 0.0, share = 0.0;
    for (const double count : kinds.solved().alike) all += count;
    for (const auto &bond : kinds.solved().bonds) share += bond.counted;
    EXPECT_EQ(all, bar.nowned);
    EXPECT_EQ(share, bar.bonds.size());
    EXPECT_EQ(Seen(crystal, bonds).solved().nowned, 1);
  }
}

TEST(Kinds, TellDiametersAndVolumesApart)
{
  BodyHalo alone;
  BondedBody crystal(alone);
  fill(crystal, {6, 6, 6, true, 1.0, 2.0});
  crystal.list_neighbours();
  for (int i = 0; i < crystal.nall; i += 2) crystal.diameter[i] *= 1.0 + 1e-6;
  EXPECT_EQ(Seen(crystal, 3).solved().nowned, 2);
  crystal.volume.assign(crystal.nall, 1.0);
  crystal.volume[0] = 1.001;
  EXPECT_GT(Seen(crystal, 3).solved().nowned, 2);
}

// as if the second half of the bar belonged to another rank: both have the bonds between them
TEST(Kinds, WhatOtherRanksCopyStandsForItself)
{
  BodyHalo alone;
  BondedBody bar(alone);
  fill(bar, BAR);
  bar.nowned = bar.nall / 2;
  std::vector<BondedBody::Bond> known;
  for (const auto &bond : bar.bonds)
    if (bond.low < bar.nowned) known.push_back(bond);
  bar.bonds = known;
  bar.list_neighbours();
  const Seen kinds(bar, 1);
  int between = 0;
  for (const auto &bond : kinds.solved().bonds) between += bond.high >= kinds.solved().nowned;
  // two layers at the end, one kind of layer, two beside the other rank; its two and the copies of the middle
  EXPECT_EQ(kinds.solved().nowned, 5 * FACE);
  EXPECT_GT(between, 0);
  for (int k = 3 * FACE; k < 5 * FACE; k++) EXPECT_EQ(kinds.solved().alike[k], 1.0);
}

// particles whose diameters differ a little are not alike: each is solved
TEST(Kinds, HaveTheAreasThatAllParticlesWouldHave)
{
  BodyHalo alone;
  BondedBody kinds(alone), each(alone);
  for (auto *body : {&kinds, &each}) fill(*body, BAR);
  for (int i = 0; i < each.nall; i++) each.diameter[i] += 1e-8 * std::sin(1.0 + i * i);
  each.list_neighbours();
  ASSERT_EQ(Seen(each, 1).solved().nowned, FACE * LAYERS);
  ASSERT_EQ(find_body_areas(kinds).outcome, BodyAreaReport::DONE);
  ASSERT_EQ(find_body_areas(each).outcome, BodyAreaReport::DONE);
  for (std::size_t k = 0; k < kinds.bonds.size(); k++)
    EXPECT_NEAR(kinds.bonds[k].area / each.bonds[k].area, 1.0, 1e-6);
}

}    // namespace
