#pragma once

#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/cable/attitude_state.h"
#include "tether_monitor/core/cable/deployment.h"
#include "tether_monitor/core/cable/end_clamps.h"
#include "tether_monitor/core/cable/friction_state.h"

namespace tether_monitor::core
{
/// Motion of the centre of one obstacle, model coordinates.
struct ObstacleMotion
{
  Vector3 position = Vector3::Zero();                  ///< [m]
  Vector3 velocity = Vector3::Zero();                  ///< [m/s]
  Vector3 acceleration = Vector3::Zero();              ///< [m/s^2]
  Vector3 algorithmic_acceleration = Vector3::Zero();  ///< see CableState.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(position, velocity, acceleration, algorithmic_acceleration);
  }
};

/// Everything that the stepping of a tether carries from one step to the next. Plain data: copy it to save it, or
/// serialise it (binary_archive.h).
struct CableState
{
  double time = 0.0;                      ///< [s] of the input clock.
  double step = 0.0;                      ///< size of the last accepted step [s]; 0: take the largest allowed.
  int last_iterations = 0;                ///< Newton iterations of the last accepted step.
  Deployment deployment;                  ///< deployed length and drag factors.
  NodeField q;                            ///< coordinates.
  NodeField v;                            ///< first time derivative.
  NodeField a;                            ///< second time derivative; satisfies the equations of motion at `time`.
  NodeField algorithmic_acceleration;     ///< of the generalised-alpha scheme, (M12); Arnold & Bruels (2007).
  AttitudeState vessel;                   ///< used if the model has a body there.
  AttitudeState vehicle;                  ///< used if the model has a body there.
  std::vector<ObstacleMotion> obstacles;  ///< one for each obstacle of the model.
  FrictionState contact;
  EndClamps clamps;

  CableState() = default;
  /// Coordinates `shape` at time `t`, in uniform motion with velocity V [m/s] and no acceleration.
  CableState(double t, const NodeField& shape, const Vector3& V, const Deployment& deployed = Deployment());

  /// True if every number is finite.
  bool allFinite() const;

  template <class Archive>
  void serialize(Archive& archive)
  {
    archive(time, step, last_iterations, deployment, q, v, a, algorithmic_acceleration, vessel, vehicle, obstacles,
            contact, clamps);
  }
};

}  // namespace tether_monitor::core
