#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/cable/property_variation.h"
#include "verification/navigation_study.h"

namespace tether_monitor::bench
{
/// A case whose tether, water and vehicle are not known well.
struct UncertainCase
{
  Case of;
  bool is_towed = true;               ///< else a vehicle under its own thrust keeps to a place or a way.
  bool reports_thrust = false;        ///< that thrust is told to the estimator.
  double manoeuvre = 0.0;             ///< speed of that way [m/s].
  double force_stddev = 165.0;        ///< told of the unknown force [N].
  monitor::UncertaintyConfig told;    ///< what is told to the estimator, and what truths are drawn from.
  double vehicle_drag_stddev = 0.15;  ///< likewise [-].
  int true_elements = 50;
  core::Vector3 current_change = core::Vector3::Zero();  ///< of the true current, in ten seconds [m/s].
  double changes_at = 0.0;                               ///< [s]
  double push = 0.0;         ///< thrust along x that a vehicle under its own thrust adds then, and holds [N].
  double most_thrust = 1e9;  ///< of a vehicle under its own thrust [N].
  std::function<core::PayoutState(double)> payout = nullptr;  ///< none: the tether is as long as it was built.
};

/// C (tow in heave), D (tow in a turn), I (tow in an irregular sea), G (keeps its station in a current), R
/// (rests), M (manoeuvres at 0.5 m/s), S (slack tether in a sheared current).
std::vector<UncertainCase> uncertainCases();
/// C and G in a current that changes by 0.3 m/s after 200 s, scored from five minutes after that on. The estimator
/// is told of that: its standard deviation of the current is that of the draw and of the change together.
std::vector<UncertainCase> changingCurrents();

/// What is otherwise in a truth than was told.
struct TruthDraw
{
  core::PropertyVariation variation;
  core::Vector3 force = core::Vector3::Zero();  ///< on a vehicle of which no thrust is unknown [N].
  double fast_stddev = 0.0;                     ///< of what changes about that, along every axis [N].
  unsigned seed = 0;                            ///< of what changes.
  double tension_bias = 0.0;                    ///< of the load cell, in standard deviations.
};

/// Drawn from what is told.
TruthDraw drawTruth(const UncertainCase& c, unsigned seed);
/// Moves a case with what is otherwise in it.
Truth makeTruth(const UncertainCase& c, const TruthDraw& draw);

/// C, D, G, ... by name. @throws std::out_of_range
UncertainCase uncertainCase(const std::string& name);

/// Configuration for a truth of a case.
monitor::Config configFor(const UncertainCase& c, const Truth& truth, const Sensors& sensors);

}  // namespace tether_monitor::bench
