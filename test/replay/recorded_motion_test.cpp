#include "tether_monitor/replay/recorded_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace tether_monitor::replay
{
namespace
{
const std::string HEADER = "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z";

Motion motionOf(const std::string& text)
{
  const std::string path = ::testing::TempDir() + "tether_monitor_motion.csv";
  std::ofstream(path) << text;
  return Motion(files::readCsv(path));
}

std::string errorOf(const std::string& text)
{
  try
  {
    motionOf(text);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}
}  // namespace

struct BadMotion
{
  std::string text;
  const char* says;
};
class MotionRefuses : public ::testing::TestWithParam<BadMotion>
{
};
TEST_P(MotionRefuses, AndSaysWhere)
{
  EXPECT_NE(errorOf(GetParam().text).find(GetParam().says), std::string::npos) << errorOf(GetParam().text);
}
INSTANTIATE_TEST_SUITE_P(
    Files, MotionRefuses,
    ::testing::Values(BadMotion{"", "is empty"}, BadMotion{"# nothing\n", "is empty"},
                      BadMotion{HEADER + "\n", "no rows"},
                      BadMotion{HEADER + "\n0,0,0,0,1,1\n", "line 2: 6 fields where the header names 7"},
                      BadMotion{HEADER + "\n# c\n0,0,0,0,1,1,x\n",
                                "line 3: column vehicle_z = 'x' is not a number"},
                      BadMotion{HEADER + "\n0,0,0,0,1,1,nan\n", "line 2: column vehicle_z = 'nan' is not finite"},
                      BadMotion{HEADER + "\n0,0,0,0,1,1,\n", "line 2: column vehicle_z is empty"},
                      BadMotion{HEADER + "\n0,0,0,0,1,1,1\n0,0,0,0,1,1,1\n", "line 3: t does not increase"},
                      BadMotion{"t,vessel_x,vessel_y,vessel_z\n0,0,0,0\n", "line 1: column vehicle_x is missing"},
                      BadMotion{HEADER + ",speed\n0,0,0,0,1,1,1,2\n", "line 1: column speed is not known"},
                      BadMotion{HEADER + ",t\n0,0,0,0,1,1,1,2\n", "column 't' stands twice"},
                      BadMotion{HEADER + ",vessel_vx\n0,0,0,0,1,1,1,2\n", "column vessel_vy is missing"},
                      BadMotion{HEADER + ",payout\n0,0,0,0,1,1,1,0\n", "line 2: payout must be > 0"},
                      BadMotion{HEADER + ",vessel_qx,vessel_qy,vessel_qz,vessel_qw\n0,0,0,0,1,1,1,0,0,0,0\n",
                                "line 2: vessel_q is not a unit quaternion"}));

TEST(Motion, WithVelocitiesItIsTheHermiteCurve)
{
  const Motion m = motionOf(HEADER + ",vessel_vx,vessel_vy,vessel_vz\n0,0,0,0,1,1,1,1,0,0\n2,0,0,0,1,1,1,1,0,0\n");
  EXPECT_NEAR(m.vessel(1.0).position.x(), 0.0, 1e-15);
  EXPECT_NEAR(m.vessel(0.5).position.x(), 0.1875, 1e-15);
  EXPECT_NEAR(m.vessel(2.0).velocity.x(), 1.0, 1e-15);
}

TEST(Motion, OneRowIsEnough)
{
  const Motion m = motionOf("# comment\n" + HEADER + "\n5,1,2,3,4,5,6\n");
  EXPECT_EQ(m.vehicle(5.0).position, core::Vector3(4, 5, 6));
}

TEST(Motion, AttitudeTurnsEvenly)
{
  const double c = std::sqrt(0.5);
  const Motion m =
      motionOf(HEADER + ",vessel_qx,vessel_qy,vessel_qz,vessel_qw\n0,0,0,0,1,1,1,0,0,0,1\n1,0,0,0,1,1,1,0,0," +
               std::to_string(c) + "," + std::to_string(c) + "\n");
  const core::EndMotion point = m.vessel(0.5).attachmentPoint({1, 0, 0});
  EXPECT_NEAR(point.position.y(), std::sin(M_PI / 4), 1e-6);
  EXPECT_NEAR(point.velocity.norm(), M_PI / 2, 1e-5);
}

}  // namespace tether_monitor::replay
