#include "tether_monitor/monitor/ensemble/load_cell_record.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
// Ten readings a second of a tension in waves; the members are 10 % above it and 20 % below, and in phase with it.
LoadCellRecord read(double seconds, double mean)
{
  LoadCellRecord record(2);
  for (double t = 0.0; t < seconds; t += 0.1)
  {
    const double tension = mean * (1.0 + 0.3 * std::sin(t));
    record.add(t, tension, 100.0, Eigen::RowVector2d(1.1 * tension, 0.8 * tension));
  }
  return record;
}
}  // namespace

TEST(LoadCellRecord, KnowsWhatIsMeasuredOfWhatMembersHave)
{
  const LoadCellRecord record = read(60.0, 1000.0);
  EXPECT_NEAR(record.ratio(0, 0.0, 10.0, 60.0), 1.0 / 1.1, 1e-3);
  EXPECT_NEAR(record.ratio(1, 0.0, 10.0, 60.0), 1.0 / 0.8, 1e-3);
  EXPECT_NEAR(record.ratio(0, 100.0, 10.0, 60.0), 0.9 / 1.1, 0.02) << "the bias is none of the tether's";
  EXPECT_EQ(record.tension(), read(60.0, 1000.0).tension());
}

TEST(LoadCellRecord, TellsNothingOfWhatIsShortOldOrSmall)
{
  EXPECT_EQ(LoadCellRecord(2).ratio(0, 0.0, 10.0, 0.0), 1.0);
  EXPECT_EQ(read(9.0, 1000.0).ratio(0, 0.0, 10.0, 9.0), 1.0);
  EXPECT_EQ(read(60.0, 1000.0).ratio(0, 0.0, 10.0, 121.0), 1.0);
  EXPECT_NEAR(read(60.0, 1.0).ratio(1, 0.0, 100.0, 60.0), 1.0, 1e-3) << "a slack tether";
  EXPECT_EQ(read(60.0, 1000.0).ratio(0, -5000.0, 10.0, 60.0), 2.0);
}
}  // namespace tether_monitor::monitor
