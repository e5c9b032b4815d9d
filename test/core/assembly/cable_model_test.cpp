#include <gtest/gtest.h>

#include <functional>

#include "support/tethers.h"

namespace tether_monitor::core
{
// One row for each documented bound: what violates it, and the name that the message must contain.
struct Violation
{
  const char* name;
  std::function<void(CableProperties&, Environment&, int&)> make;
};

class ModelRefuses : public ::testing::TestWithParam<Violation>
{
};

TEST_P(ModelRefuses, AndNamesTheArgument)
{
  CableProperties p = towCable();
  Environment sea;
  int elements = 10;
  ASSERT_NO_THROW(CableModel(p, elements, sea)) << "precondition";
  GetParam().make(p, sea, elements);
  try
  {
    CableModel(p, elements, sea);
    FAIL() << "accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(GetParam().name), std::string::npos) << error.what();
  }
}

using P = CableProperties;
using E = Environment;
INSTANTIATE_TEST_SUITE_P(
    Bounds, ModelRefuses,
    ::testing::Values(Violation{"tether.length", [](P& p, E&, int&) { p.length = 0.0; }},
                      Violation{"tether.length", [](P& p, E&, int&) { p.length = NAN; }},
                      Violation{"tether.diameter", [](P& p, E&, int&) { p.diameter = -0.01; }},
                      Violation{"tether.mass_per_length", [](P& p, E&, int&) { p.mass_per_length = 0.0; }},
                      Violation{"tether.axial_stiffness", [](P& p, E&, int&) { p.axial_stiffness = INFINITY; }},
                      Violation{"tether.bending_stiffness", [](P& p, E&, int&) { p.bending_stiffness = -1.0; }},
                      Violation{"tether.axial_damping", [](P& p, E&, int&) { p.axial_damping = -1.0; }},
                      Violation{"tether.drag_normal", [](P& p, E&, int&) { p.drag_normal = -1.0; }},
                      Violation{"tether.drag_tangential", [](P& p, E&, int&) { p.drag_tangential = NAN; }},
                      Violation{"tether.added_mass_normal", [](P& p, E&, int&) { p.added_mass_normal = -0.1; }},
                      Violation{"tether.working_load", [](P& p, E&, int&) { p.working_load = 7.0e4; }},
                      Violation{"tether.breaking_load", [](P& p, E&, int&) { p.breaking_load = 0.0; }},
                      Violation{"tether.load_area", [](P& p, E&, int&) { p.load_area = 0.0; }},
                      Violation{"tether.min_bend_radius", [](P& p, E&, int&) { p.min_bend_radius = -1.0; }},
                      Violation{"tether.elements", [](P&, E&, int& n) { n = 0; }},
                      Violation{"environment.water_density", [](P&, E& e, int&) { e.water_density = -1.0; }},
                      Violation{"environment.gravity", [](P&, E& e, int&) { e.gravity = NAN; }}));

TEST(StepperRefuses, BadOptions)
{
  const CableModel model(towCable(), 2, Environment());
  EXPECT_THROW(AdaptiveStepper(model, {0.0, 0.6, 10, 400, {}}), std::invalid_argument);
  EXPECT_THROW(AdaptiveStepper(model, {0.05, 1.1, 10, 400, {}}), std::invalid_argument);
  EXPECT_THROW(AdaptiveStepper(model, {0.05, 0.6, -1, 400, {}}), std::invalid_argument);
  EXPECT_THROW(AdaptiveStepper(model, {0.05, 0.6, 10, 0, {}}), std::invalid_argument);
}

TEST(CurrentProfile, IsLinearBetweenAndConstantBeyond)
{
  const CurrentProfile profile({{10.0, {1.0, 0.0, 0.0}}, {20.0, {0.0, 2.0, 0.0}}});
  EXPECT_EQ(profile.at(5.0), Vector3(1.0, 0.0, 0.0)) << "above the surface";
  EXPECT_EQ(profile.at(-10.0), Vector3(1.0, 0.0, 0.0));
  EXPECT_LT((profile.at(-15.0) - Vector3(0.5, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(profile.at(-100.0), Vector3(0.0, 2.0, 0.0));
  EXPECT_EQ(CurrentProfile().at(-3.0), Vector3::Zero());
}

using Samples = std::vector<CurrentProfile::Sample>;

TEST(CurrentProfile, RefusesDepthsOutOfOrderAndNumbersThatAreNone)
{
  EXPECT_THROW(CurrentProfile({{10.0, Vector3::Zero()}, {10.0, Vector3::Zero()}}), std::invalid_argument);
  EXPECT_THROW(CurrentProfile(Samples{{NAN, Vector3::Zero()}}), std::invalid_argument);
  EXPECT_THROW(CurrentProfile(Samples{{1.0, Vector3(0.0, NAN, 0.0)}}), std::invalid_argument);
}

TEST(EndTrajectory, PassesThroughBothEndsWithTheirVelocities)
{
  const EndMotion from{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}}, to{{2.0, 2.0, 2.0}, {-1.0, 0.0, 1.0}};
  const EndTrajectory path = EndTrajectory::between(10.0, from, 10.5, to);
  EXPECT_LT((path.position(10.0) - from.position).norm() + (path.velocity(10.0) - from.velocity).norm(), 1e-12);
  EXPECT_LT((path.position(10.5) - to.position).norm() + (path.velocity(10.5) - to.velocity).norm(), 1e-12);
  const double h = 1e-5;
  EXPECT_LT(((path.velocity(10.2 + h) - path.velocity(10.2 - h)) / (2 * h) - path.acceleration(10.2)).norm(),
            1e-6);
}

}  // namespace tether_monitor::core
