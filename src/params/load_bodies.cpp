#include "tether_monitor/params/load_bodies.h"

#include <optional>
#include <string>

namespace tether_monitor::params
{
namespace
{
monitor::BodyConfig loadBody(ParameterReader& in)
{
  monitor::BodyConfig body;
  if (in.isText("attachment"))
    in.addError("attachment", " names a frame: that is known to the node, and to a bag with transforms");
  else
    body.attachment = in.vector("attachment", body.attachment);
  body.frame = in.text("frame", body.frame);
  if (in.has("clamped"))
    body.clamped = in.vector("clamped");
  body.tf_frame = in.text("tf_frame", body.tf_frame);
  if (in.has("height"))
    body.height = in.optionalNumber("height");
  body.least_stddev = in.number("least_stddev", body.least_stddev);
  const std::string twist_frame = in.text("twist_frame", "child");
  if (twist_frame != "child" && twist_frame != "world")
    in.addError("twist_frame", " = '" + twist_frame + "' (must be child or world)");
  body.twist_frame = twist_frame == "world" ? monitor::TwistFrame::WORLD : monitor::TwistFrame::CHILD;
  const std::string axes = in.text("body_axes", "flu");
  if (axes != "flu" && axes != "frd")
    in.addError("body_axes", " = '" + axes + "' (must be flu or frd)");
  if (axes == "frd")
  {
    body.body_axes = monitor::BodyAxes::FRD;
    body.attachment = monitor::turnedAboutX(body.attachment);
    if (body.clamped)
      body.clamped = monitor::turnedAboutX(*body.clamped);
  }
  return body;
}

monitor::NavigationConfig loadNavigation(ParameterReader& in)
{
  monitor::NavigationConfig navigation;
  navigation.position_stddev = in.number("position_stddev", navigation.position_stddev);
  navigation.velocity_stddev = in.number("velocity_stddev", navigation.velocity_stddev);
  navigation.latency = in.number("latency", navigation.latency);
  if (in.has("force_stddev"))
    navigation.force_stddev = in.optionalNumber("force_stddev");
  navigation.drag_stddev = in.number("drag_stddev", navigation.drag_stddev);
  return navigation;
}
}  // namespace

core::RigidBody loadRigidBody(ParameterReader& in)
{
  core::RigidBody body;
  body.mass = in.number("mass");
  body.volume = in.number("volume");
  body.inertia = in.vector("inertia");
  body.drag_area = in.vector("drag_area");
  body.added_mass = in.vector("added_mass", body.added_mass);
  body.added_inertia = in.vector("added_inertia", body.added_inertia);
  body.rotational_drag = in.vector("rotational_drag", body.rotational_drag);
  body.center_of_buoyancy = in.vector("center_of_buoyancy", body.center_of_buoyancy);
  body.force = in.vector("force", body.force);
  return body;
}

monitor::BodyConfig loadVessel(ParameterReader in)
{
  monitor::BodyConfig body = loadBody(in);
  if (in.has("position_stddev"))
    body.position_stddev = in.optionalNumber("position_stddev");
  if (in.has("velocity_stddev"))
    body.velocity_stddev = in.optionalNumber("velocity_stddev");
  in.finish();
  return body;
}

void loadVehicle(ParameterReader in, monitor::Config& config)
{
  config.vehicle = loadBody(in);
  const std::string mode = in.text("mode", "tracked");
  const bool is_simulated = mode == "free" || mode == "observed";
  if (is_simulated)
  {
    config.vehicle_mode = mode == "free" ? monitor::VehicleMode::FREE : monitor::VehicleMode::OBSERVED;
    config.vehicle_body = loadRigidBody(in);
    if (in.has("max_thrust"))
      config.max_thrust = in.optionalNumber("max_thrust");
  }
  // A file that was written for another mode stays good.
  if (mode == "observed")
    config.navigation = loadNavigation(in);
  if (mode == "tracked" && in.has("position_stddev"))
    config.vehicle.position_stddev = in.optionalNumber("position_stddev");
  if (mode != "observed")
    for (const char* key : {"position_stddev", "velocity_stddev", "latency", "force_stddev", "drag_stddev"})
      in.ignore(key);
  if (mode == "tracked")
  {
    for (const char* key : {"mass", "volume", "inertia", "drag_area", "added_mass", "added_inertia",
                            "rotational_drag", "center_of_buoyancy", "force", "max_thrust"})
      in.ignore(key);
  }
  else if (!is_simulated)
  {
    in.addErrors({"vehicle.mode = '" + mode + "' (must be tracked, free or observed)"});
    in.ignoreAll();
  }
  in.finish();
}

}  // namespace tether_monitor::params
