#include "tether_monitor/params/attachment_frames.h"

#include <gtest/gtest.h>

#include "tether_monitor/params/load_bodies.h"

namespace tether_monitor::params
{
namespace
{
Value body(const Value& attachment)
{
  return Value::Map{{"attachment", attachment}, {"frame", std::string("hull")}};
}

std::optional<core::Vector3> fairlead(const std::string& frame, const std::string& body_frame)
{
  return frame == "fairlead" && body_frame == "hull" ? std::optional<core::Vector3>({-30.0, 2.0, 4.0})
                                                     : std::nullopt;
}
}  // namespace

TEST(AttachmentFrames, ANameBecomesThePlaceOfItsFrame)
{
  Value tree(Value::Map{{"vessel", body(std::string("fairlead"))}, {"vehicle", body(Value::List{1.0, 2.0, 3.0})}});
  EXPECT_TRUE(placeAttachments(tree, fairlead).empty());
  ParameterReader reader(tree);
  EXPECT_EQ(loadVessel(reader.child("vessel")).attachment, core::Vector3(-30.0, 2.0, 4.0));
  monitor::Config config;
  loadVehicle(reader.child("vehicle"), config);
  EXPECT_EQ(config.vehicle.attachment, core::Vector3(1.0, 2.0, 3.0));
  EXPECT_TRUE(reader.errors().empty());
}

TEST(AttachmentFrames, AFrameInOtherAxesIsTurnedWithThem)
{
  Value tree(Value::Map{{"vessel", Value::Map{{"attachment", std::string("fairlead")},
                                              {"frame", std::string("hull")},
                                              {"body_axes", std::string("frd")}}}});
  EXPECT_TRUE(placeAttachments(tree, fairlead).empty());
  ParameterReader reader(tree);
  EXPECT_EQ(loadVessel(reader.child("vessel")).attachment, core::Vector3(-30.0, -2.0, -4.0));
}

TEST(AttachmentFrames, OneThatIsNotKnownIsNamedAndStays)
{
  Value tree(Value::Map{{"vehicle", Value::Map{{"attachment", std::string("fairlead")}}}});
  EXPECT_EQ(
      placeAttachments(tree, fairlead),
      std::vector<std::string>{"vehicle.attachment = 'fairlead': no transform from that frame to 'base_link'"});
  ParameterReader reader(tree);
  monitor::Config config;
  loadVehicle(reader.child("vehicle"), config);
  ASSERT_EQ(reader.errors().size(), 1u);
  EXPECT_NE(reader.errors()[0].find("vehicle.attachment names a frame"), std::string::npos) << reader.errors()[0];
}

}  // namespace tether_monitor::params
