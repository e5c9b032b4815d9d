#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "verification/reference_cases.h"

namespace tether_monitor::bench
{
/// What happened: motions and tensions at every multiple of `step`.
struct Truth
{
  Case of;
  double step = 0.05;  ///< [s]
  std::vector<core::EndMotion> vessel;
  std::vector<monitor::BodyState> vehicle;
  std::vector<core::Wrench> thrust;                     ///< that the vehicle's pilot gives; empty: none.
  std::vector<core::PayoutState> payout;                ///< empty: the tether is as long as it was built.
  std::vector<double> vessel_tension, vehicle_tension;  ///< [N]

  double timeOf(std::size_t i) const { return step * static_cast<double>(i); }
};

/// C, D and G: a vehicle that keeps its station, 120 m down on 150 m of near-neutral tether, under a vessel that
/// drifts and heaves.
std::vector<Case> navigationCases();

/// Moves a case for `duration` [s] (0: its own), with an unmodelled force on the vehicle [N].
Truth makeTruth(const Case& c, double duration, const core::Vector3& unmodelled);

/// How positions are measured and what goes wrong with them.
struct Sensors
{
  unsigned seed = 1;
  double fix_interval = 1.0;                                 ///< of the vehicle's position [s].
  double fix_stddev = 0.3;                                   ///< [m]
  double outliers = 0.05;                                    ///< share of positions that are 5 to 50 m off.
  double latency = 1.0;                                      ///< [s]
  double satellite_interval = 0.2, satellite_stddev = 0.02;  ///< of the vessel's position [s, m].
  double heave_interval = 0.05, heave_stddev = 0.03;         ///< of its height [s, m].
  bool has_load_cell = false;                                ///< at the vessel end, ten times a second.
  double tension_stddev = 0.02, tension_bias = 0.0;          ///< relative; [N].
  /// Changes a measured position at its time, after the noise; false: it gets lost. Empty: none.
  std::function<bool(double, core::Vector3&)> fault;
};

/// What the estimator knows of the vehicle.
struct Knowledge
{
  double drag_factor = 1.0;    ///< on the true drag areas.
  double length_factor = 1.0;  ///< on the true length of the tether.
};

/// An estimate a tick.
struct Trail
{
  std::vector<double> t, vessel_tension, vehicle_tension, vessel_stddev, vehicle_stddev;
  std::vector<double> vessel_p05, vessel_p95, vehicle_p05, vehicle_p95;
  std::vector<std::size_t> index;  ///< in the truth.
  std::vector<core::Vector3> vehicle;
  std::vector<double> vehicle_stddev_m;
  std::vector<monitor::Status> status;
  std::vector<monitor::Reason> reason;
  bool limit_alarm = false;  ///< the over-tension limit alarm rose.
  double cpu = 0.0;          ///< of the ticks [s].
  monitor::InnovationStatistics innovations;
};

/// Configuration for a case: its tether, its body as known, the limit a tenth above the true peak.
monitor::Config configFor(const Truth& truth, const Knowledge& knowledge, monitor::VehicleMode mode,
                          const Sensors& sensors);

/// Runs the estimator live at its rate over measurements of the truth.
/// @param look  called after every tick with the index in the truth; may be empty.
Trail observe(const Truth& truth, const monitor::Config& config, const Sensors& sensors,
              const std::function<void(const monitor::TetherEstimator&, std::size_t)>& look = nullptr);

/// How well a trail matches the truth from `from` to `to` [s].
struct Score
{
  double rms = 0.0;                       ///< of the vessel tension, over its mean [-].
  double vehicle_rms = 0.0;               ///< of the vehicle tension, likewise.
  double peak = 0.0;                      ///< largest over the true largest, less one [-].
  double within_1 = 0.0, within_2 = 0.0;  ///< share of estimates within one and two standard deviations.
  double valid = 0.0, ok = 0.0;           ///< share of ticks that are not INVALID, that are OK.
  double mean_stddev = 0.0;               ///< over the mean tension [-].
};
Score score(const Truth& truth, const Trail& trail, double from = 60.0, double to = 1e9);
}  // namespace tether_monitor::bench
