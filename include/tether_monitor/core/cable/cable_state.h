#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// Attitude of a simulated body at a tether end, in its own axes. Its position is that of the end node.
struct AttitudeState
{
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, unit.
  Vector3 velocity = Vector3::Zero();                               ///< angular, body axes [rad/s].
  Vector3 acceleration = Vector3::Zero();                           ///< angular, body axes [rad/s^2].
  Vector3 algorithmic_acceleration = Vector3::Zero();               ///< algorithmic acceleration, (M12).

  template <class Archive>
  void serialize(Archive& a)
  {
    a(orientation, velocity, acceleration, algorithmic_acceleration);
  }
};

/// Motion of the centre of one obstacle, model coordinates.
struct ObstacleMotion
{
  Vector3 position = Vector3::Zero();                  ///< [m]
  Vector3 velocity = Vector3::Zero();                  ///< [m/s]
  Vector3 acceleration = Vector3::Zero();              ///< [m/s^2]
  Vector3 algorithmic_acceleration = Vector3::Zero();  ///< algorithmic acceleration, (M12).

  template <class Archive>
  void serialize(Archive& a)
  {
    a(position, velocity, acceleration, algorithmic_acceleration);
  }
};

/// How friction acts.
enum class FrictionMode
{
  COULOMB,  ///< springs that slip at Coulomb's limit.
  SLIP,     ///< steady motion: against the velocity, at the limit.
  STICK     ///< springs that never slip, on the way to a steady state.
};

/**
 * What friction remembers: for every integration point the place on a surface to which its friction spring is
 * tied, (M23). Empty while nothing can be touched.
 */
struct FrictionState
{
  double time = 0.0;  ///< [s] of these places.
  double step = 0.0;  ///< [s] of the step that is, or was, made: a contact is damped at least as it can resolve.
  FrictionMode friction = FrictionMode::COULOMB;
  std::vector<Vector3> seabed;             ///< [m]
  std::vector<Vector3> obstacle;           ///< [m] on the obstacle touched deepest.
  std::vector<Vector3> obstacle_position;  ///< centre of every obstacle [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(time, step, friction, seabed, obstacle, obstacle_position);
  }
};

/// Everything that the stepping of a tether carries from one step to the next. Plain data: copy it to save it, or
/// archive it (archive.h).
struct CableState
{
  double time = 0.0;                      ///< [s] of the input clock.
  double step = 0.0;                      ///< size of the last accepted step [s]; 0: take the largest allowed.
  int last_iterations = 0;                ///< Newton iterations of the last accepted step.
  NodeField q;                            ///< coordinates.
  NodeField v;                            ///< first time derivative.
  NodeField a;                            ///< second time derivative; satisfies the equations of motion at `time`.
  NodeField algorithmic_acceleration;     ///< algorithmic acceleration of the generalised-alpha scheme, (M12).
  AttitudeState vessel;                   ///< used if the model has a body there.
  AttitudeState vehicle;                  ///< used if the model has a body there.
  std::vector<ObstacleMotion> obstacles;  ///< one for each obstacle of the model.
  FrictionState contact;

  CableState() = default;
  /// Coordinates `shape` at time `t`, in uniform motion with velocity V [m/s] and no acceleration.
  CableState(double t, const NodeField& shape, const Vector3& V);

  /// True if every number is finite.
  bool allFinite() const;

  template <class Archive>
  void serialize(Archive& archiver)
  {
    archiver(time, step, last_iterations, q, v, a, algorithmic_acceleration, vessel, vehicle, obstacles, contact);
  }
};

}  // namespace tether_monitor::core
