#pragma once

#include "tether_monitor/core/analysis/dynamic_stiffness.h"

namespace tether_monitor::monitor
{
/// A row of weights of a displacement or a velocity [N/m, N s/m].
using RowVector3 = Eigen::Matrix<double, 1, 3>;

/// What a small error of the vehicle's motion does to one tension: change = position dp + velocity dv.
struct TensionJacobian
{
  RowVector3 position = RowVector3::Zero();  ///< [N/m]
  RowVector3 velocity = RowVector3::Zero();  ///< [N s/m]

  template <class Archive>
  void serialize(Archive& a)
  {
    a(position, velocity);
  }
};

/**
 * The tether's part in slow small motions of the vehicle: M a + C v + K x = force, (E4) of
 * doc/theory/estimation.md, fitted to its EndDynamicStiffness at two rates of growth.
 */
struct TetherLinearization
{
  static constexpr double FIT_RATE_LOW = 0.02, FIT_RATE_HIGH = 0.2;  ///< rates of growth of the fit [1/s].

  core::Matrix3 mass = core::Matrix3::Identity();           ///< vehicle with its added mass [kg].
  core::Matrix3 damping = core::Matrix3::Zero();            ///< [N s/m]
  core::Matrix3 stiffness = core::Matrix3::Zero();          ///< [N/m]
  core::Vector3 chord = core::Vector3::UnitX();             ///< unit, from the vessel end to the vehicle end.
  TensionJacobian vessel, vehicle;                          ///< of the tensions at the two ends.
  RowVector3 vessel_tension_jacobian = RowVector3::Zero();  ///< tension at the vessel end for a displacement of
                                                            ///< that end as fast as the waves [N/m].

  /**
   * Damping and stiffness of a mass, from what moves it at the two rates of growth [N/m]. A slack tether may be
   * about to buckle between them, and the line through both drives the vehicle: where a motion would grow by more
   * than 0.1 /s, neither part is let below zero.
   *
   * @return  false if they had to be held: then the faster of the two says nothing of slow motions.
   */
  bool fitMotion(const core::Matrix3& slow, const core::Matrix3& fast);
  /// Rates of position and velocity for a position and a velocity that nothing else drives.
  Eigen::Matrix<double, 6, 6> systemMatrix() const;
  /// Of the fastest growing motion [1/s]; negative: all decay.
  double growthRate() const;
  /// What an uncertain place of the vessel end makes of the tension there [N]. @param stddev  of that place [m].
  double vesselTensionStddev(const core::Vector3& stddev) const
  {
    return vessel_tension_jacobian.transpose().cwiseProduct(stddev).norm();
  }
  /// Goes over to another by a share 0..1: a stiffness that leaps would make a tension of every displacement.
  void blend(const TetherLinearization& other, double share);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(mass, damping, stiffness, chord, vessel, vehicle, vessel_tension_jacobian);
  }
};

/**
 * Fits a TetherLinearization about a state.
 *
 * @param wave_rate  how fast the errors of the vessel's motion are [1/s], > 0.
 * @return           false, and `fit` is as before, if a matrix is singular.
 */
bool linearizeTether(core::EndDynamicStiffnessSolver& solver, const core::DeployedCable& cable,
                     const core::CableState& state, double wave_rate, TetherLinearization& fit);

}  // namespace tether_monitor::monitor
