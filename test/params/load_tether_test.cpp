#include "tether_monitor/params/load_tether.h"

#include <gtest/gtest.h>

#include "support/config_trees.h"

namespace tether_monitor::params
{
TEST(LoadTether, AxialStiffnessMayBeACurve)
{
  const auto row = [](double strain, double tension) {
    return Value(Value::Map{{"strain", strain}, {"tension", tension}});
  };
  Value::Map keys = tetherKeys();
  keys["axial_stiffness"] = Value(Value::List{row(0.1, 1000.0), row(0.2, 4000.0)});
  const Value::Map plain{{"from", 0.0}, {"to", 100.0}, {"axial_stiffness", 5e5}};
  const Value::Map same{{"from", 100.0}, {"to", 200.0}, {"drag_normal", 1.0}};
  keys["sections"] = Value(Value::List{Value(plain), Value(same)});
  const monitor::Config c = loadConfig(tree(keys), "/test");
  EXPECT_NEAR(c.tether.axial_stiffness, 1000.0 / 1.1 / 0.105, 1e-9);
  EXPECT_EQ(c.tether.axial_stiffening.count, 1);
  EXPECT_EQ(c.layout.sections[0].properties.axial_stiffening.count, 0);
  EXPECT_EQ(c.layout.sections[1].properties.axial_stiffening.count, 1);

  keys["axial_stiffness"] = Value(Value::List{row(0.1, 1000.0), row(0.2, 900.0)});
  const std::vector<std::string> faults = faultsOf(tree(keys));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0], "tether.axial_stiffness: row 2: tension must be greater than in the row before");
}

TEST(LoadTether, ReadsWinchSolverAndAgeingTether)
{
  Value::Map keys = tetherKeys();
  keys["hydrostatic_compression"] = 1e-5;
  keys["permanent_elongation"] = 0.01;
  keys["drag_amplification"] = 1.5;
  const Value::Map winch{{"core_diameter", 0.9}, {"width", 0.6}, {"layers", 12L}};
  const Value::Map solver{{"integrator", std::string("abarbanel_zwas")}, {"corrections", 1L}, {"courant", 0.8}};
  const monitor::Config c = loadConfig(tree(keys, {{"winch", Value(winch)}, {"solver", Value(solver)}}), "/test");
  EXPECT_EQ(c.tether.hydrostatic_compression, 1e-5);
  EXPECT_EQ(c.tether.permanent_elongation, 0.01);
  EXPECT_EQ(c.drag_amplification, 1.5);
  ASSERT_TRUE(c.winch);
  EXPECT_EQ(c.winch->layers, 12);
  EXPECT_EQ(c.solver.scheme, core::Scheme::ABARBANEL_ZWAS);
  EXPECT_EQ(c.solver.corrections, 1);
  EXPECT_EQ(c.solver.courant, 0.8);
}

TEST(LoadTether, SectionsTakeFromTheTetherWhatTheyDoNotSay)
{
  Value::Map keys = tetherKeys();
  keys["sections"] = Value::List{Value(Value::Map{{"from", 0.0}, {"to", 100.0}, {"diameter", 0.05}})};
  keys["attachments"] = Value::List{
      Value(Value::Map{{"name", std::string("float")}, {"s", 200.0}, {"mass", 5.0}, {"volume", 0.02}})};
  const monitor::Config c = loadConfig(tree(keys), "/test");
  ASSERT_EQ(c.layout.sections.size(), 1u);
  EXPECT_EQ(c.layout.sections[0].properties.diameter, 0.05);
  EXPECT_EQ(c.layout.sections[0].properties.mass_per_length, 1.43);
  ASSERT_EQ(c.layout.attachments.size(), 1u);
  EXPECT_EQ(c.layout.attachments[0].name, "float");
  EXPECT_EQ(c.layout.attachments[0].volume, 0.02);

  keys["sections"] = Value::List{Value(Value::Map{{"from", 0.0}, {"to", 500.0}, {"diametre", 0.05}})};
  EXPECT_EQ(faultsOf(tree(keys)), (std::vector<std::string>{"tether.sections[0].diametre is not a known parameter",
                                                            "tether.sections[0].to = 500 (must be <= length)"}));
}

TEST(LoadTether, ElementsMayBeChosenForAnAccuracy)
{
  EXPECT_FALSE(loadConfig(tree(tetherKeys()), "/test").accuracy);
  Value::Map keys = tetherKeys();
  keys["elements"] = std::string("auto");
  EXPECT_EQ(loadConfig(tree(keys), "/test").accuracy, 1e-3);
  keys["accuracy"] = 5e-3;
  EXPECT_EQ(loadConfig(tree(keys), "/test").accuracy, 5e-3);
  keys["accuracy"] = 0.5;
  EXPECT_EQ(faultsOf(tree(keys)),
            std::vector<std::string>{"tether.accuracy = 0.5 (must be >= 1e-05 and <= 0.1 [-])"});
  keys["elements"] = 50.0;
  EXPECT_EQ(faultsOf(tree(keys)), std::vector<std::string>{"tether.accuracy is for elements: auto"});
  keys["elements"] = std::string("many");
  keys.erase("accuracy");
  EXPECT_EQ(faultsOf(tree(keys)), std::vector<std::string>{"tether.elements = 'many' is not a number"});
}
}  // namespace tether_monitor::params
