#pragma once

#include <array>
#include <cstddef>

#include "tether_monitor/core/cable/payout_trajectory.h"
#include "tether_monitor/monitor/measurements/correction_blender.h"

namespace tether_monitor::monitor
{
/**
 * Deployed length as the winch reports it: between reports a cubic, beyond the last at its rate. A correction of
 * an extrapolation is spread over the time between reports, as for the ends: a jump of the length is a blow to a
 * taut tether.
 */
class PayoutBuffer
{
 public:
  static constexpr double FASTEST = 4.5;  ///< [m/s]; faster is no pay-out but a leap of the report.

  /**
   * Accepts a report at time t [s].
   *
   * @param length  [m]
   * @param rate    [m/s]; NaN: the slope from an earlier report, 0.1 s ago or more.
   * @return        false, and nothing changes, if t is not later than the last report.
   */
  bool add(double t, double length, double rate);
  void clear() { count_ = 0; }

  /// True if a report at time t [s] would be later than the last.
  bool isLater(double t) const { return count_ == 0 || t > last().t; }
  bool hasReport() const { return count_ > 0; }
  /// Age at time t of the last report that is not later [s]; infinite without one.
  double age(double t) const;
  /// Length and rate at time t [s]; hasReport() must hold. Calls in order of t, else clear() first.
  core::PayoutState blend(double t);
  /// See MotionBuffer::isValid().
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(reports_, count_, blender_);
  }

 private:
  struct Report
  {
    double t, length, rate;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, length, rate);
    }
  };

  double slopeTo(double t, double length) const;
  core::PayoutState reported(double t) const;
  const Report& last() const { return reports_[count_ - 1]; }

  static constexpr std::size_t CAPACITY = 16;
  std::array<Report, CAPACITY> reports_{};  // in order of time
  std::size_t count_ = 0;
  CorrectionBlender<double> blender_;
};

}  // namespace tether_monitor::monitor
