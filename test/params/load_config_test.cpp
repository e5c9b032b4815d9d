#include "tether_monitor/params/load_config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tether_monitor/params/reader.h"
#include "tether_monitor/params/yaml_file.h"

namespace tether_monitor::params
{
namespace
{
Value::Map tetherKeys()
{
  return {{"length", 400.0},         {"elements", 50.0},          {"diameter", 0.03},
          {"mass_per_length", 1.43}, {"axial_stiffness", 6.75e7}, {"drag_normal", 1.35},
          {"drag_tangential", 0.04}, {"working_load", 2.0e4},     {"breaking_load", 6.0e4}};
}
Value tree(const Value::Map& tether, Value::Map more = {})
{
  more["tether"] = Value(tether);
  return Value(more);
}
std::vector<std::string> faultsOf(const Value& value)
{
  try
  {
    loadConfig(value, "/test");
    return {};
  }
  catch (const ParamError& error)
  {
    return error.faults();
  }
}
}  // namespace

TEST(LoadConfig, DefaultsAreInPlace)
{
  const monitor::Config c = loadConfig(tree(tetherKeys()), "/test");
  EXPECT_EQ(c.world_frame, "map");
  EXPECT_EQ(c.environment.water_density, 1025.0);
  EXPECT_EQ(c.environment.gravity, 9.81);
  EXPECT_EQ(c.elements, 50);
  EXPECT_EQ(c.tether.added_mass_normal, 1.0);
  EXPECT_EQ(c.tether.bending_stiffness, 0.0);
  EXPECT_EQ(c.rate, 20.0);
  EXPECT_EQ(c.pose_timeout, 1.0);
  EXPECT_EQ(c.invalid_timeout, 5.0);
  EXPECT_EQ(*c.alarms.over_tension.warning, 0.8);
  EXPECT_TRUE(c.alarms.over_tension.timing.latch);
}

TEST(LoadConfig, EveryRequiredKeyIsMissedByName)
{
  for (const auto& [key, value] : tetherKeys())
  {
    Value::Map keys = tetherKeys();
    keys.erase(key);
    EXPECT_EQ(faultsOf(tree(keys)), std::vector<std::string>{"tether." + key + " is missing"});
  }
}

TEST(LoadConfig, AllFaultsAreListedAtOnce)
{
  Value::Map keys = tetherKeys();
  keys["axial_stiffness"] = std::string("stiff");
  keys["drag_tangental"] = 0.1;
  keys["working_load"] = 1.0e5;
  const std::vector<std::string> faults = faultsOf(tree(keys, {{"monitor", Value(Value::Map{{"rate", 0.0}})}}));
  ASSERT_EQ(faults.size(), 4u);
  EXPECT_EQ(faults[0], "tether.axial_stiffness = 'stiff' is not a number");
  EXPECT_EQ(faults[1], "tether.drag_tangental is not a known parameter");
  EXPECT_EQ(faults[2], "tether.working_load = 100000 (must be > 0 N and <= breaking_load)");
  EXPECT_EQ(faults[3].find("monitor.rate = 0"), 0u);
}

TEST(LoadConfig, ANumberWrittenAsATextIsANumber)
{
  Value::Map keys = tetherKeys();
  keys["axial_stiffness"] = std::string("1e6");
  EXPECT_EQ(loadConfig(tree(keys), "/test").tether.axial_stiffness, 1.0e6);
  for (const char* word : {"1e6x", "", "nan", "inf", "0x10", "1 2"})
  {
    keys["axial_stiffness"] = std::string(word);
    EXPECT_EQ(faultsOf(tree(keys)).size(), 1u) << word;
  }
}

TEST(LoadConfig, WhatIsNotBuiltYetIsFineWhileNeutralAndAFaultElse)
{
  Value::Map keys = tetherKeys();
  keys["sections"] = Value::List{};
  keys["hydrostatic_compression"] = 0.0;
  Value::Map sea{{"wind", Value::List{0.0, 0.0, 0.0}},
                 {"waves", Value::Map{{"amplitude", 0.0}, {"length", 100.0}}}};
  EXPECT_TRUE(faultsOf(tree(keys, {{"environment", Value(sea)}})).empty());
  sea["waves"] = Value::Map{{"amplitude", 1.0}};
  keys["hydrostatic_compression"] = 1e-4;
  EXPECT_EQ(faultsOf(tree(keys, {{"environment", Value(sea)}})),
            (std::vector<std::string>{"environment.waves.amplitude = 1 asks for what is not built yet",
                                      "tether.hydrostatic_compression = 0.0001 asks for what is not built yet"}));
}

TEST(LoadConfig, SectionsTakeFromTheTetherWhatTheyDoNotSay)
{
  Value::Map keys = tetherKeys();
  keys["sections"] = Value::List{Value(Value::Map{{"from", 0.0}, {"to", 100.0}, {"diameter", 0.05}})};
  keys["attachments"] = Value::List{
      Value(Value::Map{{"name", std::string("float")}, {"s", 200.0}, {"mass", 5.0}, {"volume", 0.02}})};
  const monitor::Config c = loadConfig(tree(keys), "/test");
  ASSERT_EQ(c.fittings.sections.size(), 1u);
  EXPECT_EQ(c.fittings.sections[0].properties.diameter, 0.05);
  EXPECT_EQ(c.fittings.sections[0].properties.mass_per_length, 1.43);
  ASSERT_EQ(c.fittings.attachments.size(), 1u);
  EXPECT_EQ(c.fittings.attachments[0].name, "float");
  EXPECT_EQ(c.fittings.attachments[0].volume, 0.02);

  keys["sections"] = Value::List{Value(Value::Map{{"from", 0.0}, {"to", 500.0}, {"diametre", 0.05}})};
  EXPECT_EQ(faultsOf(tree(keys)), (std::vector<std::string>{"tether.sections[0].diametre is not a known parameter",
                                                            "tether.sections[0].to = 500 (must be <= length)"}));
}

TEST(LoadConfig, AFreeVehicleNeedsItsBody)
{
  EXPECT_TRUE(
      faultsOf(tree(tetherKeys(), {{"vehicle", Value(Value::Map{{"mode", std::string("tracked")}})}})).empty());
  const auto faults = faultsOf(
      tree(tetherKeys(), {{"vehicle", Value(Value::Map{{"mode", std::string("free")}, {"mass", -1.0}})}}));
  EXPECT_EQ(faults,
            (std::vector<std::string>{"vehicle.volume is missing", "vehicle.inertia is missing",
                                      "vehicle.drag_area is missing", "vehicle.mass = -1 (must be > 0 kg)"}));
  EXPECT_EQ(faultsOf(tree(tetherKeys(), {{"vehicle", Value(Value::Map{{"mode", std::string("loose")}})}})),
            std::vector<std::string>{"vehicle.mode = 'loose' (must be tracked or free)"});
}

TEST(LoadConfig, KeysOfRosItselfAreAllowed)
{
  EXPECT_TRUE(faultsOf(tree(tetherKeys(), {{"diagnostic_period", Value(1.0)}})).empty());
}

TEST(LoadConfig, WrongShapesAreNamed)
{
  EXPECT_EQ(faultsOf(tree(tetherKeys(), {{"solver", Value(3.0)}})),
            std::vector<std::string>{"solver = 3 is not a map of keys"});
  EXPECT_EQ(
      faultsOf(tree(tetherKeys(), {{"vessel", Value(Value::Map{{"attachment", Value(Value::List{1.0, 2.0})}})}})),
      std::vector<std::string>{"vessel.attachment = a list is not a list of three numbers"});
  Value::Map keys = tetherKeys();
  keys["elements"] = 2.7;
  EXPECT_EQ(faultsOf(tree(keys)), std::vector<std::string>{"tether.elements = 2.7 is not a whole number"});
  keys["elements"] = true;
  EXPECT_EQ(faultsOf(tree(keys)), std::vector<std::string>{"tether.elements = true is not a number"});
}

TEST(LoadConfig, ACurrentOutOfOrderIsNamed)
{
  const Value::List zero{0.0, 0.0, 0.0};
  const Value::List list{Value(Value::Map{{"depth", 10.0}, {"velocity", zero}}),
                         Value(Value::Map{{"depth", 5.0}, {"velocity", zero}})};
  const auto faults = faultsOf(tree(tetherKeys(), {{"environment", Value(Value::Map{{"current", list}})}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].find("environment.current[1].depth = 5"), 0u) << faults[0];
}

TEST(LoadConfig, EveryShippedConfigurationLoads)
{
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(PROJECT_DIR) + "/config"))
  {
    ++files;
    EXPECT_NO_THROW(loadConfig(readYamlFile(entry.path()), entry.path())) << entry.path();
  }
  EXPECT_GT(files, 0);
}

