/* ----------------------------------------------------------------------
   POTDEM: potential-based discrete elements for LAMMPS
   Distributed under the GNU General Public License, version 2
------------------------------------------------------------------------- */

/* The springs of a contact for the critical step, by hand. */

#include "core/contact/contact.h"
#include "core/laws/contact_geometry.h"
#include "core/laws/hertz.h"
#include "core/laws/mindlin.h"
#include "core/laws/rolling.h"
#include "core/laws/tangential_spring.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace POTDEM;

namespace {

constexpr double mi = 3.0, mj = 0.5, ri = 0.4, rj = 0.2, dbar = ri + rj, step = 1e-4;
const double n[3] = {0.6, 0.0, 0.8};
const double spin_share = sliding_mass(1.0, SPHERE_INERTIA);

ContactMasses masses()
{
  return with_rolling({spin_share * mi * mj, mi + mj, step, step, spin_share}, mi, mj, ri, rj);
}

template <class Tangential> Spring spring(const Tangential &rough, double overlap = 0.01)
{
  Hertz law{1e6, 0.3};
  law.complete();
  const auto kernel = law.kernel(false);
  return contact_spring(kernel, dbar - overlap, ContactGeometry{ri, rj, dbar}, 1.0, Elastic(),
                        rough, masses(), n);
}

// E* = E/(2 (1 - nu^2)), R = ri rj/(ri + rj): F = 4/3 E* sqrt(R) w^(3/2)
const double modulus = 1e6 / (2.0 * 0.91), R = ri * rj / dbar, w = 0.01;
const double stiffness = 2.0 * modulus * std::sqrt(R * w), force = 2.0 / 3.0 * stiffness * w;

TEST(ContactSpring, WithoutFrictionIsThatOfTheLaw)
{
  const auto found = spring(Frictionless());
  EXPECT_NEAR(found.along, stiffness, 1e-12 * stiffness);
  EXPECT_NEAR(found.across, -force / (dbar - w), 1e-12 * force);
  EXPECT_EQ(found.viscosity, 0.0);
  EXPECT_EQ(found.friction, 0.0);
}

// a force across the surface moves it by 1/m for the centre and R^2/I = 1/(0.4 m) for the spin: as 2/7 of the mass
TEST(ContactSpring, FrictionMovesTwoSeventhsOfTheMass)
{
  const auto found = spring(TangentialSpring{{}, 0.3, 0.8, 0.0});
  EXPECT_NEAR(found.across, 0.8 * stiffness * 3.5, 1e-12 * stiffness);
  EXPECT_NEAR(found.along, stiffness, 1e-12 * stiffness);
  EXPECT_EQ(found.viscosity, 0.0);
}

// a spring of rolling K between the two turns each by R^2 K/I = (R/r)^2 K/(0.4 m): the lighter turn is by the larger lever
TEST(ContactSpring, RollingTurnsTheSmallerOneMost)
{
  const double rolling = 0.5, twisting = 5.0, lever = (R / rj) * (R / rj) / 0.4;
  const auto found =
      spring(Rolls<TangentialSpring>{{{}, 0.0, 0.8, 0.0}, {0.1, rolling, 0.0, 0.1, twisting, 0.0}});
  EXPECT_NEAR(found.across, lever * rolling * stiffness, 1e-12 * stiffness);
  EXPECT_NEAR(found.along, lever * twisting * stiffness, 1e-12 * stiffness);
  EXPECT_EQ(found.viscosity, 0.0);
  EXPECT_EQ(found.friction, 0.0);
}

TEST(ContactSpring, RollingHasTheInertiaOfBothSpheres)
{
  const double Ii = 0.4 * mi * ri * ri, Ij = 0.4 * mj * rj * rj;
  const double both = 1.0 / (R * R / Ii + R * R / Ij);
  EXPECT_NEAR(masses().rolling, both, 1e-13 * both);
}

TEST(ContactSpring, IsNothingOutOfTouch)
{
  const auto found = spring(TangentialSpring{{}, 0.3, 0.8, 0.5}, -0.01);
  EXPECT_EQ(found.along, 0.0);
  EXPECT_EQ(found.across, 0.0);
  EXPECT_EQ(found.viscosity, 0.0);
  EXPECT_EQ(found.friction, 0.0);
}

TEST(ContactSpring, MixedFrictionHasTheLesserMuAndTheMeanDamping)
{
  const auto found = Mindlin::mixed({{}, 0.3, 0.2}, {{}, 0.5, 0.6});
  EXPECT_EQ(found.mu, 0.3);
  EXPECT_DOUBLE_EQ(found.xi, 0.4);
}

}    // namespace
