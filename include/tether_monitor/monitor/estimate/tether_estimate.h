#pragma once

#include <limits>

#include "tether_monitor/core/assembly/contact_summary.h"
#include "tether_monitor/core/assembly/station_profile.h"
#include "tether_monitor/monitor/estimate/status.h"
#include "tether_monitor/monitor/measurements/body_state.h"

namespace tether_monitor::monitor
{
/// What the monitor publishes of the tether at one time. While INVALID the stations are empty and the numbers NaN.
struct TetherEstimate
{
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  double time = 0.0;  ///< [s] of the input clock.
  Status status = Status::INVALID;
  Reason reason = Reason::NO_INPUT;  ///< the gravest.
  ReasonSet reasons;                 ///< all that hold.
  bool is_stowed = false;            ///< the winch reports that nothing is out.
  core::StationProfile stations;     ///< positions in the world frame; see has_stations.
  bool has_stations = false;         ///< false while INVALID.

  double length = NONE;                   ///< unstretched, deployed [m].
  double payout_rate = NONE;              ///< [m/s]; NaN when it is not reported.
  double max_tension = NONE;              ///< [N]; at the ends with the shear that a stiff tether carries there.
  double max_tension_s = NONE;            ///< [m]
  double min_tension = NONE;              ///< [N]
  double min_tension_s = NONE;            ///< [m]
  double vessel_tension = NONE;           ///< size of the force on the vessel end [N].
  double vehicle_tension = NONE;          ///< size of the force on the vehicle end [N].
  double working_utilisation = NONE;      ///< largest tension over the working load of its section [-].
  double working_utilisation_s = NONE;    ///< where [m].
  double breaking_utilisation = NONE;     ///< largest tension over the breaking load of its section [-].
  double min_bend_radius = NONE;          ///< [m]
  double min_bend_radius_s = NONE;        ///< [m]
  double governing_bend_radius = NONE;    ///< least bend radius for the alarm [m]: where a section has a limit of
                                          ///< its own, scaled to the limit of the whole tether.
  double governing_bend_radius_s = NONE;  ///< where [m].
  double vessel_end_angle = NONE;         ///< of the tether below the horizontal at the vessel end [rad].
  double vehicle_end_angle = NONE;        ///< the same at the vehicle end [rad].
  double seabed_contact_length = NONE;    ///< unstretched length on the seabed [m]; 0 without a seabed.
  double touchdown_s = NONE;              ///< first point on the seabed from the vessel end [m]; NaN if none is.
  core::ContactSummary contact;           ///< places in the world frame; an entry for each obstacle.
  BodyState vehicle;                      ///< of a simulated vehicle's centre of mass; see has_vehicle.
  bool has_vehicle = false;               ///< in modes free and observed, unless INVALID.
  double vessel_tension_stddev = NONE;    ///< standard deviation [N]; in mode observed, like all that follow.
  double vehicle_tension_stddev = NONE;   ///< [N]
  double vessel_tension_p05 = NONE, vessel_tension_p95 = NONE;    ///< quantiles [N].
  double vehicle_tension_p05 = NONE, vehicle_tension_p95 = NONE;  ///< quantiles [N].
  double max_tension_p95 = NONE;                                  ///< quantile [N].
  std::vector<double> tension_stddev;                             ///< along the stations [N]; empty: not known.
  std::vector<core::Vector3> position_stddev;  ///< along the stations, world axes [m]; likewise.
  std::vector<double> contact_probability;  ///< of every obstacle: share of the members that touch it; likewise.
  double vehicle_position_stddev = NONE;    ///< root mean square over the axes [m].
  core::Matrix3 vehicle_position_covariance = core::Matrix3::Constant(NONE);  ///< world axes [m^2].
  core::Matrix3 vehicle_velocity_covariance = core::Matrix3::Constant(NONE);  ///< world axes [m^2/s^2].
  core::Vector3 disturbance = core::Vector3::Constant(NONE);                  ///< estimated disturbance force [N].
  double disturbance_stddev = NONE;  ///< root mean square over the axes [N].
  double vessel_age = NONE;          ///< age of the last vessel pose [s].
  double vehicle_age = NONE;         ///< age of the last vehicle pose, of the last thrust if it is simulated [s].
  double vehicle_overdue =
      NONE;  ///< the same, less what is usual in mode observed: how long something has been due [s].
  double payout_age = NONE;  ///< age of the last report of the winch [s]; NaN if nothing reports.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(time, status, reason, reasons, is_stowed, stations, has_stations, length, payout_rate, max_tension,
      max_tension_s, min_tension, min_tension_s, vessel_tension, vehicle_tension, working_utilisation,
      working_utilisation_s, breaking_utilisation, min_bend_radius, min_bend_radius_s, governing_bend_radius,
      governing_bend_radius_s, vessel_end_angle, vehicle_end_angle, seabed_contact_length, touchdown_s, contact,
      vehicle, has_vehicle, vessel_tension_stddev, vehicle_tension_stddev, vessel_tension_p05, vessel_tension_p95,
      vehicle_tension_p05, vehicle_tension_p95, max_tension_p95, tension_stddev, position_stddev,
      contact_probability, vehicle_position_stddev, vehicle_position_covariance, vehicle_velocity_covariance,
      disturbance, disturbance_stddev, vessel_age, vehicle_age, vehicle_overdue, payout_age);
  }
};

}  // namespace tether_monitor::monitor
