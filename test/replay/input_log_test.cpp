#include "tether_monitor/replay/input_log.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/text_files.h"
#include "tether_monitor/files/csv_writer.h"

namespace tether_monitor::replay
{
TEST(InputLog, SumsUpTopicsByTenSeconds)
{
  InputLog log;
  EXPECT_TRUE(log.empty());
  for (int i = 0; i < 15; ++i)
    log.add(i, "vehicle/pose", 0.5, i == 3);
  log.add(4.0, "vessel/pose", 0.0, false);
  log.add(std::nan(""), "vessel/pose", 0.0, false);
  log.add(19.0, "vehicle/pose", 1.5, true);
  const std::string folder = ownFile("folder");
  files::makeFolder(folder);
  log.write(folder);
  EXPECT_EQ(textOf(folder + "/inputs.csv"),
            "t,topic,messages,refused,delay,longest_gap\n"
            "0,vehicle/pose,10,1,0.5,1\n"
            "0,vessel/pose,1,0,0,0\n"
            "10,vehicle/pose,6,1,0.6666666667,5\n");
}

}  // namespace tether_monitor::replay
