#include "tether_monitor/monitor/vessel/position_window.h"

#include <gtest/gtest.h>

#include "tether_monitor/core/base/binary_archive.h"

namespace tether_monitor::monitor
{
namespace
{
std::vector<std::uint8_t> bytesOf(const std::vector<TrackSample>& samples)
{
  PositionWindow window;
  for (const TrackSample& sample : samples)
    window.add(sample);
  core::BinaryWriter writer;
  writer(window);
  return writer.bytes();
}
}  // namespace

TEST(PositionWindow, SpansWhatIsNotTooOld)
{
  PositionWindow window;
  EXPECT_TRUE(window.empty());
  EXPECT_LT(window.span(0.0), 0.0);
  for (int i = 0; i <= 40; ++i)
    window.add({0.125 * i, 0.0, 0.1});
  EXPECT_EQ(window.span(5.0), 5.0);
  EXPECT_EQ(window.span(22.0), 3.0) << "two seconds are too old";
  EXPECT_LT(window.span(26.0), 0.0);
  window.clear();
  EXPECT_TRUE(window.empty());
}

TEST(PositionWindow, OfTwoThatComeTooCloseTheBetterStays)
{
  const TrackSample first{1.0, 5.0, 0.3}, better{1.01, 6.0, 0.1}, worse{1.01, 7.0, 0.5}, late{1.1, 8.0, 0.5};
  EXPECT_EQ(bytesOf({first, better}), bytesOf({better}));
  EXPECT_EQ(bytesOf({first, worse}), bytesOf({first}));
  EXPECT_EQ(bytesOf({first, late, better}), bytesOf({first, late})) << "not in order";
  EXPECT_NE(bytesOf({first, late}), bytesOf({first}));
}

TEST(PositionWindow, HoldsTwentySecondsHoweverFastTheyCome)
{
  PositionWindow window;
  for (int i = 0; i <= 40000; ++i)
    window.add({1e-3 * i, 3.0 + 0.5e-3 * i, 0.01});
  EXPECT_TRUE(window.isValid());
  EXPECT_LE(window.span(40.0), PositionWindow::MEMORY);
  EXPECT_GT(window.span(40.0), PositionWindow::MEMORY - 1.0);
  const TrackFit fit = window.fit(40.0, false, uniformWavePrior());
  EXPECT_NEAR(fit.position, 23.0, 0.01);
  EXPECT_NEAR(fit.velocity, 0.5, 0.005);
}
}  // namespace tether_monitor::monitor
