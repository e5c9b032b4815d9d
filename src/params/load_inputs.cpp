#include "tether_monitor/params/load_inputs.h"

#include <set>

namespace tether_monitor::params
{
namespace
{
monitor::SourceConfig loadSource(ParameterReader& in)
{
  monitor::SourceConfig source;
  source.topic = in.text("topic", "");
  if (source.topic.empty())
    in.addError("topic", " is missing");
  source.from = in.text("from", "");
  source.frame = in.text("frame", "");
  source.latency = in.number("latency", source.latency);
  if (in.has("stddev"))
    source.stddev = in.optionalNumber("stddev");
  source.scale = in.number("scale", source.scale);
  in.finish();
  return source;
}

monitor::DatumConfig loadDatum(ParameterReader in)
{
  monitor::DatumConfig datum;
  datum.latitude = in.number("latitude");
  datum.longitude = in.number("longitude");
  datum.yaw = in.number("yaw", datum.yaw);
  if (in.has("altitude"))
    datum.altitude = in.optionalNumber("altitude");
  in.finish();
  return datum;
}

monitor::WinchJointConfig loadWinchJoint(ParameterReader in)
{
  monitor::WinchJointConfig joint;
  joint.name = in.text("name", "");
  if (joint.name.empty())
    in.addError("name", " is missing");
  joint.ratio = in.number("ratio");
  joint.offset = in.number("offset", joint.offset);
  in.finish();
  return joint;
}
}  // namespace

void loadInputs(ParameterReader& in, monitor::InputsConfig& config)
{
  std::set<std::string> topics;
  for (ParameterReader& entry : in.list("inputs"))
  {
    config.sources.push_back(loadSource(entry));
    if (!topics.insert(config.sources.back().topic).second)
      entry.addError("topic", " = '" + config.sources.back().topic + "' (is there twice)");
  }
  if (in.has("datum"))
    config.datum = loadDatum(in.child("datum"));
  if (in.has("payout_joint"))
    config.winch_joint = loadWinchJoint(in.child("payout_joint"));
}

}  // namespace tether_monitor::params
