#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/cable/cable_layout.h"
#include "tether_monitor/core/cable/winch_drum.h"
#include "tether_monitor/core/environment/environment.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/monitor/config/alarm_config.h"
#include "tether_monitor/monitor/config/body_config.h"
#include "tether_monitor/monitor/config/forecast_config.h"
#include "tether_monitor/monitor/config/inputs_config.h"
#include "tether_monitor/monitor/config/navigation_config.h"
#include "tether_monitor/monitor/config/runtime_config.h"
#include "tether_monitor/monitor/config/uncertainty_config.h"

namespace tether_monitor::monitor
{
/// The whole parameter tree, checked and with its defaults in place.
struct Config
{
  std::string world_frame = "map";
  core::Environment environment;
  core::CableProperties tether;
  core::CableLayout layout;
  int elements = 50;                ///< with an accuracy: until it is chosen.
  std::optional<double> accuracy;   ///< wanted [-], 1e-5..0.1: elements and step are chosen when it settles.
  double drag_amplification = 1.0;  ///< factor on the normal drag where vortices shed [-], >= 1.
  std::optional<core::WinchProperties> winch;
  BodyConfig vessel;
  BodyConfig vehicle;
  VehicleMode vehicle_mode = VehicleMode::TRACKED;
  core::RigidBody vehicle_body;      ///< set in modes free and observed; its attachment is that of `vehicle`.
  std::optional<double> max_thrust;  ///< of the vehicle [N], > 0; none: twice the largest that was reported.
  NavigationConfig navigation;       ///< of the vehicle.
  UncertaintyConfig uncertainty;

  core::StepperOptions solver;
  double rate = 20.0;            ///< [Hz], > 0.
  double pose_timeout = 1.0;     ///< [s], > 0.
  double invalid_timeout = 5.0;  ///< [s], >= pose_timeout.
  AlarmsConfig alarms;
  ForecastConfig forecast;
  RuntimeConfig runtime;
  InputsConfig inputs;
};

/// Standard deviation of the unknown forces on the vehicle [N]: what is told, else 0.16 m/s^2 times its mass.
double unknownForceStddev(const Config& config);

/// Every bound that `config` violates, one sentence each, named as in the parameter tree; those of the alarms are
/// found by validateAlarms().
std::vector<std::string> validate(const Config& config);

}  // namespace tether_monitor::monitor
