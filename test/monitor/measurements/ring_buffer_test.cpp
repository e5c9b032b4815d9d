#include "tether_monitor/monitor/measurements/ring_buffer.h"

#include <gtest/gtest.h>

#include "tether_monitor/core/base/binary_archive.h"

namespace tether_monitor::monitor
{
namespace
{
std::vector<int> contentOf(const RingBuffer<int>& buffer)
{
  std::vector<int> content;
  for (std::size_t i = 0; i < buffer.size(); ++i)
    content.push_back(buffer[i]);
  return content;
}

RingBuffer<int> filled(int count)
{
  RingBuffer<int> buffer(3);
  for (int i = 1; i <= count; ++i)
    buffer.emplaceBack() = i;
  return buffer;
}
}  // namespace

TEST(RingBuffer, HoldsTheLastOnesOldestFirst)
{
  EXPECT_TRUE(RingBuffer<int>(3).empty());
  EXPECT_EQ(contentOf(filled(2)), (std::vector<int>{1, 2}));
  EXPECT_EQ(contentOf(filled(3)), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(contentOf(filled(5)), (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(filled(5).front(), 3);
  EXPECT_EQ(filled(5).back(), 5);
  EXPECT_EQ(filled(5).capacity(), 3u);
}

TEST(RingBuffer, ForgetsAtEitherEnd)
{
  RingBuffer<int> buffer = filled(5);
  buffer.popFront();
  EXPECT_EQ(contentOf(buffer), (std::vector<int>{4, 5}));
  buffer.resizeTo(7);
  EXPECT_EQ(buffer.size(), 2u) << "it does not grow";
  buffer.resizeTo(1);
  EXPECT_EQ(contentOf(buffer), std::vector<int>{4});
  buffer.emplaceBack() = 9;
  EXPECT_EQ(contentOf(buffer), (std::vector<int>{4, 9}));
  buffer.clear();
  EXPECT_TRUE(buffer.empty());
}

TEST(RingBuffer, TheOneThatComesGetsTheMemoryOfTheOneThatGoes)
{
  RingBuffer<std::vector<int>> buffer(2);
  buffer.emplaceBack().assign(100, 1);
  buffer.emplaceBack().assign(50, 2);
  const int* memory = buffer.front().data();
  EXPECT_EQ(buffer.emplaceBack().data(), memory);
  EXPECT_EQ(buffer.back().size(), 100u);
  EXPECT_EQ(buffer.front().size(), 50u);
}

TEST(RingBuffer, ComesBackFromAnArchiveAndKnowsItsCapacity)
{
  core::BinaryWriter writer;
  writer(filled(5));
  core::BinaryReader reader(writer.bytes());
  RingBuffer<int> back(1);
  reader(back);
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(contentOf(back), (std::vector<int>{3, 4, 5}));
  EXPECT_TRUE(back.isValid(3));
  EXPECT_FALSE(back.isValid(4));
}
}  // namespace tether_monitor::monitor
