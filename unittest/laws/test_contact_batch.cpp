/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

#include "core/contact/contact_batch.h"
#include "core/laws/law_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace POTDEM;

namespace {

constexpr int LANES = 16;

// numbers of one lane
template <class Batch> void fill(Batch &batch, int l, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  batch.pair[l] = 0;
  batch.r2[l] = 0.0;
  for (int k = 0; k < 3; k++) {
    batch.del[k][l] = some(random);
    batch.r2[l] += batch.del[k][l] * batch.del[k][l];
    batch.v[k][l] = 0.1 * some(random);
    batch.wi[k][l] = some(random);
    batch.wj[k][l] = some(random);
  }
  const double r = std::sqrt(batch.r2[l]);
  batch.ri[l] = 0.6 * r;
  batch.rj[l] = r * (0.4 + 1e-2 * (0.6 + some(random)));    // some do not touch
  batch.contact[l] = batch.ri[l] + batch.rj[l];
  batch.mi[l] = 1.0 + 0.5 * some(random);
  batch.mj[l] = 1.0 + 0.5 * some(random);
  batch.weight[l] = 1.0;
  for (int k = 0; k < Batch::STATE; k++) batch.state[k][l] = 1e-3 * some(random);
}

template <class Law, class Rate, class Tangential>
void compare(const Law &law, const Rate &rate, const Tangential &rough, Width width)
{
  const auto kernel = law.kernel(false);
  using Kernel = typename Law::Kernel;
  const PairLaws<Kernel, Rate, Tangential> laws{&kernel, &rate, &rough};
  ContactBatch<Kernel, Rate, Tangential, true, LANES> many;
  for (int l = 0; l < LANES; l++) fill(many, l, 100 + l);
  many.find_all(width, laws, true, 1e-4, 1e-4);
  for (int l = 0; l < LANES; l++) {
    ContactBatch<Kernel, Rate, Tangential, true, 1> one;
    fill(one, 0, 100 + l);
    one.find_all(Width::PLAIN, laws, true, 1e-4, 1e-4);
    EXPECT_EQ(many.energy[l], one.energy[0]);
    EXPECT_EQ(many.pressing[l], one.pressing[0]);
    EXPECT_EQ(many.viscous[l], one.viscous[0]);
    for (int k = 0; k < 3; k++) {
      EXPECT_EQ(many.push[k][l], one.push[k][0]);
      EXPECT_EQ(many.turn[k][l], one.turn[k][0]);
      if (is_rolling<Tangential>) {
        EXPECT_EQ(many.rolling[k][l], one.rolling[k][0]);
      }
    }
    for (int k = 0; k < Tangential::STATE; k++) EXPECT_EQ(many.state[k][l], one.state[k][0]);
  }
}

template <class Law> void compare_all(const Law &law)
{
  Restitution restitution{0.5};
  restitution.complete();
  const RollingResistance resistance{0.1, 0.5, 0.1, 0.1, 0.5, 0.1};
  const Mindlin damped{{}, 0.3, 0.2}, undamped{{}, 0.3, 0.0};
  for (const Width width : {Width::PLAIN, Width::AVX2, Width::AVX512}) {
    if (width > widest()) break;
    compare(law, Elastic(), Sliding{0.3, 2.0, 0.0}, width);
    compare(law, Viscous{1e-3, 0.0}, TangentialSpring{{}, 0.3, 0.8, 0.0}, width);
    compare(law, Viscous{1e-3, 0.0}, TangentialSpring{{}, 0.3, 0.8, 0.2}, width);
    compare(law, restitution, undamped, width);
    compare(law, restitution, damped, width);
    compare(law, restitution, Rolls<Mindlin>{undamped, resistance}, width);
    compare(law, restitution, Rolls<Mindlin>{damped, resistance}, width);
  }
}

TEST(ContactBatch, EveryLaneHasTheBitsOfOneContact)
{
  Hertz hertz{1e6, 0.3, 0.0, 0.0};
  hertz.complete();
  compare_all(hertz);
  Dmt dmt{1e6, 0.3, 5.0, 0.0, 0.0};
  dmt.complete();
  compare_all(dmt);
}

// two pairs of types in a batch
TEST(ContactBatch, LanesMayHaveDifferentLaws)
{
  Hertz soft{1e6, 0.3, 0.0, 0.0}, hard{1e7, 0.2, 0.0, 0.0};
  soft.complete();
  hard.complete();
  const Hertz::Kernel kernels[] = {soft.kernel(false), hard.kernel(false)};
  const Mindlin rough[] = {{{}, 0.3, 0.0}, {{}, 0.6, 0.1}};
  const PairLaws<Hertz::Kernel, Elastic, Mindlin> laws{kernels, nullptr, rough};
  ContactBatch<Hertz::Kernel, Elastic, Mindlin, true, LANES> many;
  for (int l = 0; l < LANES; l++) {
    fill(many, l, l);
    many.pair[l] = l % 2;
  }
  many.find_all(widest(), laws, true, 1e-4, 1e-4);
  for (int l = 0; l < LANES; l++) {
    ContactBatch<Hertz::Kernel, Elastic, Mindlin, true, 1> one;
    fill(one, 0, l);
    one.pair[0] = l % 2;
    one.find_all(Width::PLAIN, laws, true, 1e-4, 1e-4);
    for (int k = 0; k < 3; k++) EXPECT_EQ(many.push[k][l], one.push[k][0]);
  }
}

}    // namespace
