#include "tether_monitor/monitor/estimate/status.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>

namespace tether_monitor::monitor
{
namespace
{
// The constants of TetherState.msg whose names begin with `prefix`, by number.
std::map<int, std::string> constants(const std::string& prefix)
{
  std::ifstream in(PROJECT_DIR "/msg/TetherState.msg");
  const std::regex constant("uint8 " + prefix + "_(\\w+) *= *(\\d+).*");
  std::map<int, std::string> found;
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_match(line, match, constant))
      found[std::stoi(match[2])] = match[1];
  return found;
}
}  // namespace

TEST(Status, NumbersAndWordsAreThoseOfTheMessage)
{
  const std::map<int, std::string> known = constants("STATUS");
  ASSERT_EQ(known.size(), 4u);
  for (const auto& [number, word] : known)
    EXPECT_EQ(describe(static_cast<Status>(number)), word);
  EXPECT_STREQ(describe(static_cast<Status>(4)), "UNKNOWN");
}

TEST(Reason, NumbersAndWordsAreThoseOfTheMessage)
{
  const std::map<int, std::string> known = constants("REASON");
  ASSERT_EQ(known.size(), static_cast<std::size_t>(Reason::COUNT));
  for (const auto& [number, word] : known)
    EXPECT_EQ(describe(static_cast<Reason>(number)), word);
  EXPECT_STREQ(describe(Reason::COUNT), "UNKNOWN");
}

TEST(ReasonSet, NamesTheGravestOfAll)
{
  ReasonSet reasons;
  EXPECT_EQ(reasons.gravest(), Reason::NONE);
  reasons.add(Reason::NONE);
  EXPECT_TRUE(reasons.isEmpty());
  // Every reason is in the order: alone, it is the gravest.
  for (int number = 1; number < static_cast<int>(Reason::COUNT); ++number)
  {
    ReasonSet one;
    one.add(static_cast<Reason>(number));
    EXPECT_EQ(one.gravest(), static_cast<Reason>(number));
    EXPECT_EQ(one.bits(), 1u << number);
    reasons.add(static_cast<Reason>(number));
  }
  EXPECT_EQ(reasons.gravest(), Reason::CLOCK_JUMP);
}

TEST(Reason, EachHasAdviceOfItsOwn)
{
  std::map<std::string, int> told;
  for (int number = 1; number < static_cast<int>(Reason::COUNT); ++number)
  {
    const std::string sentence = advice(static_cast<Reason>(number));
    ASSERT_FALSE(sentence.empty()) << number;
    EXPECT_EQ(sentence.back(), '.') << sentence;
    EXPECT_EQ(++told[sentence], 1) << sentence;
  }
  EXPECT_STREQ(advice(Reason::NONE), "");
}
}  // namespace tether_monitor::monitor
