#pragma once

namespace tether_monitor::monitor
{
/// How well the tether, the water and their sensors are known: standard deviations of what is configured, >= 0.
/// Used in mode observed.
struct UncertaintyConfig
{
  double drag_normal = 0.25;       ///< relative [-].
  double drag_tangential = 0.25;   ///< relative [-].
  double mass_per_length = 0.025;  ///< relative [-].
  double length = 0.0075;          ///< relative [-].
  double axial_stiffness = 0.1;    ///< relative [-].
  double current = 0.2;          ///< of each horizontal component at the surface [m/s]; half of it for the shear.
  double tension_stddev = 0.02;  ///< of a reading of the load cell, over the reading [-], > 0.
  double tension_bias = 0.02;    ///< of its bias, over the working load [-].
  double direction_stddev = 0.03;  ///< of a reading of the tether's direction, and of its bias [rad], > 0.
  double fouling_memory = 3600.0;  ///< in which the drag of tether and vehicle may become another [s], > 0.
  int members = 96;                ///< tethers of the ensemble, 64..1000.
};

}  // namespace tether_monitor::monitor
