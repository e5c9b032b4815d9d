#include "tether_monitor/replay/recorded_measurements.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/observed_table.h"
#include "tether_monitor/replay/recorded_motion.h"

namespace tether_monitor::replay
{
namespace
{
std::string faultOf(const std::string& rows)
{
  try
  {
    const files::CsvTable table = observedTable(rows);
    RecordedMeasurements measurements(table);
    Motion motion(table, monitor::VehicleMode::OBSERVED);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    const std::string text = error.what();
    return text.substr(text.find(", line") == std::string::npos ? 0 : text.find(", line") + 2);
  }
}
}  // namespace

TEST(RecordedMeasurements, AnEmptyFieldIsNone)
{
  const RecordedMeasurements m(observedTable(HEADER + ",vehicle_stddev,payout\n"
                                                      "0,0,0,1,,,,,100\n"
                                                      "0.1,,,1.2,1,2,-98,0.4,100\n"
                                                      "0.2,0.3,0,1,3,4,-98,,100\n"));
  ASSERT_EQ(m.rows().size(), 3u);
  EXPECT_FALSE(m.rows()[0].vehicle);
  ASSERT_EQ(m.rows()[1].vehicle->position.accuracy(0), monitor::Accuracy::SPECIFIED);
  EXPECT_EQ(m.rows()[1].vehicle->position.stddev(0), 0.4);
  EXPECT_FALSE(m.rows()[1].vessel->position.isMeasured(0)) << "the height alone";
  EXPECT_EQ(m.rows()[1].vessel->position.accuracy(2), monitor::Accuracy::UNSPECIFIED);
  EXPECT_EQ(m.rows()[2].vehicle->position.accuracy(0), monitor::Accuracy::UNSPECIFIED) << "as configured";
  EXPECT_FALSE(m.vesselAtFirstRow()) << "its velocity is not measured";
}

TEST(RecordedMeasurements, SensorsAtTheVesselEndAndSingleAxesMayBeThere)
{
  const RecordedMeasurements m(observedTable(HEADER + ",vessel_vx,vessel_vy,vessel_vz,tension,direction_x,"
                                                      "direction_y,direction_z\n"
                                                      "0,0,0,1,,,,2,1,0,,,,\n"
                                                      "0.1,0.2,0.1,1,,,-98,,,,431.5,0,0.1,-2\n"));
  EXPECT_FALSE(m.rows()[0].tension);
  EXPECT_FALSE(m.rows()[0].direction);
  EXPECT_EQ(m.rows()[1].tension.value(), 431.5);
  EXPECT_EQ(m.rows()[1].direction.value(), core::Vector3(0.0, 0.1, -2.0));
  EXPECT_FALSE(m.rows()[1].vehicle->position.isMeasured(1));
  EXPECT_TRUE(m.rows()[1].vehicle->position.isMeasured(2)) << "a depth alone";
  ASSERT_TRUE(m.vesselAtFirstRow());
  EXPECT_EQ(m.vesselAtFirstRow()->velocity.x(), 2.0);
}

TEST(RecordedMeasurements, FaultsAreNamedWithTheirLine)
{
  EXPECT_NE(faultOf("t,vessel_x,vessel_y,vessel_z\n0,0,0,1\n").find("vehicle_x is missing"), std::string::npos);
  EXPECT_NE(faultOf(HEADER + ",vehicle_speed\n0,0,0,1,,,,1\n").find("vehicle_speed is not known"),
            std::string::npos);
  EXPECT_NE(faultOf(HEADER + ",speed\n0,0,0,1,,,,1\n").find("speed is not known"), std::string::npos);
  EXPECT_EQ(faultOf(HEADER + "\n0,0,0,1,,,\n1,0,,1,,,\n"),
            "line 3: vessel_x, y and z must all be there, or x and y be empty, or all");
  EXPECT_EQ(faultOf(HEADER + ",direction_x\n0,0,0,1,1,2,3,\n"),
            "line 1: column direction_y is missing beside its companions");
  EXPECT_NE(faultOf(HEADER + ",direction_x,direction_y,direction_z\n0,0,0,1,1,2,3,0,0,0\n").find("not zero"),
            std::string::npos);
  EXPECT_EQ(faultOf(HEADER + "\n0,,,,1,2,3\n"), "line 2: the first row must have the vessel's position");
  EXPECT_EQ(faultOf(HEADER + "\n0,0,0,1,1,2,3\n0,0,0,1,1,2,3\n"),
            "line 3: t does not increase from the row before");
  EXPECT_EQ(faultOf(HEADER + ",vehicle_stddev\n0,0,0,1,1,2,3,-1\n"), "line 2: vehicle_stddev must be > 0 m");
  EXPECT_EQ(faultOf(HEADER + ",vehicle_qx,vehicle_qy,vehicle_qz,vehicle_qw\n0,0,0,1,1,2,3,0,0,0,2\n"),
            "line 2: vehicle_q is not a unit quaternion");
  EXPECT_NE(faultOf(HEADER + ",payout\n0,0,0,1,1,2,3,\n").find("column payout is empty"), std::string::npos);
  EXPECT_NE(faultOf(HEADER + "\n0,0,0,1,1,2,nan\n").find("not finite"), std::string::npos);
  EXPECT_EQ(faultOf(HEADER + "\n0,0,0,1,,,\n"), "");
}

}  // namespace tether_monitor::replay