class YamlFile : public ::testing::Test
{
 protected:
  std::string write(const std::string& text)
  {
    const std::string path = ::testing::TempDir() + "tether_monitor_params.yaml";
    std::ofstream(path) << text;
    return path;
  }
};

TEST_F(YamlFile, IsReadAsTheParameterServerHasIt)
{
  const Value value = readYamlFile(write("a: 1e6\nb: [1, 2.5]\nc: {d: true, e: word}\n"));
  const Value::Map& map = *value.get<Value::Map>();
  EXPECT_EQ(*map.at("a").get<std::string>(), "1e6");
  EXPECT_EQ(map.at("b").get<Value::List>()->size(), 2u);
  EXPECT_TRUE(*map.at("c").get<Value::Map>()->at("d").get<bool>());
}

TEST_F(YamlFile, FaultsNameFileAndLine)
{
  EXPECT_THROW(readYamlFile("/nowhere/at/all.yaml"), std::runtime_error);
  for (const char* text : {"a: [1, 2\nb: 3\n", "a: 1\nb: 2\na: 3\n"})
  {
    try
    {
      readYamlFile(write(text));
      ADD_FAILURE() << "accepted " << text;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find("tether_monitor_params.yaml"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("line"), std::string::npos) << error.what();
    }
  }
}

}  // namespace tether_monitor::params
