// Inputs that lie: never OK with a wrong number for longer than a second.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "support/fault_campaign.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double FAULT_FROM = 20.0, FAULT_UNTIL = 30.0, END = 100.0;

Config towConfig()
{
  Config c = testConfig();
  c.tether.length = 100.0;
  c.tether.working_load = 2000.0;
  c.tether.breaking_load = 1e4;
  return c;
}

struct Outcome
{
  Trust trust;
  bool has_lie_on_flag = false;  // over_tension false while INVALID
  Status at_end = Status::INVALID;
};

// A vehicle that hangs from the tether and is towed.
Config freeConfig()
{
  Config c = towConfig();
  c.vehicle_mode = VehicleMode::FREE;
  c.vehicle_body = smallVehicle();
  return c;
}

Outcome runWith(const Config& config, Subject faulty, PoseFault fault)
{
  TetherEstimator estimator(config), truth(config);
  const TowedTruth tow;
  FaultySource vessel(faulty == Subject::VESSEL ? fault : PoseFault::NONE, FAULT_FROM, FAULT_UNTIL);
  FaultySource vehicle(faulty == Subject::VEHICLE ? fault : PoseFault::NONE, FAULT_FROM, FAULT_UNTIL);
  Outcome run;
  const auto note = [&](double t, Rejection rejection)
  {
    if (rejection != Rejection::NONE)
      estimator.noteRejectedInput(t);
  };
  for (int i = 0; i <= static_cast<int>(20.0 * END); ++i)
  {
    const double t = 0.05 * i;
    truth.addVessel(PoseMeasurement{t, tow.vessel(t).position, Eigen::Quaterniond::Identity()});
    truth.addVehicle(PoseMeasurement{t, tow.vehicle(t).position, Eigen::Quaterniond::Identity()});
    if (const auto pose = vessel.at(t, tow.vessel(t)))
      note(t, estimator.addVessel(*pose));
    if (const auto pose = vehicle.at(t, tow.vehicle(t)))
      note(t, estimator.addVehicle(*pose));
    const TetherEstimate& right = truth.tick(t);
    const TetherEstimate& e = estimator.tick(t);
    if (t > 5.0)
      run.trust.add(t, e.status, e.vessel_tension, right.vessel_tension);
    run.has_lie_on_flag = run.has_lie_on_flag || (e.status == Status::INVALID && !estimator.overTension());
    run.at_end = e.status;
    if (getenv("SHOW") && i % 5 == 0)
      printf("%.2f %s %s %.0f %.0f\n", t, describe(e.status), describe(e.reason), e.vessel_tension,
             right.vessel_tension);
  }
  return run;
}
}  // namespace

TEST(InputFaults, OfPosesAreNeverBelievedForLong)
{
  for (const Subject body : {Subject::VESSEL, Subject::VEHICLE})
    for (int k = 0; k < static_cast<int>(PoseFault::COUNT); ++k)
    {
      const auto fault = static_cast<PoseFault>(k);
      const std::string name = std::string(describe(body)) + " " + describe(fault);
      const Outcome run = runWith(towConfig(), body, fault);
      printf("%-24s longest lie %.2f s, OK %.0f %%, at the end %s\n", name.c_str(), run.trust.longestLie(),
             100.0 * run.trust.shareOk(), describe(run.at_end));
      EXPECT_LE(run.trust.longestLie(), 1.0) << name;
      EXPECT_FALSE(run.has_lie_on_flag) << name;
      EXPECT_EQ(run.at_end, Status::OK) << name << ": back to normal";
      if (fault == PoseFault::NONE)
      {
        EXPECT_EQ(run.trust.shareOk(), 1.0);
      }
    }
}

