#include "tether_monitor/monitor/config/config_fingerprint.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
using Change = std::function<void(Config&)>;

Config observed()
{
  Config c = testConfig();
  c.vehicle_mode = VehicleMode::OBSERVED;
  c.vehicle_body = smallVehicle();
  c.alarms["max_tension"].limit = 800.0;
  return c;
}

// How many different fingerprints the changes make, with that of the configuration itself.
std::size_t different(const Config& config, const std::vector<Change>& changes)
{
  std::set<std::uint64_t> found{fingerprint(config)};
  for (const Change& change : changes)
  {
    Config changed = config;
    change(changed);
    found.insert(fingerprint(changed));
  }
  return found.size();
}
}  // namespace

TEST(ConfigFingerprint, DiffersWithEveryNumberOfTheModel)
{
  const std::vector<Change> changes{[](Config& c) { c.tether.length += 1e-9; },
                                    [](Config& c) { c.tether.axial_stiffness *= 2.0; },
                                    [](Config& c) { c.tether.min_bend_radius = 0.5; },
                                    [](Config& c) {
                                      c.layout.attachments = {{"float", 50.0, 1.0, 0.0, 0.0}};
                                    },
                                    [](Config& c) {
                                      c.layout.attachments = {{"float", 50.0, 1.0, 0.0, 0.1}};
                                    },
                                    [](Config& c) {
                                      c.layout.sections = {{0.0, 50.0, c.tether}};
                                    },
                                    [](Config& c) { c.elements = 21; },
                                    [](Config& c) { c.environment.water_density = 1000.0; },
                                    [](Config& c) {
                                      c.environment.waves.components = {{0.5, 60.0, 0.0, 0.0}};
                                    },
                                    [](Config& c) { c.environment.waves.stretching = core::WaveStretching::NONE; },
                                    [](Config& c) { c.environment.waves.spectrum = core::WaveSpectrum(); },
                                    [](Config& c) { c.tether.added_mass_tangential = 0.1; },
                                    [](Config& c) { c.tether.contact_diameter = 0.1; },
                                    [](Config& c) { c.environment.seabed = core::Seabed(); },
                                    [](Config& c) { c.vehicle_body.mass = 151.0; },
                                    [](Config& c) { c.vehicle.attachment.x() = 0.1; },
                                    [](Config& c) { c.vehicle_mode = VehicleMode::FREE; },
                                    [](Config& c) { c.navigation.latency = 0.5; },
                                    [](Config& c) { c.drag_amplification = 1.5; }};
  EXPECT_EQ(different(observed(), changes), changes.size() + 1);
}

TEST(ConfigFingerprint, DiffersWithEveryNumberOfTheSolverAndTheAlarms)
{
  const std::vector<Change> changes{[](Config& c) { c.solver.step = 0.04; },
                                    [](Config& c) { c.solver.newton.relative_tolerance = 1e-7; },
                                    [](Config& c) { c.solver.scheme = core::Scheme::ABARBANEL_ZWAS; },
                                    [](Config& c) { c.accuracy = 0.01; },
                                    [](Config& c) { c.alarms["max_tension"].limit = 801.0; },
                                    [](Config& c) { c.alarms["max_tension"].warning = 801.0; },
                                    [](Config& c) { c.alarms["max_tension"].timing.on_delay = 1.0; },
                                    [](Config& c) { c.alarms["max_tension"].timing.latch = true; },
                                    [](Config& c) { c.alarms["min_tension"].limit = 800.0; },
                                    [](Config& c) { c.alarms.clear(); }};
  EXPECT_EQ(different(observed(), changes), changes.size() + 1);
}

TEST(ConfigFingerprint, IsTheSameForWhatIsNoPartOfThem)
{
  EXPECT_EQ(fingerprint(observed()), fingerprint(observed()));
  const std::vector<Change> changes{[](Config& c) { c.world_frame = "odom"; }, [](Config& c) { c.rate = 10.0; },
                                    [](Config& c) { c.vessel.frame = "ship"; }};
  EXPECT_EQ(different(observed(), changes), 1u);
}

TEST(ConfigFingerprint, AVehicleThatIsNotSimulatedDoesNotCount)
{
  const std::vector<Change> changes{[](Config& c) { c.vehicle_body.mass = 1.0; },
                                    [](Config& c) { c.navigation.latency = 0.5; }};
  EXPECT_EQ(different(testConfig(), changes), 1u);
}
}  // namespace tether_monitor::monitor
