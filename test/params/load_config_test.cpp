#include "tether_monitor/params/load_config.h"
#include "tether_monitor/files/depth_grid_file.h"
#include "tether_monitor/params/load_simulation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "support/config_trees.h"
#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/params/yaml_file.h"

namespace tether_monitor::params
{
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
  EXPECT_EQ(*c.alarms.at("over_tension").warning, 0.8);
  EXPECT_TRUE(c.alarms.at("over_tension").timing.latch);
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

TEST(LoadConfig, ReadsTheWholeSea)
{
  const Value::Map waves{{"amplitude", 1.5}, {"length", 90.0}, {"direction", 0.3}, {"phase", 0.1}};
  const Value::Map seabed{{"depth", 120.0}, {"slope", Value::List{0.01, 0.02}}, {"friction", 0.4}};
  const Value::Map pipe{{"name", std::string("pipe")},
                        {"shape", std::string("cylinder")},
                        {"pose", Value::Map{{"position", Value::List{1.0, 2.0, -30.0}},
                                            {"orientation", Value::List{0.0, 0.70710678, 0.0, 0.70710678}}}},
                        {"size", Value::List{0.5, 20.0}},
                        {"friction", 0.2}};
  const Value::Map ball{{"shape", 0L},
                        {"pose", Value::Map{{"position", Value::Map{{"x", 1.0}, {"y", 2.0}, {"z", -10.0}}}}},
                        {"size", Value::List{0.7}},
                        {"mass", 30.0},
                        {"stiffness", 1e6}};
  const Value::Map sea{{"waves", waves},
                       {"seabed", seabed},
                       {"wind", Value::List{3.0, 0.0, 0.0}},
                       {"obstacles", Value::List{Value(pipe), Value(ball)}}};
  const monitor::Config c = loadConfig(tree(tetherKeys(), {{"environment", Value(sea)}}), "/test");
  ASSERT_EQ(c.environment.waves.components.size(), 1u);
  EXPECT_EQ(c.environment.waves.components[0].amplitude, 1.5);
  EXPECT_EQ(c.environment.waves.components[0].direction, 0.3);
  ASSERT_TRUE(c.environment.seabed);
  EXPECT_EQ(c.environment.seabed->slope.y(), 0.02);
  EXPECT_EQ(c.environment.seabed->normal_stiffness, 3.0e5) << "default";
  ASSERT_EQ(c.environment.obstacles.size(), 2u);
  EXPECT_EQ(c.environment.obstacles[0].shape, core::ObstacleShape::CYLINDER);
  EXPECT_EQ(c.environment.obstacles[0].size.y(), 20.0);
  EXPECT_NEAR(c.environment.obstacles[0].orientation.y(), 0.7071, 1e-4);
  EXPECT_EQ(c.environment.obstacles[1].shape, core::ObstacleShape::SPHERE);
  EXPECT_EQ(c.environment.obstacles[1].mass, 30.0);
  EXPECT_EQ(c.environment.obstacles[1].position, core::Vector3(1.0, 2.0, -10.0)) << "as a message is written";
  EXPECT_EQ(c.environment.wind.x(), 3.0);
}

TEST(LoadConfig, AClampNeedsADirectionBendingStiffnessAndAHeldEnd)
{
  const Value clamp{Value::List{0.0, 0.0, -1.0}};
  Value::Map stiff = tetherKeys();
  stiff["bending_stiffness"] = 30.0;
  const monitor::Config c = loadConfig(tree(stiff, {{"vessel", Value(Value::Map{{"clamped", clamp}})}}), "/test");
  EXPECT_EQ(c.vessel.clamped, core::Vector3(0.0, 0.0, -1.0));
  EXPECT_FALSE(c.vehicle.clamped);
  EXPECT_EQ(faultsOf(tree(tetherKeys(), {{"vessel", Value(Value::Map{{"clamped", clamp}})}})).size(), 1u);
  const Value nowhere{Value::List{0.0, 0.0, 0.0}};
  EXPECT_EQ(faultsOf(tree(stiff, {{"vehicle", Value(Value::Map{{"clamped", nowhere}})}})).size(), 1u);
  const Value::Map free{
      {"clamped", clamp}, {"mode", std::string("free")},           {"mass", 100.0},
      {"volume", 0.09},   {"inertia", Value::List{5.0, 5.0, 5.0}}, {"drag_area", Value::List{0.1, 0.1, 0.1}}};
  EXPECT_EQ(faultsOf(tree(stiff, {{"vehicle", Value(free)}})).size(), 1u);
}

TEST(LoadConfig, FaultsOfTheSeaNameTheKey)
{
  const Value::Map bad{{"shape", std::string("cone")}, {"pose", Value::Map{}}, {"size", Value::List{1.0, 2.0}}};
  const Value::Map sea{{"waves", Value::Map{{"amplitude", 1.0}, {"heigth", 2.0}}},
                       {"seabed", Value::Map{{"grid", std::string("nowhere.csv")}}},
                       {"obstacles", Value::List{Value(bad)}}};
  const std::vector<std::string> faults = faultsOf(tree(tetherKeys(), {{"environment", Value(sea)}}));
  const auto has = [&](const std::string& text)
  {
    return std::any_of(faults.begin(), faults.end(),
                       [&](const std::string& fault) { return fault.find(text) != std::string::npos; });
  };
  EXPECT_TRUE(has("environment.waves.heigth is not a known parameter"));
  EXPECT_TRUE(has("nowhere.csv"));
  EXPECT_TRUE(has("environment.obstacles[0].shape = 'cone'"));
  EXPECT_TRUE(has("environment.obstacles[0].pose.position is missing"));
  EXPECT_TRUE(has("environment.obstacles[0].size"));
}

TEST(DepthGrid, IsReadInAnyOrderAndItsFaultsAreNamed)
{
  const std::string path = ::testing::TempDir() + "/depths.csv";
  const auto write = [&](const char* text) { std::ofstream(path) << text; };
  write("x,y,depth\n10,5,52\n0,0,50\n10,0,51\n0,5,53\n");
  const core::DepthGrid grid = files::readDepthGrid(path);
  EXPECT_EQ(grid.dx, 10.0);
  EXPECT_EQ(grid.dy, 5.0);
  EXPECT_EQ(grid.depth(1, 0), 51.0);
  EXPECT_EQ(grid.depth(0, 1), 53.0);
  for (const char* bad : {"x,y,depth\n0,0,1\n", "x,y,z\n0,0,1\n1,1,2\n", "x,y,depth\n0,0,1\n1,0,1\n0,1,1\n",
                          "x,y,depth\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n1,1,1\n",
                          "x,y,depth\n0,0,1\n1,0,1\n5,0,1\n0,1,1\n1,1,1\n5,1,1\n", "x,y,depth\n"})
  {
    write(bad);
    EXPECT_THROW(files::readDepthGrid(path), std::runtime_error) << bad;
  }
  EXPECT_THROW(files::readDepthGrid("/nowhere/at/all.csv"), std::runtime_error);
  EXPECT_EQ(files::fileBeside("/config", "grid.csv"), "/config/grid.csv");
  EXPECT_EQ(files::fileBeside("/config", "/data/grid.csv"), "/data/grid.csv");
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
            std::vector<std::string>{"vehicle.mode = 'loose' (must be tracked, free or observed)"});
}

