#include "tether_monitor/core/contact/contact_law.h"

namespace tether_monitor::core
{
namespace
{
constexpr double SOFT_START = 0.02;  // penetration over diameter at which the spring is fully stiff [-]
}

ContactResponse contactForce(const ContactPoint& on, double diameter, const TangentWeights& w)
{
  ContactResponse out;
  if (!(on.penetration > 0.0))
    return out;
  const double soft = SOFT_START * diameter;
  const bool full = on.penetration >= soft;
  const double share = full ? 1.0 : on.penetration / soft;
  const double approach = -on.normal.dot(on.velocity);
  const double N = on.stiffness * (full ? on.penetration - 0.5 * soft : 0.5 * on.penetration * share) +
                   on.damping * share * approach;  // (M22)
  if (N <= 0.0)
    return out;
  out.normal_force = N;
  const double modulus = on.stiffness * share + (full ? 0.0 : on.damping * approach / soft);
  const double N_r = w.stiffness * modulus + w.damping * on.damping * share;  // -d N / d (normal distance)
  out.force = N * on.normal;
  out.stiffness = N_r * on.normal * on.normal.transpose() - w.stiffness * N * on.curvature;
  out.energy = on.stiffness * (full ? 0.5 * on.penetration * (on.penetration - soft) + soft * soft / 6.0
                                    : on.penetration * on.penetration * share / 6.0);

  const double limit = on.friction * N;
  if (limit <= 0.0 && on.friction_mode != FrictionMode::STICK)
    return out;
  const Matrix3 P = Matrix3::Identity() - on.normal * on.normal.transpose();
  const Vector3 slide = P * on.velocity;
  if (on.friction_mode == FrictionMode::SLIP)
  {
    const double speed = slide.norm();
    if (speed > 1e-6)
    {
      const Vector3 against = -slide / speed;
      out.force += limit * against;
      out.stiffness += on.friction * N_r * against * on.normal.transpose();
    }
    return out;
  }
  const Vector3 stretch = P * on.stretch;
  if (on.friction_mode == FrictionMode::STICK)
  {
    // Begins softly, as the normal force, so that touching down is no jump.
    const Vector3 pull = -on.stiffness * stretch;
    const double rising = full ? 0.0 : 1.0 / soft;
    out.force += share * pull;
    out.stiffness += w.stiffness * (share * on.stiffness * P + rising * pull * on.normal.transpose());
    out.stretch = stretch;
    return out;
  }
  const Vector3 hold = -(on.stiffness * stretch + on.damping * slide);  // (M23)
  const double size = hold.norm();
  const double elastic = w.stiffness * on.stiffness + w.damping * on.damping;
  if (size <= limit)
  {
    out.force += hold;
    out.stiffness += elastic * P;
    out.stretch = stretch;
  }
  else
  {
    const Vector3 against = hold / size;
    out.force += limit * against;
    out.stiffness += on.friction * N_r * against * on.normal.transpose() +
                     limit / size * elastic * (P - against * against.transpose());
    out.stretch = -limit / on.stiffness * against;
  }
  out.energy += 0.5 * on.stiffness * out.stretch.squaredNorm();
  return out;
}

}  // namespace tether_monitor::core
