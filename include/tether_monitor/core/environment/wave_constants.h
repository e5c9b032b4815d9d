#pragma once

namespace tether_monitor::core
{
/// Constants of one Airy wave, (M21) of doc/model.md: plain numbers, for the kernels.
struct WaveConstants
{
  double amplitude = 0.0;    ///< a [m], > 0 of a wave that moves.
  double frequency = 0.0;    ///< w [rad/s]
  double wavenumber = 0.0;   ///< k [rad/m]
  double direction_x = 1.0;  ///< unit vector towards which the crests run.
  double direction_y = 0.0;
  double phase = 0.0;  ///< [rad]
  double speed = 0.0;  ///< a w over 1 - exp(-2 k h): of the water at the surface [m/s].

  static constexpr double NO_MOTION = -40.0;  ///< k z below which nothing is left, exp(-40).
};
}  // namespace tether_monitor::core
