// What doc/validation.md claims of the observed vehicle under navigation noise: accuracy, bands, gaps, faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "navigation.h"

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
// than `sigmas` of its own standard deviations [s].
double longestLie(const Truth& truth, const Trail& trail, double from, double share = 0.1)
{
  double longest = 0.0, lasting = 0.0;
  for (std::size_t i = 0; i < trail.t.size(); ++i)
  {
    const double error = std::abs(trail.vessel_tension[i] / truth.vessel_tension[i] - 1.0);
    const bool lies = trail.t[i] > from && trail.status[i] == Status::OK && error > share;
    lasting = lies ? lasting + truth.step : 0.0;
    longest = std::max(longest, lasting);
  }
  return longest;
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

TEST(Navigation, AGapInTheTurnIsCoveredByTheBand)
{
  const Truth truth = makeTruth(caseNamed("D"), 0.0, core::Vector3::Zero());
  Sensors sensors;
  sensors.fault = [](double t, core::Vector3&) { return t < 100.0 || t > 280.0; };
  const Trail trail = observe(truth, configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors), sensors);
  int outside = 0, seen = 0;
  for (std::size_t i = 0; i < trail.t.size(); ++i)
    if (trail.t[i] > 100.0 && trail.t[i] < 280.0 && trail.status[i] != Status::INVALID)
    {
      ++seen;
      outside += std::abs(trail.vessel_tension[i] - truth.vessel_tension[i]) > 2.0 * trail.vessel_stddev[i];
    }
  EXPECT_EQ(seen, 3599);
  EXPECT_EQ(outside, 0);
  EXPECT_GT(shareOf(trail, Status::DEGRADED, 110.0, 280.0), 0.99);
  EXPECT_LT(score(truth, trail, 311.0, 400.0).rms, 0.05);
  EXPECT_LT(std::abs(score(truth, trail, 281.0, 400.0).peak), 0.1) << "no jump on return";
  EXPECT_FALSE(trail.limit_alarm);
}

TEST(Navigation, FaultyPositionsNeverPassForGood)
{
  for (const char* name : {"C", "D", "G"})
  {
    const Truth truth = makeTruth(caseNamed(name), 400.0, core::Vector3::Zero());
    const auto run = [&](const char* what, std::function<bool(double, core::Vector3&)> fault)
    {
      Sensors sensors;
      sensors.fault = std::move(fault);
      monitor::Config config = configFor(truth, Knowledge(), VehicleMode::OBSERVED, sensors);
      const Trail trail = observe(truth, config, sensors);
      EXPECT_LE(longestLie(truth, trail, 100.0), 2.0) << name << ", " << what;
      EXPECT_LT(shareOf(trail, Status::OK, 125.0, 400.0), 0.5) << name << ", " << what << ": it is seen";
      const Score s = score(truth, trail, 60.0);
      printf("%s %s: lie %.1f s ok %.2f rms %.2f%% peak %.1f%% valid %.2f refused %ld reacquired %ld\n", name,
             what, longestLie(truth, trail, 100.0), shareOf(trail, Status::OK, 125.0, 400.0), 100 * s.rms,
             100 * s.peak, s.valid, trail.innovations.refused, trail.innovations.reacquired);
    };
    core::Vector3 stuck = core::Vector3::Zero();
    run("frozen",
        [&](double t, core::Vector3& p)
        {
          stuck = t < 100.0 ? p : stuck;
          p = stuck;
          return true;
        });
    run("frozen with noise",
        [&](double t, core::Vector3& p)
        {
          stuck = t < 100.0 ? p : stuck;
          p = stuck + 0.3 * core::Vector3(std::sin(17.0 * t), std::sin(23.0 * t), std::sin(31.0 * t));
          return true;
        });
    run("teleporting",
        [&](double t, core::Vector3& p)
        {
          if (t > 100.0)
            p += 60.0 *
                 core::Vector3(std::sin(std::floor(t / 7.0) * 2.3), std::cos(std::floor(t / 7.0) * 1.7), 0.3);
          return true;
        });
    run("100 m wrong",
        [&](double t, core::Vector3& p)
        {
          if (t > 100.0)
            p.y() += 100.0;
          return true;
        });
    run("100 m too deep",
        [&](double t, core::Vector3& p)
        {
          if (t > 100.0)
            p.z() -= 100.0;
          return true;
        });
  }
}

TEST(Navigation, ATautTetherThatIsTooShortSaysSo)
{
  const Truth truth = makeTruth(caseNamed("C"), 0.0, core::Vector3::Zero());
  Sensors sensors;
  Knowledge knowledge;
  knowledge.length_factor = 0.99;
  const Trail trail = observe(truth, configFor(truth, knowledge, VehicleMode::OBSERVED, sensors), sensors);
  const Score s = score(truth, trail, 20.0);
  printf("short: rms %.2f%% peak %.1f%% ok %.2f valid %.2f\n", 100 * s.rms, 100 * s.peak, s.ok, s.valid);
  EXPECT_LT(s.peak, 0.25) << "no spike";
  EXPECT_LT(shareOf(trail, Status::OK, 20.0, 200.0), 0.02);
  EXPECT_TRUE(std::count(trail.reason.begin(), trail.reason.end(), Reason::OUT_OF_RANGE) > 2000);
}
}  // namespace tether_monitor::bench
