// Counts what the stepping path takes from the heap, by replacing operator new for this executable.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "monitor/support.h"

namespace
{
long allocations = 0;

void* counted(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size)
{
  return counted(size);
}
void* operator new[](std::size_t size)
{
  return counted(size);
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace tether_monitor::monitor
{
TEST(Allocation, TheCounterCounts)
{
  const long before = allocations;
  std::vector<double> some(10);
  EXPECT_GT(allocations, before);
}

TEST(Allocation, ATickTakesNothingFromTheHeapAfterTheStart)
{
  Feeder feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.vehicle_velocity = {0.5, 0.3, -0.2};  // taut, alarms and all
  const long before = allocations;
  feeder.run(60.0);
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(feeder.estimator.overTension()) << "it did something";
}

}  // namespace tether_monitor::monitor