TEST(InputFaults, OfTheVesselWithAFreeVehicleAreNeverBelievedForLong)
{
  for (int k = 0; k < static_cast<int>(PoseFault::COUNT); ++k)
  {
    const auto fault = static_cast<PoseFault>(k);
    const Outcome run = runWith(freeConfig(), Subject::VESSEL, fault);
    printf("%-24s longest lie %.2f s, OK %.0f %%, at the end %s\n", describe(fault), run.trust.longestLie(),
           100.0 * run.trust.shareOk(), describe(run.at_end));
    EXPECT_LE(run.trust.longestLie(), 1.0) << describe(fault);
    EXPECT_FALSE(run.has_lie_on_flag) << describe(fault);
    EXPECT_EQ(run.at_end, Status::OK) << describe(fault);
  }
}

namespace
{
// A winch that pays out 0.5 m/s from t = 10 s on; `report` may spoil what it says.
template <typename Report>
Outcome payOut(const Report& report)
{
  const Config config = towConfig();
  TetherEstimator estimator(config), truth(config);
  const TowedTruth tow;
  Outcome run;
  for (int i = 0; i <= 2000; ++i)
  {
    const double t = 0.05 * i;
    const double length = 100.0 + 0.3 * std::clamp(t - 10.0, 0.0, 20.0), rate = t > 10.0 && t < 30.0 ? 0.3 : 0.0;
    for (TetherEstimator* e : {&estimator, &truth})
    {
      e->addVessel(PoseMeasurement{t, tow.vessel(t).position, Eigen::Quaterniond::Identity()});
      e->addVehicle(PoseMeasurement{t, tow.vehicle(t).position, Eigen::Quaterniond::Identity()});
    }
    if (i % 2 == 0)
    {
      truth.addPayout(t, length, rate);
      const auto [said_length, said_rate] =
          t < 15.0 || t > 25.0 ? std::pair(length, rate) : report(t, length, rate);
      if (!std::isnan(said_length) && !estimator.addPayout(t, said_length, said_rate))
        estimator.noteRejectedInput(t);
    }
    const TetherEstimate& right = truth.tick(t);
    const TetherEstimate& e = estimator.tick(t);
    if (t > 5.0)
      run.trust.add(t, e.status, e.vessel_tension, right.vessel_tension);
    run.at_end = e.status;
  }
  return run;
}
}  // namespace

TEST(InputFaults, OfTheWinchAreNeverBelievedForLong)
{
  using Report = std::pair<double, double>;
  double frozen = 0.0;
  const std::map<std::string, std::function<Report(double, double, double)>> faults{
      {"none", [](double, double l, double r) { return Report(l, r); }},
      {"killed", [](double, double, double) { return Report(NAN, NAN); }},
      {"frozen",
       [&](double t, double l, double r)
       {
         frozen = t < 15.2 ? l : frozen;
         return Report(frozen, r);
       }},
      {"leapt", [](double, double l, double r) { return Report(l + 20.0, r); }},
      {"rate of the wrong sign", [](double, double l, double r) { return Report(l, -r); }},
      {"rate of zero", [](double, double l, double) { return Report(l, 0.0); }},
      {"extreme", [](double, double, double) { return Report(1e300, 1e300); }}};
  for (const auto& [name, report] : faults)
  {
    const Outcome run = payOut(report);
    printf("%-24s longest lie %.2f s, OK %.0f %%, at the end %s\n", name.c_str(), run.trust.longestLie(),
           100.0 * run.trust.shareOk(), describe(run.at_end));
    EXPECT_LE(run.trust.longestLie(), 1.0) << name;
    EXPECT_EQ(run.at_end, Status::OK) << name;
    if (name == "none")
    {
      EXPECT_EQ(run.trust.shareOk(), 1.0);
    }
  }
}

TEST(InputFaults, NoTetherOutIsNoDanger)
{
  EstimatorFixture site;
  site.run(3.0);
  ASSERT_EQ(site.estimator.estimate().status, Status::OK) << "precondition";
  ASSERT_TRUE(site.estimator.addPayout(site.t, 0.0, 0.0));
  site.run(0.1);
  EXPECT_EQ(site.estimator.estimate().status, Status::STOWED);
  EXPECT_TRUE(site.estimator.estimate().is_stowed);
  EXPECT_FALSE(site.estimator.estimate().has_stations);
  EXPECT_FALSE(site.estimator.overTension());
  site.run(10.0);
  EXPECT_EQ(site.estimator.estimate().reason, Reason::PAYOUT_STALE) << "a winch that says nothing more";
  EXPECT_TRUE(site.estimator.overTension());
  ASSERT_TRUE(site.estimator.addPayout(site.t, 100.0, 0.0));
  site.run(0.5);
  EXPECT_EQ(site.estimator.estimate().status, Status::OK);
  EXPECT_FALSE(site.estimator.estimate().is_stowed);
}

