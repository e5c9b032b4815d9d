#pragma once

namespace tether_monitor::core
{
/// Integral of S_i S_j over an element of unit length, times 420.
inline constexpr double UNIT_MASS[4][4] = {
    {156.0, 22.0, 54.0, -13.0}, {22.0, 4.0, 13.0, -3.0}, {54.0, 13.0, 156.0, -22.0}, {-13.0, -3.0, -22.0, 4.0}};
inline constexpr double UNIT_MASS_DIVISOR = 420.0;

/// Integral of S_i'' S_j'' over an element of unit length.
inline constexpr double UNIT_BENDING[4][4] = {
    {12.0, 6.0, -12.0, 6.0}, {6.0, 4.0, -6.0, 2.0}, {-12.0, -6.0, 12.0, -6.0}, {6.0, 2.0, -6.0, 4.0}};

}  // namespace tether_monitor::core
