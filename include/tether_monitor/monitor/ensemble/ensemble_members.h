#pragma once

#include <vector>

#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/monitor/ensemble/ensemble_start.h"
#include "tether_monitor/monitor/ensemble/ensemble_transform.h"
#include "tether_monitor/monitor/ensemble/tether_parameters.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// Torque that turns a body to an attitude, critically damped within some seconds [N m], body axes.
core::Vector3 torqueTowards(const core::RigidBody& body, const Eigen::Quaterniond& attitude,
                            const core::AttitudeState& now);

/// How all members move at one time: a column each.
struct MemberMotion
{
  explicit MemberMotion(int members = 0);

  MemberVectors position, velocity;  ///< of the vehicle's centre of mass, model coordinates [m, m/s].
  MemberVectors direction;           ///< unit, in which the tether leaves the vessel.
  Eigen::RowVectorXd vessel_tension, vehicle_tension;  ///< sizes of the end forces [N].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(position, velocity, direction, vessel_tension, vehicle_tension);
  }
};

/**
 * The tethers of an ensemble, each with its vehicle and its parameters, stepped under one motion of the vessel.
 *
 * Parameters that are changed come into force smoothly, the length over ten seconds, the others over four: a
 * tether whose length leaps is struck. A member that cannot be stepped is replaced by a copy of another. Allocates
 * in begin() only.
 */
class EnsembleMembers
{
 public:
  explicit EnsembleMembers(const Config& config);

  int size() const { return count_; }
  /// Begins at the states of a start, with the velocities of `simulation`.
  void begin(const EnsembleStart& start, const CableSimulation& simulation);
  /// Obstacles or their number have changed.
  void takeObstacles(const CableSimulation& simulation);
  void moveObstacle(std::size_t k, const core::ObstacleMotion& now);

  /**
   * Steps all members to time t [s].
   *
   * @param paths       of the vessel, the pay-out and the known thrust.
   * @param parameters  that they shall have.
   * @param force       beyond the model, on each vehicle [N].
   * @param attitude    measured, of the vehicle; none: it turns freely.
   * @return            sums over the members; not converged if more than a quarter of them could not be stepped.
   */
  core::SolveReport advance(const core::CableModel& model, const core::BoundaryConditions& paths, double t,
                            const ParameterMatrix& parameters, const MemberVectors& force,
                            const std::optional<Eigen::Quaterniond>& attitude);

  const MemberMotion& motion() const { return motion_; }
  const core::CableState& state(int i) const { return members_[i].state; }
  const core::DeployedCable& cable(int i) const { return members_[i].cable; }
  /// Replaced since the beginning.
  long replaced() const { return replaced_; }
  bool isValid(const core::CableModel& model) const;
  /// Takes memory for a model.
  void prepare(const core::CableModel& model);

  template <class Archive>
  void serialize(Archive& a)
  {
    for (Member& member : members_)
      a(member);
    a(motion_, shear_depth_, varied_at_, replaced_);
  }

 private:
  struct Member
  {
    Member(const core::CableModel& model, const core::StepperOptions& options)
      : stepper(model, options), cable(model)
    {
    }
    core::CableState state;
    ParameterVector towards = ParameterVector::Zero(), acting = ParameterVector::Zero();
    core::AdaptiveStepper stepper;
    core::DeployedCable cable;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(state, towards, acting);
    }
  };
  void vary(double dt, const ParameterMatrix& parameters);
  void observe(int i, const core::CableModel& model);
  // Member `i` goes on as member `from`.
  void replace(int i, int from);

  int count_;
  core::StepperOptions options_;
  core::RigidBody body_;
  std::vector<Member> members_;
  std::vector<char> failed_;
  MemberMotion motion_;
  double shear_depth_ = 1.0;
  double varied_at_ = 0.0;  // [s]
  long replaced_ = 0;
};

}  // namespace tether_monitor::monitor
