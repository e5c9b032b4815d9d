#include "tether_monitor/core/contact/contact_law.h"

namespace tether_monitor::core
{
namespace
{
constexpr double SOFT_START = 0.02;      // penetration over diameter at which the spring is fully stiff [-]
constexpr double STANDING_SPEED = 1e-6;  // [m/s] below which steady sliding has no direction

// The normal force and how it changes with the normal distance.
struct NormalContact
{
  double soft = 0.0;     // penetration at which the spring is fully stiff [m]
  bool full = false;     // beyond it
  double share = 0.0;    // of the stiffness that acts
  double force = 0.0;    // N [N/m]
  double tangent = 0.0;  // weighted -d N / d (normal distance)
};

NormalContact normalContact(const ContactPoint& on, double diameter, const TangentWeights& w)
{
  NormalContact n;
  n.soft = SOFT_START * diameter;
  n.full = on.penetration >= n.soft;
  n.share = n.full ? 1.0 : on.penetration / n.soft;
  const double approach = -on.normal.dot(on.velocity);
  n.force = on.stiffness * (n.full ? on.penetration - 0.5 * n.soft : 0.5 * on.penetration * n.share) +
            on.damping * n.share * approach;  // (M22)
  const double modulus = on.stiffness * n.share + (n.full ? 0.0 : on.damping * approach / n.soft);
  n.tangent = w.stiffness * modulus + w.damping * on.damping * n.share;
  return n;
}

Matrix3 tangentPlane(const ContactPoint& on)
{
  return Matrix3::Identity() - on.normal * on.normal.transpose();
}

// Steady sliding: at Coulomb's limit, against the velocity.
void addSlip(const ContactPoint& on, const NormalContact& n, ContactResponse& out)
{
  const Vector3 slide = tangentPlane(on) * on.velocity;
  const double speed = slide.norm();
  if (!(speed > STANDING_SPEED))
    return;
  const Vector3 against = -slide / speed;
  out.force += on.friction * n.force * against;
  out.stiffness += on.friction * n.tangent * against * on.normal.transpose();
}

// A spring that never slips. It begins softly, as the normal force, so that touching down is no jump.
void addStick(const ContactPoint& on, const NormalContact& n, const TangentWeights& w, ContactResponse& out)
{
  const Matrix3 P = tangentPlane(on);
  const Vector3 stretch = P * on.stretch;
  const Vector3 spring = -on.stiffness * stretch;
  const double rising = n.full ? 0.0 : 1.0 / n.soft;
  out.force += n.share * spring;
  out.stiffness += w.stiffness * (n.share * on.stiffness * P + rising * spring * on.normal.transpose());
  out.stretch = stretch;
}

// A spring with a damper that slips at mu N, (M23): return mapping.
void addCoulomb(const ContactPoint& on, const NormalContact& n, const TangentWeights& w, ContactResponse& out)
{
  const Matrix3 P = tangentPlane(on);
  const Vector3 stretch = P * on.stretch, slide = P * on.velocity;
  const double limit = on.friction * n.force;
  const Vector3 hold = -(on.stiffness * stretch + on.damping * slide);
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
    out.stiffness += on.friction * n.tangent * against * on.normal.transpose() +
                     limit / size * elastic * (P - against * against.transpose());
    out.stretch = -limit / on.stiffness * against;
  }
  out.energy += 0.5 * on.stiffness * out.stretch.squaredNorm();
}
}  // namespace

ContactResponse contactForce(const ContactPoint& on, double diameter, const TangentWeights& w)
{
  ContactResponse out;
  if (!(on.penetration > 0.0))
    return out;
  const NormalContact n = normalContact(on, diameter, w);
  if (n.force <= 0.0)
    return out;
  out.normal_force = n.force;
  out.force = n.force * on.normal;
  out.stiffness = n.tangent * on.normal * on.normal.transpose() - w.stiffness * n.force * on.curvature;
  out.energy = on.stiffness * (n.full ? 0.5 * on.penetration * (on.penetration - n.soft) + n.soft * n.soft / 6.0
                                      : on.penetration * on.penetration * n.share / 6.0);
  if (on.friction_mode == FrictionMode::STICK)
    addStick(on, n, w, out);
  else if (on.friction * n.force > 0.0 && on.friction_mode == FrictionMode::SLIP)
    addSlip(on, n, out);
  else if (on.friction * n.force > 0.0)
    addCoulomb(on, n, w, out);
  return out;
}

}  // namespace tether_monitor::core
