#include "tether_monitor/monitor/estimator/cloned_pointer.h"

#include <gtest/gtest.h>

#include "tether_monitor/core/base/binary_archive.h"

namespace tether_monitor::monitor
{
namespace
{
struct Counter
{
  virtual ~Counter() = default;
  virtual std::unique_ptr<Counter> clone() const = 0;
  virtual int next() = 0;
  virtual void write(core::BinaryWriter& to) const = 0;
  virtual void read(core::BinaryReader& from) = 0;
};

struct ByTwo final : Counter
{
  std::unique_ptr<Counter> clone() const override { return std::make_unique<ByTwo>(*this); }
  int next() override { return count += 2; }
  void write(core::BinaryWriter& to) const override { to(count); }
  void read(core::BinaryReader& from) override { from(count); }

  int count = 0;
};

using Pointer = ClonedPointer<Counter>;
}  // namespace

TEST(ClonedPointer, ACopyHasAnObjectOfItsOwn)
{
  Pointer first(std::make_unique<ByTwo>());
  first->next();
  Pointer second = first;
  EXPECT_NE(&*first, &*second);
  EXPECT_EQ(second->next(), 4) << "it goes on from there";
  EXPECT_EQ(second->next(), 6);
  EXPECT_EQ(first->next(), 4) << "and leaves the other alone";
}

TEST(ClonedPointer, AssigningCopiesToo)
{
  Pointer first(std::make_unique<ByTwo>()), second(std::make_unique<ByTwo>());
  first->next();
  second = first;
  EXPECT_EQ(second->next(), 4);
  EXPECT_EQ(first->next(), 4);
  Pointer& itself = first;
  first = itself;
  EXPECT_EQ(first->next(), 6);
}

TEST(ClonedPointer, MovingKeepsTheObject)
{
  Pointer first(std::make_unique<ByTwo>());
  const Counter* object = &*first;
  const Pointer second = std::move(first);
  EXPECT_EQ(&*second, object);
}

TEST(ClonedPointer, WritesAndReadsItsObject)
{
  Pointer first(std::make_unique<ByTwo>()), second(std::make_unique<ByTwo>());
  first->next();
  core::BinaryWriter writer;
  writer(first);
  core::BinaryReader reader(writer.bytes());
  reader(second);
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(second->next(), 4);
}
}  // namespace tether_monitor::monitor
