#pragma once

namespace tether_monitor::core
{
/// Weights of mass, damping and stiffness in the iteration matrix: J = mass dR/da + damping dR/dv + stiffness
/// dR/dq.
struct TangentWeights
{
  double mass = 1.0;
  double damping = 0.0;
  double stiffness = 0.0;
};

/// How much of the tangent is assembled.
enum class TangentKind
{
  SYMMETRIC,  ///< what a time step needs: the rotation of drag with the tether, small by the step, is left out.
  COMPLETE    ///< everything, for steady states.
};

}  // namespace tether_monitor::core
