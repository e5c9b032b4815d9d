#include "tether_monitor/monitor/config/suspicious_values.h"

#include <gtest/gtest.h>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
template <typename Slip>
std::string findingAfter(const Slip& slip)
{
  Config config = testConfig();
  config.vehicle_mode = VehicleMode::FREE;
  config.vehicle_body = smallVehicle();
  config.vehicle_body.center_of_buoyancy = {0.0, 0.0, 0.05};
  slip(config);
  const std::vector<std::string> found = suspiciousValues(config);
  return found.empty() ? "" : found.front();
}
}  // namespace

TEST(SuspiciousValues, ASlipOfAUnitIsNamed)
{
  EXPECT_EQ(findingAfter([](Config&) {}), "");
  EXPECT_NE(findingAfter([](Config& c) { c.tether.diameter *= 1000.0; }).find("in mm?"), std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.tether.mass_per_length *= 1000.0; }).find("per km"), std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.tether.axial_stiffness /= 1000.0; }).find("in kN?"), std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.tether.breaking_load /= 1000.0; }).find("breaking_load = 5 N"),
            std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.tether.axial_stiffness *= 1e6; }).find("Pa"), std::string::npos);
  EXPECT_NE(
      findingAfter([](Config& c) { c.environment.current = core::CurrentProfile(core::Vector3(50.0, 0.0, 0.0)); })
          .find("in cm/s?"),
      std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.environment.water_density = 1.025; }).find("water_density"),
            std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.vehicle_body.volume *= 1000.0; }).find("vehicle.volume"),
            std::string::npos);
  EXPECT_NE(findingAfter([](Config& c) { c.tether.drag_normal = 12.0; }).find("drag_normal"), std::string::npos);
}

TEST(SuspiciousValues, AVehicleThatNothingRights)
{
  const auto lying = [](Config& c)
  {
    c.vehicle_body.center_of_buoyancy.z() = -0.05;
    c.vehicle.attachment.z() = 0.0;
  };
  EXPECT_NE(findingAfter(lying).find("nothing rights"), std::string::npos);
  EXPECT_EQ(findingAfter(
                [&](Config& c)
                {
                  lying(c);
                  c.vehicle.attachment.z() = 0.2;
                }),
            "")
      << "its tether does";
  EXPECT_EQ(findingAfter(
                [&](Config& c)
                {
                  lying(c);
                  c.vehicle_mode = VehicleMode::TRACKED;
                }),
            "");
}

}  // namespace tether_monitor::monitor
