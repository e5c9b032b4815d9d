#pragma once

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
/// What may be wrong with the poses of a body.
enum class PoseFault
{
  NONE,
  KILLED,
  FROZEN,
  LEAPT,     ///< elsewhere by 5 m, and back after.
  NOISY,     ///< scattering by 0.3 m.
  LATE,      ///< stamps 0.3 s too old.
  EARLY,     ///< stamps 0.3 s ahead.
  MIRRORED,  ///< z down.
  NOT_A_NUMBER,
  EXTREME,
  ANOTHER_BODY,  ///< every other pose is that of something 40 m away.
  COUNT
};

inline const char* describe(PoseFault fault)
{
  static const char* const words[] = {"none",  "killed",   "frozen",       "leapt",   "noisy",       "late",
                                      "early", "mirrored", "not a number", "extreme", "another body"};
  return words[static_cast<int>(fault)];
}

/// A vessel in a swell tows at 2 m/s, the vehicle follows on a taut tether of 100 m.
class TowedTruth
{
 public:
  BodyState vessel(double t) const
  {
    BodyState body;
    body.position = {2.0 * t, 0.2 * std::sin(0.5 * t), 1.0 + 0.4 * std::sin(0.8 * t)};
    body.velocity = {2.0, 0.1 * std::cos(0.5 * t), 0.32 * std::cos(0.8 * t)};
    return body;
  }
  BodyState vehicle(double t) const
  {
    BodyState body;
    body.position = {2.0 * t - 80.0, 0.0, -57.0 + 0.1 * std::sin(0.8 * t - 1.0)};
    body.velocity = {2.0, 0.0, 0.08 * std::cos(0.8 * t - 1.0)};
    return body;
  }
};

/// The poses of a body as a faulty source publishes them.
class FaultySource
{
 public:
  FaultySource(PoseFault fault, double from, double until) : fault_(fault), from_(from), until_(until) {}

  /// What comes at time t [s] of a body that is truly at `truth`.
  std::optional<PoseMeasurement> at(double t, const BodyState& truth)
  {
    PoseMeasurement pose;
    pose.t = t;
    pose.position = truth.position;
    if (t < from_ || t >= until_)
    {
      last_good_ = truth.position;
      return pose;
    }
    core::Vector3 p = truth.position;
    switch (fault_)
    {
      case PoseFault::KILLED:
        return std::nullopt;
      case PoseFault::FROZEN:
        p = last_good_;
        break;
      case PoseFault::LEAPT:
        p.x() += 5.0;
        break;
      case PoseFault::NOISY:
        for (int i = 0; i < 3; ++i)
          p[i] += 0.3 * normal_(generator_);
        break;
      case PoseFault::LATE:
        pose.t -= 0.3;
        break;
      case PoseFault::EARLY:
        pose.t += 0.3;
        break;
      case PoseFault::MIRRORED:
        p.z() = -p.z();
        break;
      case PoseFault::NOT_A_NUMBER:
        p.x() = NAN;
        break;
      case PoseFault::EXTREME:
        p.y() = 1e7;
        break;
      case PoseFault::ANOTHER_BODY:
        other_ = !other_;
        p.y() += other_ ? 40.0 : 0.0;
        break;
      case PoseFault::NONE:
      case PoseFault::COUNT:
        break;
    }
    pose.position = p;
    return pose;
  }

 private:
  PoseFault fault_;
  double from_, until_;
  core::Vector3 last_good_ = core::Vector3::Zero();
  bool other_ = false;
  std::mt19937 generator_{3};
  std::normal_distribution<double> normal_;
};

/// How an estimate fared against the truth.
class Trust
{
 public:
  /// @param status,tension  of the estimate at time t [s]; truth: the right tension [N].
  void add(double t, Status status, double tension, double truth)
  {
    const bool lies = status == Status::OK && !(std::abs(tension - truth) <= 0.1 * truth);
    if (!lies)
      since_ = t;
    longest_ = std::max(longest_, t - since_);
    if (status == Status::OK)
      ++ok_;
    ++count_;
  }
  /// Longest time in which the status was OK with more than 10 % error [s].
  double longestLie() const { return longest_; }
  double shareOk() const { return static_cast<double>(ok_) / static_cast<double>(count_); }

 private:
  double since_ = 0.0, longest_ = 0.0;
  long ok_ = 0, count_ = 0;
};

}  // namespace tether_monitor::monitor
