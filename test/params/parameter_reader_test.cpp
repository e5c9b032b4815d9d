#include "tether_monitor/params/parameter_reader.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::params
{
namespace
{
using Errors = std::vector<std::string>;

Value list(const std::vector<double>& numbers)
{
  return Value::List(numbers.begin(), numbers.end());
}
}  // namespace

TEST(ParameterReader, ReadsNumbersHoweverTheyAreWritten)
{
  const Value tree(Value::Map{{"real", 2.5}, {"whole", 3L}, {"text", std::string("1e6")}, {"flag", true}});
  ParameterReader reader(tree);
  EXPECT_EQ(reader.number("real"), 2.5);
  EXPECT_EQ(reader.number("whole"), 3.0);
  EXPECT_EQ(reader.number("text"), 1e6);
  EXPECT_EQ(reader.integer("whole"), 3);
  EXPECT_EQ(reader.number("none", 7.0), 7.0);
  EXPECT_FALSE(reader.optionalNumber("none"));
  EXPECT_TRUE(reader.boolean("flag", false));
  EXPECT_TRUE(reader.errors().empty());
}

TEST(ParameterReader, CollectsEveryErrorWithThePathOfItsKey)
{
  const Value tree(Value::Map{
      {"tether", Value::Map{{"length", std::string("long")}, {"elements", 2.5}}},
      {"items", Value::List{Value::Map{{"mass", std::string("nan")}}, Value::Map{}}},
  });
  ParameterReader reader(tree);
  ParameterReader tether = reader.child("tether");
  EXPECT_TRUE(std::isnan(tether.number("length")));
  EXPECT_EQ(tether.integer("elements"), 1);
  EXPECT_TRUE(std::isnan(tether.number("diameter")));
  std::vector<ParameterReader> items = reader.list("items");
  ASSERT_EQ(items.size(), 2u);
  for (ParameterReader& item : items)
    EXPECT_EQ(item.number("mass", 4.0), 4.0);
  EXPECT_TRUE(std::isnan(items[1].number("mass")));
  EXPECT_EQ(reader.errors(), (Errors{"tether.length = 'long' is not a number",
                                     "tether.elements = 2.5 is not a whole number", "tether.diameter is missing",
                                     "items[0].mass = 'nan' is not a number", "items[1].mass is missing"}));
}

TEST(ParameterReader, EveryKeyMustBeAskedFor)
{
  const Value tree(Value::Map{{"a", 1.0}, {"b", 2.0}, {"c", 3.0}});
  ParameterReader reader(tree);
  reader.number("a");
  reader.ignore("b");
  EXPECT_TRUE(reader.has("c")) << "a look is no question";
  reader.finish();
  EXPECT_EQ(reader.errors(), Errors{"c is not a known parameter"});
}

TEST(ParameterReader, AVectorIsAListOrNamesItsAxes)
{
  const Value axes(Value::Map{{"z", 3.0}, {"x", 1.0}, {"y", 2.0}});
  const Value tree(Value::Map{{"list", list({1.0, 2.0, 3.0})}, {"axes", axes}, {"short", list({1.0, 2.0})}});
  ParameterReader reader(tree);
  EXPECT_EQ(reader.vector("list"), core::Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(reader.vector("axes"), core::Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(reader.vector2("short"), core::Vector3(1.0, 2.0, 0.0));
  EXPECT_TRUE(reader.errors().empty());
  EXPECT_EQ(reader.vector("short", core::Vector3::Ones()), core::Vector3::Ones());
  ASSERT_EQ(reader.errors().size(), 1u);
  EXPECT_NE(reader.errors()[0].find("is not a list of three numbers"), std::string::npos) << reader.errors()[0];
}
}  // namespace tether_monitor::params
