// What doc/validation.md claims of the observed vehicle under navigation noise: accuracy, bands, gaps, faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "verification/estimation_study.h"
#include "verification/navigation_study.h"

namespace tether_monitor::bench
{
namespace
{
using monitor::Reason;
using monitor::Status;
using monitor::VehicleMode;

Case caseNamed(const std::string& name)
{
  for (const Case& c : navigationCases())
    if (c.name == name)
      return c;
  return {};
}

// Longest time for which the status was OK while the vessel tension was wrong by more than `share` and by more
// than two of its own standard deviations [s].
double longestSureError(const Truth& truth, const Trail& trail, double from, double share = 0.1)
{
  double longest = 0.0, lasting = 0.0;
  for (std::size_t i = 0; i < trail.t.size(); ++i)
  {
    const double error = std::abs(trail.vessel_tension[i] / truth.vessel_tension[trail.index[i]] - 1.0);
    const bool is_sure_and_wrong =
        trail.t[i] > from && trail.status[i] == Status::OK && error > share &&
        std::abs(trail.vessel_tension[i] - truth.vessel_tension[trail.index[i]]) > 2.0 * trail.vessel_stddev[i];
    lasting = is_sure_and_wrong ? lasting + trail.t[1] - trail.t[0] : 0.0;
    longest = std::max(longest, lasting);
  }
  return longest;
}

// Half as fast and with fewer members: what is to be seen here shows in that as well.
monitor::Config quick(monitor::Config config)
{
  config.rate = 10.0;
  config.solver.step = 0.1;
  config.uncertainty.members = 64;
  return config;
}

// Tether and water are known well, and that is told.
monitor::Config wellKnown(monitor::Config config)
{
  config.uncertainty.drag_normal = config.uncertainty.drag_tangential = 0.02;
  config.uncertainty.mass_per_length = 0.002;
  config.uncertainty.length = 0.0005;
  config.uncertainty.axial_stiffness = 0.02;
  config.uncertainty.current = 0.02;
  config.navigation.drag_stddev = 0.05;
  return quick(config);
}

double shareOf(const Trail& trail, Status status, double from, double to)
{
  double n = 0.0, hits = 0.0;
  for (std::size_t i = 0; i < trail.t.size(); ++i)
    if (trail.t[i] >= from && trail.t[i] < to)
    {
      n += 1.0;
      hits += trail.status[i] == status;
    }
  return hits / n;
}
}  // namespace

// scripts/bench estimation has the whole study.
TEST(Navigation, AWellKnownTetherUnderAWellKnownForceHasAWellKnownTension)
{
  for (const char* name : {"C", "D", "G"})
  {
    const Truth truth = makeTruth(caseNamed(name), 0.0, core::Vector3::Zero());
    Sensors sensors;
    monitor::Config config = wellKnown(configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors));
    config.navigation.force_stddev = 20.0;
    const Trail trail = observe(truth, config, sensors);
    const Score s = score(truth, trail);
    EXPECT_LT(s.rms, 0.03) << name;
    EXPECT_LT(s.mean_stddev, 0.09) << name;
    EXPECT_GT(s.within_2, 0.9) << name;
    EXPECT_LT(std::abs(s.peak), 0.1) << name;
    EXPECT_FALSE(trail.limit_alarm) << name;
    EXPECT_GT(s.ok, 0.95) << name;
  }
}

// What a filter on one tether with configured parameters is sure of and 40 to 60 % wrong about.
TEST(Navigation, ATetherThatIsNotAsToldIsInTheBand)
{
  const Case tow = caseNamed("C");
  struct Otherwise
  {
    const char* what;
    std::function<void(monitor::Config&)> tell;
  };
  const std::vector<Otherwise> otherwise{
      {"drag 26 % low", [](monitor::Config& c) { c.tether.drag_normal *= 0.74; }},
      {"mass 5 % high", [](monitor::Config& c) { c.tether.mass_per_length *= 1.05; }},
      {"a current across that is not known",
       [](monitor::Config& c) { c.environment.current = core::CurrentProfile(core::Vector3(0.0, 0.3, 0.0)); }},
      {"a vehicle with more drag", [](monitor::Config& c) { c.vehicle_body.drag_area *= 1.3; }}};
  const Truth truth = makeTruth(tow, 0.0, core::Vector3::Zero());
  for (const Otherwise& fault : otherwise)
  {
    Sensors sensors;
    monitor::Config config = quick(configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors));
    fault.tell(config);
    const Trail trail = observe(truth, config, sensors);
    const Score s = score(truth, trail);
    EXPECT_GT(s.within_2, 0.95) << fault.what;
    EXPECT_LE(longestSureError(truth, trail, 60.0), 3.0) << fault.what;
    EXPECT_GT(s.valid, 0.95) << fault.what;

    sensors.has_load_cell = true;
    const Score with_cell = score(truth, observe(truth, config, sensors));
    EXPECT_LT(with_cell.rms, 0.05) << fault.what;
    EXPECT_LT(with_cell.mean_stddev, 0.7 * s.mean_stddev) << fault.what;
  }
}