TEST(LoadConfig, AnObservedVehicleHasItsNavigation)
{
  const Value::List three{0.4, 0.4, 0.4};
  Value::Map vehicle{
      {"mode", std::string("observed")}, {"mass", 1000.0},         {"volume", 1.0},  {"inertia", Value(three)},
      {"drag_area", Value(three)},       {"position_stddev", 0.3}, {"latency", 1.5}, {"force_stddev", 250.0}};
  const Value::Map vessel{{"position_stddev", 0.02}};
  const monitor::Config c =
      loadConfig(tree(tetherKeys(), {{"vehicle", Value(vehicle)}, {"vessel", Value(vessel)}}), "/test");
  EXPECT_EQ(c.vehicle_mode, monitor::VehicleMode::OBSERVED);
  EXPECT_EQ(c.navigation.position_stddev, 0.3);
  EXPECT_EQ(c.navigation.latency, 1.5);
  EXPECT_EQ(*c.navigation.force_stddev, 250.0);
  EXPECT_EQ(*c.vessel.position_stddev, 0.02);
  EXPECT_FALSE(c.vessel.velocity_stddev);
  vehicle["position_stddev"] = 0.0;
  vehicle["latency"] = -1.0;
  vehicle["drag_stddev"] = -0.1;
  EXPECT_EQ(faultsOf(tree(tetherKeys(), {{"vehicle", Value(vehicle)}})),
            (std::vector<std::string>{"vehicle.position_stddev = 0 (must be > 0 m)",
                                      "vehicle.latency = -1 (must be >= 0 and <= 30 s)",
                                      "vehicle.drag_stddev = -0.1 (must be > 0 [-])"}));
  vehicle = {{"mode", std::string("tracked")}, {"latency", 1.0}};
  EXPECT_TRUE(faultsOf(tree(tetherKeys(), {{"vehicle", Value(vehicle)}})).empty()) << "a file for another mode";
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
      std::vector<std::string>{"vessel.attachment = a list of 2 is not a list of three numbers"});
  EXPECT_EQ(
      faultsOf(tree(tetherKeys(), {{"environment", Value(Value::Map{{"current", Value(Value::List{0.3})}})}})),
      std::vector<std::string>{"environment.current[0] = 0.3 is not a map of keys, as every entry of this "
                               "list has to be"})
      << "once, and not also for what the entry lacks";
  EXPECT_EQ(faultsOf(tree(tetherKeys(), {{"vehicle", Value(Value::Map{{"mode", Value(std::string("observe"))},
                                                                      {"mass", Value(3.0)}})}})),
            std::vector<std::string>{"vehicle.mode = 'observe' (must be tracked, free or observed)"})
      << "which keys it may have nobody knows then";
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
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(PROJECT_DIR) + "/config"))
  {
    if (entry.path().extension() != ".yaml")
      continue;
    ++files;
    const Value whole = readYamlFile(entry.path());
    EXPECT_NO_THROW(loadConfig(whole, entry.path())) << entry.path();
    EXPECT_TRUE(monitor::suspiciousValues(loadConfig(whole, entry.path())).empty()) << entry.path();
    if (whole.get<Value::Map>()->count("simulation") > 0)
    {
      EXPECT_NO_THROW(loadSimulation(whole, entry.path())) << entry.path();
    }
  }
  EXPECT_GE(files, 6);
}

