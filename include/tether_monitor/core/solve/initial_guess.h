#pragma once

#include "tether_monitor/core/assembly/cable_model.h"

namespace tether_monitor::core
{
/// Weight and drag per metre [N/m] on a straight tether along the chord, averaged over its depth.
Vector3 netLoad(const CableModel& model, const Vector3& vessel, const Vector3& vehicle, const Vector3& velocity);

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

/**
 * A starting curve for the steady state: a catenary bowed along the net load (weight and drag), never through
 * compression.
 *
 * @param vessel, vehicle  positions of the two ends [m].
 * @param velocity         common velocity of both ends [m/s].
 * @return                 coordinates of every node.
 */
NodeField catenaryGuess(const CableModel& model, const Vector3& vessel, const Vector3& vehicle,
                        const Vector3& velocity);

/**
 * A starting curve for a body that hangs from the tether: the tension vector is integrated from the body to the
 * vessel, dn/ds = -load, and the curve follows it. Loads that change with depth are taken at the depths of the
 * pass before.
 *
 * @param vessel    position of the vessel end [m].
 * @param velocity  common velocity of both ends [m/s].
 */
NodeField hangingBodyGuess(const CableModel& model, const Vector3& vessel, const Vector3& velocity,
                           const RigidBody& body);

}  // namespace tether_monitor::core
