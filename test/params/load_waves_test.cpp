#include "tether_monitor/params/load_waves.h"

#include <gtest/gtest.h>

namespace tether_monitor::params
{
namespace
{
struct Loaded
{
  core::SeaState waves;
  std::vector<std::string> errors;
};

Loaded load(const Value& waves)
{
  const Value tree(Value::Map{{"waves", waves}});
  ParameterReader reader(tree);
  Loaded loaded;
  loaded.waves = loadWaves(reader);
  loaded.errors = reader.errors();
  return loaded;
}
}  // namespace

TEST(LoadWaves, OneWave)
{
  const Loaded one = load(Value::Map{{"amplitude", 1.5}, {"length", 90.0}, {"stretching", std::string("none")}});
  EXPECT_TRUE(one.errors.empty());
  ASSERT_EQ(one.waves.components.size(), 1u);
  EXPECT_EQ(one.waves.components[0].length, 90.0);
  EXPECT_EQ(one.waves.stretching, core::WaveStretching::NONE);
}

TEST(LoadWaves, AList)
{
  const Value::Map swell{{"amplitude", 1.0}, {"length", 150.0}}, sea{{"amplitude", 0.4}, {"length", 30.0}};
  const Loaded list = load(Value::List{Value(swell), Value(sea)});
  EXPECT_TRUE(list.errors.empty());
  ASSERT_EQ(list.waves.components.size(), 2u);
  EXPECT_EQ(list.waves.components[1].amplitude, 0.4);
}

TEST(LoadWaves, ASpectrumWithItsDefaults)
{
  const Loaded sea = load(Value::Map{
      {"spectrum", std::string("jonswap")}, {"significant_height", 2.5}, {"peak_period", 8.0}, {"seed", 7L}});
  EXPECT_TRUE(sea.errors.empty());
  ASSERT_TRUE(sea.waves.spectrum);
  EXPECT_TRUE(sea.waves.components.empty());
  EXPECT_EQ(sea.waves.spectrum->significant_height, 2.5);
  EXPECT_EQ(sea.waves.spectrum->gamma, 3.3);
  EXPECT_EQ(sea.waves.spectrum->components, 100);
  EXPECT_EQ(sea.waves.spectrum->seed, 7);
}

TEST(LoadWaves, FaultsAreNamed)
{
  EXPECT_EQ(load(Value::Map{{"spectrum", std::string("ochi")}}).errors.size(), 3u) << "word, height, period";
  EXPECT_EQ(load(Value::Map{{"stretching", std::string("delta")}}).errors.size(), 1u);
  const Value::Map one{{"amplitude", 1.0}}, other{{"amplitude", 1.0}, {"stretching", std::string("none")}};
  EXPECT_EQ(load(Value::List{Value(one), Value(other)}).errors.size(), 1u);
  EXPECT_EQ(load(Value::Map{{"spectrum", std::string("jonswap")},
                            {"significant_height", 2.5},
                            {"peak_period", 8.0},
                            {"amplitude", 1.0}})
                .errors.size(),
            1u)
      << "a spectrum has no amplitude";
}

}  // namespace tether_monitor::params
