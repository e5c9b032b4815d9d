#include "tether_monitor/monitor/ensemble/representative_member.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
using core::Vector3;

namespace
{
constexpr int ELEMENTS = 2;

// A tether that lies along y, so far off in x; its ends pull with 10 and 20 N.
core::StationProfile profileAt(double x, const Vector3& direction)
{
  core::StationProfile profile(ELEMENTS);
  for (std::size_t k = 0; k < profile.position.size(); ++k)
    profile.position[k] = Vector3(k == 0 ? 0.0 : x, 1.0 * static_cast<double>(k), 0.0);
  profile.vessel_direction = profile.vehicle_direction = direction;
  profile.ends.vessel = 10.0 * direction;
  profile.ends.vehicle = -20.0 * direction;
  return profile;
}

struct TwoMembers : testing::Test
{
  TwoMembers()
  {
    representative.prepare(ELEMENTS);
    profiles = {profileAt(0.0, Vector3::UnitY()), profileAt(30.0, Vector3::UnitX())};
  }

  // With these squared distances of the two.
  core::StationProfile shownAt(double t, double first, double second, bool fades = true)
  {
    const bool is_another = representative.choose(Eigen::RowVector2d(first, second));
    core::StationProfile shown = profiles[representative.index()];
    representative.show(t, shown, attitudes[representative.index()], is_another, fades);
    return shown;
  }

  RepresentativeMember representative;
  std::vector<core::StationProfile> profiles;
  const Eigen::Quaterniond attitudes[2] = {Eigen::Quaterniond::Identity(),
                                           Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Vector3::UnitZ()))};
};
}  // namespace

TEST_F(TwoMembers, TheNearestIsKeptUntilItIsFarAndAnotherMuchNearer)
{
  EXPECT_FALSE(representative.isValid(2, ELEMENTS));
  shownAt(0.0, 2.0, 1.0);
  EXPECT_EQ(representative.index(), 1);
  EXPECT_TRUE(representative.isValid(2, ELEMENTS));
  EXPECT_FALSE(representative.isValid(1, ELEMENTS)) << "there is no such member";
  EXPECT_FALSE(representative.isValid(2, ELEMENTS + 1)) << "of another mesh";
  shownAt(1.0, 0.0, 0.9);
  EXPECT_EQ(representative.index(), 0) << "0.9 of 0.45 on average, and another at 0";
  shownAt(2.0, 0.9, 3.0);
  EXPECT_EQ(representative.index(), 0) << "0.9 of 1.95 on average";
  shownAt(3.0, 3.0, 2.0);
  EXPECT_EQ(representative.index(), 0) << "far, but so is the other: two bunches must not take turns";
  shownAt(4.0, 3.0, 1.0);
  EXPECT_EQ(representative.index(), 1);
}

TEST_F(TwoMembers, NothingLeapsWhenAnotherIsShown)
{
  shownAt(0.0, 0.0, 9.0);
  const core::StationProfile before = shownAt(10.0, 0.0, 9.0), after = shownAt(10.0, 9.0, 0.0);
  ASSERT_EQ(representative.index(), 1);
  for (std::size_t k = 0; k < before.position.size(); ++k)
    EXPECT_LT((before.position[k] - after.position[k]).norm(), 1e-12) << "station " << k;
  EXPECT_LT((before.vessel_direction - after.vessel_direction).norm(), 1e-12);
  EXPECT_LT((before.ends.vehicle - after.ends.vehicle).norm(), 1e-12) << "as large, and where it pulled before";
  EXPECT_LT(representative.blended(attitudes[1]).angularDistance(attitudes[0]), 1e-7);

  const core::StationProfile later = shownAt(13.0, 9.0, 0.0);
  EXPECT_NEAR(later.position[2].x(), 30.0 * (1.0 - std::exp(-1.0)), 1e-9);
  EXPECT_NEAR(later.ends.vessel.norm(), 10.0, 1e-12) << "directions fade, forces do not";
  EXPECT_NEAR(later.vessel_direction.norm(), 1.0, 1e-12);
  EXPECT_NEAR(representative.offset(2).x(), -30.0 * std::exp(-1.0), 1e-9);
  EXPECT_NEAR(representative.blended(attitudes[1]).angularDistance(attitudes[0]), 1.0 - std::exp(-1.0), 1e-6);

  const core::StationProfile back = shownAt(13.0, 0.0, 9.0);
  EXPECT_LT((back.position[2] - later.position[2]).norm(), 1e-12) << "in the midst of it";

  const core::StationProfile last = shownAt(60.0, 9.0, 0.0), end = shownAt(120.0, 9.0, 0.0);
  EXPECT_LT((last.position[2] - end.position[2]).norm(), 31.0);
  EXPECT_NEAR(end.position[2].x(), 30.0, 1e-5);
  EXPECT_LT((end.vehicle_direction - Vector3::UnitX()).norm(), 1e-6);
}

TEST_F(TwoMembers, AStateThatWasReplacedDoesNotLeapEither)
{
  shownAt(0.0, 0.0, 9.0);
  core::StationProfile shown = profiles[1], same = profiles[1];
  representative.show(0.1, shown, attitudes[1], true, true);
  representative.blend(same);
  EXPECT_EQ(same.position[2], shown.position[2]);
  EXPECT_LT((shown.position[2] - profiles[0].position[2]).norm(), 1e-12);
}

TEST_F(TwoMembers, BesideObstaclesItIsAMemberAndNothingBetween)
{
  shownAt(0.0, 0.0, 9.0, false);
  const core::StationProfile shown = shownAt(0.1, 9.0, 0.0, false);
  EXPECT_EQ(shown.position[2], profiles[1].position[2]);
  EXPECT_LT(representative.blended(attitudes[1]).angularDistance(attitudes[1]), 1e-7);
}

TEST_F(TwoMembers, ATetherWithoutForceStaysWithout)
{
  for (core::StationProfile& profile : profiles)
    profile.ends = core::EndForces();
  shownAt(0.0, 0.0, 9.0);
  const core::StationProfile shown = shownAt(1.0, 9.0, 0.0);
  EXPECT_EQ(shown.ends.vessel.norm(), 0.0);
  EXPECT_TRUE(shown.vessel_direction.allFinite());
}

TEST_F(TwoMembers, ANewMeshIsANewStart)
{
  shownAt(0.0, 0.0, 9.0);
  shownAt(0.1, 9.0, 0.0);
  representative.prepare(ELEMENTS);
  EXPECT_EQ(representative.index(), RepresentativeMember::NONE);
  EXPECT_EQ(shownAt(0.2, 9.0, 0.0).position[2], profiles[1].position[2]);
}
}  // namespace tether_monitor::monitor