// Satellite positions of the vessel from two decimetres to two metres: what is lost is known to be lost.
TEST(Navigation, ALoadCellTellsTheTensionOfTheMomentAndTheBandKnows)
{
  StudyOptions options;
  options.draws = 4;
  options.has_load_cell = true;
  const StudyResult r = studyPooled(uncertainCase("C"), options);
  EXPECT_LT(r.vessel.rms, 0.045 * r.vessel.mean) << "cell and bias: 2 % of the reading, 2 % of the working load";
  EXPECT_LT(r.vessel.band, 0.045 * r.vessel.mean);
  EXPECT_GT(r.vessel.nees, 0.4);
  EXPECT_LT(r.vessel.nees, 2.0);
  EXPECT_LT(r.vehicle.band, 0.25 * r.vehicle.mean);
  EXPECT_EQ(r.limit_alarms, 0);
  // Cycles without a reading of their own are not worse: no band that flickers.
  options.draws = 2;
  options.rate = 20.0;
  const StudyResult faster = studyPooled(uncertainCase("C"), options);
  EXPECT_LT(faster.vessel.band, 0.045 * faster.vessel.mean);
  EXPECT_GT(faster.ok, 0.95);
}

TEST(Navigation, TheBandKnowsHowWellTheVesselIsSeen)
{
  double last = 0.0;
  for (const auto& [stddev, bound] :
       {std::make_pair(0.2, 0.08), std::make_pair(0.7, 0.16), std::make_pair(2.0, 0.35)})
  {
    double two = 0.0, band = 0.0;
    for (const char* name : {"C", "D", "G"})
    {
      const Truth truth = makeTruth(caseNamed(name), 0.0, core::Vector3::Zero());
      Sensors sensors;
      sensors.satellite_stddev = stddev;
      const Trail trail =
          observe(truth, wellKnown(configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors)), sensors);
      const Score s = score(truth, trail);
      EXPECT_LT(s.rms, bound) << name << stddev;
      EXPECT_GT(s.valid, 0.95) << name << stddev;
      two += s.within_2 / 3.0;
      band += s.mean_stddev / 3.0;
    }
    EXPECT_GT(two, 0.85) << stddev;
    EXPECT_GT(band, 1.1 * last) << stddev;
    last = band;
  }
}

TEST(Navigation, TheHeldEndIsWorthlessOnTheSameData)
{
  const Truth truth = makeTruth(caseNamed("C"), 0.0, core::Vector3::Zero());
  Sensors sensors;
  sensors.outliers = 0.0;
  const Trail trail = observe(truth, configFor(truth, Knowledge(), VehicleMode::TRACKED, sensors), sensors);
  EXPECT_GT(score(truth, trail).rms, 1.0);
}

TEST(Navigation, SlowerAndLaterPositionsAreStillGood)
{
  const Truth truth = makeTruth(caseNamed("D"), 150.0, core::Vector3::Zero());
  Sensors slow;
  slow.latency = 3.0;
  slow.fix_interval = 2.0;
  EXPECT_LT(
      score(truth, observe(truth, wellKnown(configFor(truth, Knowledge(), VehicleMode::OBSERVED, slow)), slow))
          .rms,
      0.05)
      << "every other second, three seconds late";
}

// What was learnt while a position was under way counts when it is looked at.
TEST(Navigation, ATurnIsFollowedFromPositionsTenSecondsLate)
{
  UncertainCase turn = uncertainCase("D");
  turn.true_elements = 30;
  StudyOptions options;
  options.draws = 2;
  options.latency = 10.0;
  const StudyResult r = studyPooled(turn, options);
  EXPECT_LT(r.position_rms, 2.5);
  EXPECT_LT(r.vessel.nees, 3.0);
  EXPECT_GT(r.valid, 0.95);
  EXPECT_LT(r.implausible, 0.05);
}

