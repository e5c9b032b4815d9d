#pragma once

#include <cmath>
#include <type_traits>

#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::monitor
{
/// Zero of double or Vector3.
template <class V>
V zero()
{
  if constexpr (std::is_arithmetic_v<V>)
    return 0.0;
  else
    return V::Zero();
}

/// Value and rate of a correction that fades. V is double or Vector3.
template <class V>
struct Correction
{
  V value = zero<V>();
  V rate = zero<V>();

  /// Critically damped fading with bandwidth w [1/s] over dt [s].
  void fade(double w, double dt)
  {
    const double decay = std::exp(-w * dt);
    const V drive = rate + w * value;
    value = decay * (value + dt * drive);
    rate = decay * (rate - w * dt * drive);
  }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(value, rate);
  }
};

/**
 * Bumpless correction of an extrapolated motion: spreads what a new measurement corrects over the interval of the
 * measurements.
 *
 * When measurements come more slowly than ticks, each new one corrects an extrapolation. Made up within one tick,
 * a correction of centimetres would be a shock to a taut tether. This keeps the motion continuous: the correction
 * becomes an offset that fades with the time between measurements. V is double (a length) or Vector3 (a place).
 */
template <class V>
class CorrectionBlender
{
 public:
  /// Value and rate at one time.
  struct Motion
  {
    V value = zero<V>();
    V rate = zero<V>();

    template <class Archive>
    void serialize(Archive& a)
    {
      a(value, rate);
    }
  };

  /**
   * The motion that the model shall reach at time t.
   *
   * @param t              [s], increasing from call to call; else reset() first.
   * @param now            what the measurements say.
   * @param measured_at    time of the measurement that this rests on [s].
   * @param interval       time from the measurement before to this one [s]; not longer than the last call is ago:
   * no offset.
   */
  Motion blend(double t, const Motion& now, double measured_at, double interval);
  void reset() { started_ = false; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(started_, t_, measured_at_, last_, correction_);
  }

 private:
  static constexpr double BANDWIDTH = 2.5;       // times the interval of the measurements [-]
  static constexpr double SHORT_INTERVAL = 1.5;  // times dt: nothing to blend [-]

  bool started_ = false;
  double t_ = 0.0;
  double measured_at_ = 0.0;
  Motion last_;
  Correction<V> correction_;
};

template <class V>
typename CorrectionBlender<V>::Motion CorrectionBlender<V>::blend(double t, const Motion& now, double measured_at,
                                                                  double interval)
{
  const double dt = t - t_;
  Motion target = now;
  if (!started_ || !(dt > 0.0) || interval <= SHORT_INTERVAL * dt)
  {
    correction_ = Correction<V>();
  }
  else
  {
    if (measured_at != measured_at_)
    {
      correction_.value -= now.value - (last_.value + dt * last_.rate);
      correction_.rate -= now.rate - last_.rate;
    }
    correction_.fade(BANDWIDTH / interval, dt);
    target.value += correction_.value;
    target.rate += correction_.rate;
  }
  started_ = true;
  t_ = t;
  measured_at_ = measured_at;
  last_ = now;
  return target;
}

}  // namespace tether_monitor::monitor
