#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/cable/cable_layout.h"
#include "tether_monitor/core/cable/cable_properties.h"
#include "tether_monitor/core/cable/winch_drum.h"
#include "tether_monitor/core/environment/environment.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/monitor/alarms/alarm.h"

namespace tether_monitor::monitor
{
/// Limits of one watched quantity: up to two alarms (warning and limit) with the same timing.
struct AlarmConfig
{
  std::optional<double> warning;  ///< unit of the quantity; none: no warning.
  std::optional<double> limit;    ///< unit of the quantity; none: no alarm.
  AlarmTiming timing;
};

/// Every alarm of the monitor. Limits of over_tension and breaking are fractions of working_load and
/// breaking_load.
struct AlarmsConfig
{
  AlarmConfig over_tension{0.8, 1.0, {0.2, 2.0, 0.05, true}};
  AlarmConfig breaking{std::nullopt, 0.9, {0.0, 2.0, 0.05, true}};
  AlarmConfig slack{std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}};        ///< least tension [N], bad below.
  AlarmConfig bend_radius{std::nullopt, std::nullopt, {0.5, 2.0, 0.0, false}};  ///< [m], bad below; limit defaults
                                                                                ///< to tether.min_bend_radius.
  AlarmConfig stale_input{std::nullopt, std::nullopt, {0.0, 1.0, 0.0, false}};  ///< age [s]; limit defaults to
                                                                                ///< pose_timeout.
};

/// How one end of the tether is fastened to its body.
struct BodyConfig
{
  core::Vector3 attachment = core::Vector3::Zero();  ///< from the reference point, body axes [m].
  std::string frame = "base_link";                   ///< frame_id by which a twist in body axes is known.
  std::optional<double> position_stddev,
      velocity_stddev;  ///< of the vessel in mode observed, without covariance in
                        ///< the message [m, m/s]; none: as the values scatter.
};

/// What drives the vehicle end.
enum class VehicleMode
{
  TRACKED,  ///< held on the measured motion.
  FREE,     ///< a simulated body.
  OBSERVED  ///< a simulated body that measurements correct.
};

/// How an observed vehicle is corrected. All but KALMAN are for comparison (bench/navigation_noise.cpp) and not in
/// the parameter tree.
enum class ObserverGains
{
  KALMAN,           ///< the filter of doc/estimation.md.
  NO_TETHER_MODEL,  ///< the same, but it takes the vehicle for a free body.
  FIXED             ///< constant gains.
};

/// How good the vehicle's navigation is, and how little is known of the forces on it; for OBSERVED.
struct NavigationConfig
{
  double position_stddev = 0.5;        ///< without covariance in the message [m], > 0.
  double velocity_stddev = 0.1;        ///< likewise [m/s], > 0.
  double latency = 0.0;                ///< how much older a measurement is than its stamp [s], 0..30.
  std::optional<double> force_stddev;  ///< of the force that nobody tells [N], > 0; none: 0.16 m/s^2 times the
                                       ///< mass.
  double drag_stddev = 0.15;           ///< of the relative error of the drag areas [-], > 0.
  ObserverGains gains = ObserverGains::KALMAN;
  double degraded_stddev = 0.15;  ///< of a tension, over the working load: DEGRADED above [-], > 0.
  double invalid_stddev = 0.5;    ///< likewise, INVALID above; >= degraded_stddev.
};

/// The whole parameter tree, checked and with its defaults in place.
struct Config
{
  std::string world_frame = "map";
  core::Environment environment;
  core::CableProperties tether;
  core::CableLayout layout;
  int elements = 50;                ///< with an accuracy: until it is chosen.
  std::optional<double> accuracy;   ///< wanted [-], 1e-5..0.1: elements and step are chosen when it settles.
  double drag_amplification = 1.0;  ///< factor on the normal drag where the tether strums [-], >= 1.
  std::optional<core::WinchProperties> winch;
  BodyConfig vessel;
  BodyConfig vehicle;
  VehicleMode vehicle_mode = VehicleMode::TRACKED;
  core::RigidBody vehicle_body;  ///< set in modes free and observed; its attachment is that of `vehicle`.
  NavigationConfig navigation;   ///< of the vehicle.

  core::StepperOptions solver;
  double rate = 20.0;            ///< [Hz], > 0.
  double pose_timeout = 1.0;     ///< [s], > 0.
  double invalid_timeout = 5.0;  ///< [s], >= pose_timeout.
  AlarmsConfig alarms;
};

/// Every bound that `config` violates, one sentence each, named as in the parameter tree.
std::vector<std::string> validate(const Config& config);

}  // namespace tether_monitor::monitor
