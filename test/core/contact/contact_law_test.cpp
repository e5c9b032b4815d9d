#include "tether_monitor/core/contact/contact_law.h"

#include <gtest/gtest.h>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
namespace
{
constexpr double DIAMETER = 0.05;
const TangentWeights STATIC{0.0, 0.0, 1.0};

// 2 cm deep in a floor of 1000 N/m^2, where the spring has been fully stiff from 1 mm on.
ContactPoint onTheFloor()
{
  ContactPoint on;
  on.stiffness = 1000.0;
  on.damping = 10.0;
  on.friction = 0.5;
  on.penetration = 0.02;
  return on;
}
}  // namespace

TEST(ContactLaw, NormalForceIsSpringAndDamperAndNeverPulls)
{
  ContactPoint on = onTheFloor();
  EXPECT_NEAR(contactForce(on, DIAMETER, STATIC).normal_force, 19.5, 1e-12) << "k (p - half a millimetre)";
  on.velocity = {0.0, 0.0, -0.3};
  EXPECT_NEAR(contactForce(on, DIAMETER, STATIC).force.z(), 22.5, 1e-12);
  on.velocity = {0.0, 0.0, 1.9};
  EXPECT_NEAR(contactForce(on, DIAMETER, STATIC).force.z(), 0.5, 1e-12);
  on.velocity = {0.0, 0.0, 2.0};
  EXPECT_EQ(contactForce(on, DIAMETER, STATIC).force, Vector3::Zero()) << "it would have to hold the tether";
  on = onTheFloor();
  on.penetration = 0.0;
  EXPECT_EQ(contactForce(on, DIAMETER, STATIC).normal_force, 0.0);
}

TEST(ContactLaw, TheFrictionSpringSlipsAtCoulombsLimit)
{
  ContactPoint on = onTheFloor();
  on.stretch = {0.005, 0.0, 0.0};
  ContactResponse holds = contactForce(on, DIAMETER, STATIC);
  EXPECT_TRUE(matricesNear(holds.force, Vector3(-5.0, 0.0, 19.5), 1e-12));
  EXPECT_TRUE(matricesNear(holds.stretch, on.stretch, 1e-15));
  on.stretch = {0.0, 0.03, 0.0};
  const ContactResponse slips = contactForce(on, DIAMETER, STATIC);
  EXPECT_TRUE(matricesNear(slips.force, Vector3(0.0, -9.75, 19.5), 1e-12)) << "half the normal force";
  EXPECT_TRUE(matricesNear(slips.stretch, Vector3(0.0, 0.00975, 0.0), 1e-15)) << "the rest has slipped";
  on.friction = 0.0;
  EXPECT_TRUE(matricesNear(contactForce(on, DIAMETER, STATIC).force, Vector3(0.0, 0.0, 19.5), 1e-12));
}

TEST(ContactLaw, SlidingAndStickingAreModesOfTheirOwn)
{
  ContactPoint on = onTheFloor();
  on.damping = 0.0;
  on.friction_mode = FrictionMode::SLIP;
  on.velocity = {3.0, -4.0, 0.0};
  EXPECT_TRUE(matricesNear(contactForce(on, DIAMETER, STATIC).force, Vector3(-5.85, 7.8, 19.5), 1e-12));
  on.velocity = Vector3::Zero();
  EXPECT_TRUE(matricesNear(contactForce(on, DIAMETER, STATIC).force, Vector3(0.0, 0.0, 19.5), 1e-12));
  on.friction_mode = FrictionMode::STICK;
  on.stretch = {0.03, 0.0, 0.0};
  EXPECT_TRUE(matricesNear(contactForce(on, DIAMETER, STATIC).force, Vector3(-30.0, 0.0, 19.5), 1e-12))
      << "beyond the limit";
}

TEST(ContactLaw, EnergyIsTheWorkOfTheNormalSpring)
{
  ContactPoint on = onTheFloor();
  on.friction = 0.0;
  const double h = 1e-7;
  double before = 0.0;
  for (const double penetration : {0.0005, 0.0015, 0.02})  // while it stiffens, and after
  {
    on.penetration = penetration;
    const ContactResponse here = contactForce(on, DIAMETER, STATIC);
    on.penetration = penetration + h;
    const ContactResponse deeper = contactForce(on, DIAMETER, STATIC);
    EXPECT_NEAR((deeper.energy - here.energy) / h, here.normal_force, 1e-3) << penetration;
    EXPECT_NEAR((deeper.normal_force - here.normal_force) / h, here.stiffness(2, 2), 0.1) << penetration;
    EXPECT_GT(here.energy, before);
    before = here.energy;
  }
}
}  // namespace tether_monitor::core