TEST(Navigation, AGapInTheTurnIsCoveredByTheBand)
{
  const Truth truth = makeTruth(caseNamed("D"), 0.0, core::Vector3::Zero());
  Sensors sensors;
  sensors.fault = [](double t, core::Vector3&) { return t < 100.0 || t > 280.0; };
  const Trail trail =
      observe(truth, wellKnown(configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors)), sensors);
  int outside = 0, seen = 0;
  for (std::size_t i = 0; i < trail.t.size(); ++i)
    if (trail.t[i] > 100.0 && trail.t[i] < 280.0 && trail.status[i] != Status::INVALID)
    {
      ++seen;
      outside +=
          std::abs(trail.vessel_tension[i] - truth.vessel_tension[trail.index[i]]) > 2.0 * trail.vessel_stddev[i];
    }
  EXPECT_NEAR(seen, 1799, 2);
  EXPECT_EQ(outside, 0);
  EXPECT_GT(shareOf(trail, Status::DEGRADED, 110.0, 280.0), 0.99);
  EXPECT_LT(score(truth, trail, 311.0, 400.0).rms, 0.05);
  EXPECT_LT(std::abs(score(truth, trail, 281.0, 400.0).peak), 0.1) << "no jump on return";
  EXPECT_FALSE(trail.limit_alarm);
}

namespace
{
struct Fault
{
  const char* what;
  std::function<bool(double, core::Vector3&)> change;
  bool shows_at_rest = true;  // whether a vehicle that keeps its station betrays it
};

std::vector<Fault> faults()
{
  const auto stuck = std::make_shared<core::Vector3>(core::Vector3::Zero());
  const auto freeze = [stuck](double t, core::Vector3& p)
  {
    *stuck = t < 100.0 ? p : *stuck;
    p = *stuck;
    return true;
  };
  const auto shift = [](const core::Vector3& by)
  {
    return [by](double t, core::Vector3& p)
    {
      p += t > 100.0 ? by : core::Vector3::Zero();
      return true;
    };
  };
  return {{"frozen", freeze},
          {"frozen but for its noise",
           [=](double t, core::Vector3& p)
           {
             freeze(t, p);
             p += 0.3 * core::Vector3(std::sin(17.0 * t), std::sin(23.0 * t), std::sin(31.0 * t));
             return true;
           },
           false},
          {"teleporting",
           [](double t, core::Vector3& p)
           {
             const double place = std::floor(t / 7.0);
             if (t > 100.0)
               p += 60.0 * core::Vector3(std::sin(2.3 * place), std::cos(1.7 * place), 0.3);
             return true;
           }},
          {"100 m aside", shift({0.0, 100.0, 0.0})},
          {"100 m too deep", shift({0.0, 0.0, -100.0})}};
}
}  // namespace

TEST(Navigation, FaultyPositionsNeverPassForGood)
{
  for (const char* name : {"C", "D", "G"})
  {
    const Truth truth = makeTruth(caseNamed(name), 400.0, core::Vector3::Zero());
    for (const Fault& fault : faults())
    {
      Sensors sensors;
      sensors.fault = fault.change;
      const Trail trail =
          observe(truth, wellKnown(configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors)), sensors);
      EXPECT_LE(longestSureError(truth, trail, 60.0), 2.0) << name << ", " << fault.what;
      if (fault.shows_at_rest || std::string(name) != "G")
      {
        EXPECT_LT(shareOf(trail, Status::OK, 110.0, 400.0), 0.02) << name << ", " << fault.what << ": it is seen";
      }
      if (std::string(name) != "G")
      {
        EXPECT_LT(std::abs(score(truth, trail).peak), 0.6) << name << ", " << fault.what;
      }
    }
  }
}

TEST(Navigation, ATautTetherThatIsTooShortSaysSo)
{
  const Truth truth = makeTruth(caseNamed("C"), 0.0, core::Vector3::Zero());
  Sensors sensors;
  Knowledge knowledge;
  knowledge.length_factor = 0.99;
  const Trail trail =
      observe(truth, wellKnown(configFor(truth, knowledge, VehicleMode::OBSERVED, sensors)), sensors);
  const Score s = score(truth, trail, 20.0);
  EXPECT_LT(s.peak, 1.5) << "where positions that are believed make tens of kilonewtons";
  EXPECT_LT(shareOf(trail, Status::OK, 20.0, 200.0), 0.05);
  EXPECT_GT(std::count(trail.reason.begin(), trail.reason.end(), Reason::IMPLAUSIBLE), 800);
}
}  // namespace tether_monitor::bench
