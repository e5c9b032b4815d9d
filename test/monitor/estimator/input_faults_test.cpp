// Inputs that lie: never OK with a wrong number for longer than a second.
#include <gtest/gtest.h>

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

}  // namespace tether_monitor::monitor
