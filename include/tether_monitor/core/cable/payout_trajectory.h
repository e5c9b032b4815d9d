#pragma once

#include <array>

namespace tether_monitor::core
{
/// Deployed length and its rates at one time.
struct PayoutState
{
  double length = 0.0;        ///< [m], > 0.
  double rate = 0.0;          ///< [m/s], > 0 when the length increases.
  double acceleration = 0.0;  ///< [m/s^2]

  template <class Archive>
  void serialize(Archive& a)
  {
    a(length, rate, acceleration);
  }
};

inline bool operator==(const PayoutState& a, const PayoutState& b)
{
  return a.length == b.length && a.rate == b.rate && a.acceleration == b.acceleration;
}

/// Deployed length over a stretch of time: a cubic in time, continuous in length and rate.
class PayoutTrajectory
{
 public:
  PayoutTrajectory() = default;

  /// The length stays.
  static PayoutTrajectory constant(double length);
  /// From `from` at time t0 to `to` at time t1 [s]; t1 > t0.
  static PayoutTrajectory between(double t0, const PayoutState& from, double t1, const PayoutState& to);

  PayoutState at(double t) const;
  bool isConstant() const { return constant_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(constant_, t0_, c_);
  }

 private:
  bool constant_ = true;
  double t0_ = 0.0;
  std::array<double, 4> c_{};
};

}  // namespace tether_monitor::core