// Every key that a loader asks for is documented, and in the template.
TEST(LoadConfig, EveryKeyStandsInTheDocumentsAndTheTemplate)
{
  const auto textOf = [](const std::filesystem::path& path)
  {
    std::ifstream in(path);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string root = PROJECT_DIR;
  const std::string documents = textOf(root + "/doc/parameters.md") + textOf(root + "/doc/alarms.md");
  const std::string by_default = textOf(root + "/config/template.yaml");
  const std::regex asked(
      R"re((?:number|optionalNumber|integer|boolean|text|vector2?|numbers|list|child|optional)\("([a-z_]+)")re");
  std::set<std::string> keys;
  for (const auto& entry : std::filesystem::directory_iterator(root + "/src/params"))
  {
    const std::string name = entry.path().filename();
    if (name.find("load_") != 0 || name == "load_simulation.cpp")
      continue;
    const std::string source = textOf(entry.path());
    for (std::sregex_iterator at(source.begin(), source.end(), asked), end; at != end; ++at)
      keys.insert((*at)[1]);
  }
  EXPECT_GT(keys.size(), 100u);
  for (const std::string& key : keys)
  {
    const std::regex whole("\\b" + key + "\\b");
    EXPECT_TRUE(std::regex_search(documents, whole)) << key << " is not in doc/parameters.md or doc/alarms.md";
    EXPECT_TRUE(std::regex_search(by_default, std::regex("\\b" + key + ":")))
        << key << " is not in config/template.yaml";
  }
}

TEST(LoadSimulation, FaultsNameTheKey)
{
  const Value::Map vessel{{"lenght", 30.0}, {"waypoints", Value::List{Value(Value::Map{{"speed", 1.0}})}}};
  const Value::Map vehicle{{"mass", 10.0},
                           {"volume", 0.01},
                           {"inertia", Value::List{1.0, 1.0, 1.0}},
                           {"drag_area", Value::List{1.0, 1.0, 1.0}},
                           {"control", std::string("dance")}};
  const Value::Map all{{"simulation", Value(Value::Map{{"vessel", vessel}, {"vehicle", vehicle}})}};
  try
  {
    loadSimulation(Value(all), "/test");
    FAIL() << "it was accepted";
  }
  catch (const ParameterError& error)
  {
    for (const char* text :
         {"simulation.vessel.lenght is not a known parameter",
          "simulation.vessel.waypoints[0].position is missing", "simulation.vehicle.control = 'dance'"})
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << text << "\n" << error.what();
  }
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

TEST_F(YamlFile, WhatHasNoEndIsRefusedAtOnce)
{
  const auto fault = [&](const std::string& text)
  {
    try
    {
      readYamlFile(write(text));
      return std::string("accepted");
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
  };
  EXPECT_NE(fault("a: &a [*a]\n").find("refer to itself"), std::string::npos);
  EXPECT_NE(fault("a: &a {b: *a}\n").find("refer to itself"), std::string::npos);
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i)
  {
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int k = 0; k < 9; ++k)
      bomb += ", " + before;
    bomb += "]\n";
  }
  EXPECT_NE(fault(bomb).find("more than 100000 entries"), std::string::npos);
  EXPECT_NE(fault(std::string(100000, '[')).find("lists within lists"), std::string::npos);
  std::string dashes;
  for (int i = 0; i < 100000; ++i)
    dashes += "- ";
  EXPECT_NE(fault(dashes).find("lists within lists"), std::string::npos);
  EXPECT_NE(fault(std::string(2 << 20, 'x')).find("larger than"), std::string::npos);
  EXPECT_EQ(fault("# " + std::string(200, '-') + "[[[\na: [1, 2]  # " + std::string(100, '[') + "\n"), "accepted");
  EXPECT_EQ(fault("\xEF\xBB\xBF"
                  "a: 1\n"),
            "accepted");
  EXPECT_THROW(readYamlFile("/dev/zero"), std::runtime_error);
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
