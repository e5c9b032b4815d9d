#include "tether_monitor/core/base/binary_archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace tether_monitor::core
{
namespace
{
enum class Colour
{
  RED = 7,
  BLUE = -3
};

struct Part
{
  double number = 0.0;
  Colour colour = Colour::RED;
  std::optional<int> count;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(number, colour, count);
  }
};

struct Whole
{
  bool flag = false;
  std::string text;
  std::vector<Part> parts;
  std::array<float, 2> pair{};
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  std::optional<double> none = 1.0;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(flag, text, parts, pair, vector, attitude, none);
  }
};

Whole example()
{
  Whole x;
  x.flag = true;
  x.text = std::string("a\0b", 3);
  x.parts = {{-0.0, Colour::BLUE, 12}, {std::numeric_limits<double>::denorm_min(), Colour::RED, std::nullopt}};
  x.pair = {1.5f, -2.25f};
  x.vector = {0.1, INFINITY, NAN};
  x.attitude = {0.5, -0.5, 0.5, -0.5};
  x.none.reset();
  return x;
}

std::vector<std::uint8_t> bytesOf(const Whole& x)
{
  BinaryWriter writer;
  writer(x);
  return writer.bytes();
}
}  // namespace

TEST(BinaryArchive, EverythingComesBackBitForBit)
{
  const std::vector<std::uint8_t> bytes = bytesOf(example());
  Whole back;
  BinaryReader reader(bytes);
  reader(back);
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(bytesOf(back), bytes);
  EXPECT_TRUE(back.flag);
  EXPECT_EQ(back.text, std::string("a\0b", 3));
  ASSERT_EQ(back.parts.size(), 2u);
  EXPECT_TRUE(std::signbit(back.parts[0].number));
  EXPECT_EQ(back.parts[0].colour, Colour::BLUE);
  EXPECT_EQ(back.parts[0].count, 12);
  EXPECT_EQ(back.parts[1].number, std::numeric_limits<double>::denorm_min());
  EXPECT_FALSE(back.parts[1].count);
  EXPECT_EQ(back.pair[1], -2.25f);
  EXPECT_TRUE(std::isinf(back.vector.y()) && std::isnan(back.vector.z()));
  EXPECT_EQ(back.attitude.coeffs(), example().attitude.coeffs());
  EXPECT_FALSE(back.none);
}

TEST(BinaryArchive, BytesThatAreTooFewOrTooManyAreNoticed)
{
  std::vector<std::uint8_t> bytes = bytesOf(example());
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    const std::vector<std::uint8_t> part(bytes.begin(), bytes.begin() + static_cast<long>(size));
    Whole back;
    BinaryReader reader(part);
    reader(back);
    EXPECT_FALSE(reader.ok()) << size;
    EXPECT_FALSE(reader.finished()) << size;
  }
  bytes.push_back(0);
  Whole back;
  BinaryReader reader(bytes);
  reader(back);
  EXPECT_TRUE(reader.ok());
  EXPECT_FALSE(reader.finished()) << "one is left";
}

TEST(BinaryArchive, ACountThatCannotBeTakesNoMemory)
{
  BinaryWriter writer;
  writer(std::uint64_t{1} << 61, 1.0);
  std::vector<double> numbers;
  BinaryReader reader(writer.bytes());
  reader(numbers);
  EXPECT_FALSE(reader.ok());
  EXPECT_TRUE(numbers.empty());
}

TEST(BinaryArchive, ABoolIsZeroOrOne)
{
  const std::vector<std::uint8_t> bytes{1, 0, 2};
  bool first = false, second = true, third = true;
  BinaryReader reader(bytes);
  reader(first, second);
  EXPECT_TRUE(reader.ok() && first && !second);
  reader(third);
  EXPECT_FALSE(reader.ok());
}

TEST(Checksum, IsThatOfFowlerNollAndVo)
{
  EXPECT_EQ(checksum({}), 0xcbf29ce484222325ull);
  EXPECT_EQ(checksum({'a'}), 0xaf63dc4c8601ec8cull);
  EXPECT_EQ(checksum({'f', 'o', 'o', 'b', 'a', 'r'}), 0x85944171f73967e8ull);
}

TEST(Checksum, FindsEveryChangedBitAndLeavesTheContent)
{
  const std::vector<std::uint8_t> content{1, 2, 3, 0, 255};
  std::vector<std::uint8_t> whole = content;
  appendChecksum(whole);
  ASSERT_EQ(whole.size(), content.size() + 8);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit)
  {
    std::vector<std::uint8_t> changed = whole;
    changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ (1u << bit % 8));
    EXPECT_FALSE(verifyChecksum(changed)) << bit;
  }
  EXPECT_TRUE(verifyChecksum(whole));
  EXPECT_EQ(whole, content);
  std::vector<std::uint8_t> few(7, 0);
  EXPECT_FALSE(verifyChecksum(few));
}
}  // namespace tether_monitor::core
