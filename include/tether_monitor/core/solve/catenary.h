#pragma once

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// A plane catenary of given length between two points under a uniform load, inextensible. (M15) of doc/model.md.
class Catenary
{
 public:
  /**
   * @param from, to  the two ends [m]; a chord longer than `length` gives the straight line between them.
   * @param length    [m], > 0.
   * @param load      load per metre [N/m]; only its direction counts. Zero: straight down.
   * @param least_radius  [m], >= 0: a bight that would be tighter is opened until it is not; position(length) then
   *                      misses `to`.
   */
  Catenary(const Vector3& from, const Vector3& to, double length, const Vector3& load, double least_radius = 0.0);

  /// Position at arc length s from `from`, 0 <= s <= length [m].
  Vector3 position(double s) const;
  /// Unit tangent at arc length s; on a straight line, the direction of the chord.
  Vector3 tangent(double s) const;

 private:
  Vector3 from_, along_, down_;  // span direction and load direction, unit vectors
  Vector3 chord_;
  double length_;
  double parameter_ = 0.0;  // a [m]; 0 for a straight line
  double vertex_ = 0.0;     // arc length from `from` to the lowest point [m]
};

}  // namespace tether_monitor::core