TEST(InputFaults, OneReportOfNoLengthStowsNoTether)
{
  EstimatorFixture site;
  for (int i = 0; i < 20; ++i)
  {
    site.estimator.addPayout(site.t, 100.0, 0.0);
    site.run(0.1);
  }
  ASSERT_EQ(site.estimator.estimate().status, Status::OK) << "precondition";
  EXPECT_FALSE(site.estimator.addPayout(site.t, 0.0, 0.0));
  site.run(0.1);
  EXPECT_FALSE(site.estimator.estimate().is_stowed);
  for (int i = 0; i < 4; ++i)
  {
    site.estimator.addPayout(site.t, 0.0, 0.0);
    site.run(0.1);
  }
  EXPECT_TRUE(site.estimator.estimate().is_stowed) << "one that lasts is believed";
  TetherEstimator other(testConfig());
  EXPECT_TRUE(other.restore(site.estimator.save()));
  EXPECT_TRUE(other.estimate().is_stowed);
}

TEST(InputFaults, AStowedTetherHasNoOverTension)
{
  Config config = testConfig();
  config.tether.working_load = 10.0;
  EstimatorFixture site(config);
  site.run(3.0);
  ASSERT_TRUE(site.estimator.overTension()) << "precondition";
  ASSERT_TRUE(site.estimator.addPayout(site.t, 0.0, 0.0));
  site.run(0.1);
  EXPECT_FALSE(site.estimator.overTension());
  for (const Alarm& alarm : site.estimator.alarms().alarms())
    EXPECT_FALSE(alarm.isActive()) << alarm.definition().name;
}

TEST(InputFaults, ImpossibleWorldsAreNamed)
{
  const auto finding = [](double vessel_z, double vehicle_z, Subject subject, Implausibility what)
  {
    EstimatorFixture site;
    site.vessel.z() = vessel_z;
    site.vehicle = {60.0, 0.0, vehicle_z};
    site.run(3.0);
    EXPECT_NE(site.estimator.estimate().status, Status::OK) << vessel_z << " " << vehicle_z;
    return site.estimator.findings().last(subject, what) > 0.0;
  };
  EXPECT_TRUE(finding(1.0, 20.0, Subject::VEHICLE, Implausibility::VEHICLE_ABOVE_WATER));
  EXPECT_TRUE(finding(1.0, 70.0, Subject::VEHICLE, Implausibility::VEHICLE_ABOVE_WATER)) << "z down";
  EXPECT_TRUE(finding(-50.0, -70.0, Subject::VESSEL, Implausibility::VESSEL_UNDER_WATER));
}

TEST(InputFaults, ScatterOnATautTetherIsUncertain)
{
  Config config = towConfig();
  config.vehicle.position_stddev = 0.3;
  TetherEstimator estimator(config);
  const TowedTruth tow;
  for (int i = 0; i <= 200; ++i)
  {
    const double t = 0.05 * i;
    estimator.addVessel(PoseMeasurement{t, tow.vessel(t).position, Eigen::Quaterniond::Identity()});
    estimator.addVehicle(PoseMeasurement{t, tow.vehicle(t).position, Eigen::Quaterniond::Identity()});
    estimator.tick(t);
  }
  const TetherEstimate& e = estimator.estimate();
  EXPECT_EQ(e.reason, Reason::UNCERTAIN);
  // At least that of the straight tether: EA / L times the scatter.
  EXPECT_GT(e.vessel_tension_stddev, 0.5 * config.tether.axial_stiffness / config.tether.length * 0.3);
  EXPECT_EQ(e.vehicle_position_stddev, 0.3);
}

}  // namespace tether_monitor::monitor
