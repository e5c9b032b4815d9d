#include "tether_monitor/params/load_monitor.h"

#include "tether_monitor/monitor/alarms/alarm_quantities.h"

namespace tether_monitor::params
{
namespace
{
void loadAlarm(ParameterReader in, monitor::AlarmConfig& alarm)
{
  const auto optional = [&](const char* key, std::optional<double>& value)
  {
    if (in.has(key))
      value = in.optionalNumber(key);
  };
  optional("warning", alarm.warning);
  optional("limit", alarm.limit);
  alarm.timing.on_delay = in.number("on_delay", alarm.timing.on_delay);
  alarm.timing.off_delay = in.number("off_delay", alarm.timing.off_delay);
  alarm.timing.deadband = in.number("deadband", alarm.timing.deadband);
  alarm.timing.latch = in.boolean("latch", alarm.timing.latch);
  alarm.timing.manual_reset = in.boolean("manual_reset", alarm.timing.manual_reset);
  alarm.timing.realarm = in.number("realarm", alarm.timing.realarm);
  alarm.timing.chatter_hold = in.number("chatter_hold", alarm.timing.chatter_hold);
  in.finish();
}
}  // namespace

void loadSensors(ParameterReader& in, monitor::UncertaintyConfig& uncertainty)
{
  ParameterReader tension = in.child("tension_sensor");
  uncertainty.tension_stddev = tension.number("stddev", uncertainty.tension_stddev);
  uncertainty.tension_bias = tension.number("bias_stddev", uncertainty.tension_bias);
  tension.finish();
  ParameterReader direction = in.child("direction_sensor");
  uncertainty.direction_stddev = direction.number("stddev", uncertainty.direction_stddev);
  direction.finish();
}

void loadSolver(ParameterReader in, monitor::Config& config)
{
  config.uncertainty.members = in.integer("members", config.uncertainty.members);
  core::StepperOptions& options = config.solver;
  const std::string integrator = in.text("integrator", "generalized_alpha");
  if (integrator == "abarbanel_zwas")
    options.scheme = core::Scheme::ABARBANEL_ZWAS;
  else if (integrator != "generalized_alpha")
    in.addErrors({"solver.integrator = '" + integrator + "' (must be generalized_alpha or abarbanel_zwas)"});
  options.corrections = in.integer("corrections", options.corrections);
  options.courant = in.number("courant", options.courant);
  options.step = in.number("step", options.step);
  options.spectral_radius = in.number("spectral_radius", options.spectral_radius);
  in.finish();
}

void loadMonitor(ParameterReader in, monitor::Config& config)
{
  config.rate = in.number("rate", config.rate);
  config.pose_timeout = in.number("pose_timeout", config.pose_timeout);
  config.invalid_timeout = in.number("invalid_timeout", config.invalid_timeout);
  config.navigation.degraded_stddev = in.number("degraded_stddev", config.navigation.degraded_stddev);
  config.navigation.invalid_stddev = in.number("invalid_stddev", config.navigation.invalid_stddev);
  ParameterReader forecast = in.child("forecast");
  config.forecast.horizon = forecast.number("horizon", config.forecast.horizon);
  config.forecast.rate = forecast.number("rate", config.forecast.rate);
  config.forecast.members = forecast.integer("members", config.forecast.members);
  forecast.finish();
  ParameterReader realtime = in.child("realtime");
  config.runtime.priority = realtime.integer("priority", config.runtime.priority);
  config.runtime.lock_memory = realtime.boolean("lock_memory", config.runtime.lock_memory);
  realtime.finish();
  config.runtime.state_file = in.text("state_file", "");
  ParameterReader bridge = in.child("bridge");
  config.runtime.bridge.vessel = bridge.text("vessel", "");
  config.runtime.bridge.vehicle = bridge.text("vehicle", "");
  config.runtime.bridge.vehicle_body = bridge.text("vehicle_body", "");
  bridge.finish();
  ParameterReader outputs = in.child("outputs");
  config.runtime.outputs.path = outputs.boolean("path", config.runtime.outputs.path);
  config.runtime.outputs.vessel_pose = outputs.boolean("vessel_pose", config.runtime.outputs.vessel_pose);
  config.runtime.outputs.tf = outputs.boolean("tf", config.runtime.outputs.tf);
  outputs.finish();
  ParameterReader alarms = in.child("alarms");
  for (const monitor::AlarmQuantity& quantity : monitor::alarmQuantities())
    loadAlarm(alarms.child(quantity.name), monitor::alarmConfig(config, quantity.name));
  alarms.finish();
  in.finish();
}

}  // namespace tether_monitor::params
