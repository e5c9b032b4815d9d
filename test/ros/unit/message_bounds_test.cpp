#include "tether_monitor/ros/message_bounds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor
{
TEST(MessageBounds, TheTableIsInTheOrderOfItsFields)
{
  for (std::size_t i = 0; i < fieldBounds().size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(fieldBounds()[i].field), i) << fieldBounds()[i].name;
}

TEST(MessageBounds, EveryFieldHasALargestNumber)
{
  for (const FieldBound& bound : fieldBounds())
  {
    EXPECT_EQ(outOfBounds(bound.field, bound.most), std::nullopt) << bound.name;
    EXPECT_EQ(outOfBounds(bound.field, -bound.most), std::nullopt) << bound.name;
    for (const double x : {1.01 * bound.most, -1.01 * bound.most, 1e300})
    {
      const std::optional<InputError> error = outOfBounds(bound.field, x);
      ASSERT_TRUE(error) << bound.name;
      EXPECT_NE(error->find(bound.name), std::string::npos) << *error;
    }
    for (const double x : {NAN, INFINITY, -INFINITY})
      EXPECT_TRUE(outOfBounds(bound.field, x)) << bound.name;
  }
}

TEST(MessageBounds, WhatWasNotMeasuredMayBeAnything)
{
  monitor::MeasuredVector height(core::Vector3(NAN, 0.0, 2.0));
  EXPECT_TRUE(outOfBounds(Field::POSITION, height));
  height.setNotMeasured(0);
  EXPECT_FALSE(outOfBounds(Field::POSITION, height));
}

}  // namespace tether_monitor
