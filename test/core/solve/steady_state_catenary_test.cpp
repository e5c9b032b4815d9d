// Steady states against Irvine's elastic catenary (Irvine, Cable Structures, 1981, ch. 1), solved here.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
struct IrvineCatenary
{
  double H, V;  // horizontal force and vertical force at the upper end [N]

  // Span l and drop h [m] of a cable of length L, weight w per metre, stiffness EA, by Newton's method on (H, V).
  IrvineCatenary(double l, double h, double L, double w, double EA) : H(0.5 * w * L), V(0.7 * w * L)
  {
    for (int i = 0; i < 200; ++i)
    {
      const auto miss = [&](double H_, double V_)
      {
        const double x = H_ * L / EA + H_ / w * (std::asinh(V_ / H_) - std::asinh((V_ - w * L) / H_));
        const double z =
            V_ * L / EA - 0.5 * w * L * L / EA + (std::hypot(H_, V_) - std::hypot(H_, V_ - w * L)) / w;
        return Eigen::Vector2d(x - l, z - h);
      };
      const double d = 1e-6 * w * L;
      Eigen::Matrix2d J;
      J << (miss(H + d, V) - miss(H - d, V)) / (2 * d), (miss(H, V + d) - miss(H, V - d)) / (2 * d);
      const Eigen::Vector2d step = J.inverse() * miss(H, V);
      double share = 1.0;
      while (H - share * step[0] <= 0.0)
        share *= 0.5;
      H -= share * step[0];
      V -= share * step[1];
      if (step.norm() < 1e-11 * w * L)
        break;
    }
  }
  double upper() const { return std::hypot(H, V); }
};

double wetWeight(const CableProperties& p, const Environment& sea)
{
  return (p.mass_per_length - sea.water_density * p.displacedArea()) * sea.gravity;
}
}  // namespace

struct Hang
{
  double span, drop;
};

class ElasticCatenary : public ::testing::TestWithParam<Hang>
{
};

TEST_P(ElasticCatenary, EndForcesWithin1e4With20Elements)
{
  const CableProperties p = towCable();
  const Environment sea;
  const double w = wetWeight(p, sea);
  const Hang hang = GetParam();
  const IrvineCatenary exact(hang.span, hang.drop, p.length, w, p.axial_stiffness);
  const EndForces forces =
      steadyForces(CableModel(p, 20, sea), {{0, 0, -5}, {-hang.span, 0, -5 - hang.drop}, Vector3::Zero()});
  // The tether pulls the vessel end towards -x and down, the vehicle end towards +x and up.
  const Vector3 vessel(-exact.H, 0.0, -exact.V);
  const Vector3 vehicle(exact.H, 0.0, exact.V - w * p.length);
  EXPECT_LT((forces.vessel - vessel).norm(), 1e-4 * vessel.norm());
  EXPECT_LT((forces.vehicle - vehicle).norm(), 1e-4 * vehicle.norm());
}

INSTANTIATE_TEST_SUITE_P(Spans, ElasticCatenary,
                         ::testing::Values(Hang{330.0, 150.0}, Hang{390.0, 0.0}, Hang{250.0, 300.0},
                                           Hang{380.0, 100.0}));

TEST(ElasticCatenary, SoftCableStretches)
{
  // Hanging stretch dL = (W L + w L^2 / 2) / EA with the lower end held where a weight W would bring it.
  CableProperties p = towCable();
  p.axial_stiffness = 2.0e6;
  const Environment sea;
  const double w = wetWeight(p, sea), W = 2000.0;
  const double stretch = (W * p.length + 0.5 * w * p.length * p.length) / p.axial_stiffness;
  const EndForces forces =
      steadyForces(CableModel(p, 20, sea), {{0, 0, -5}, {0, 0, -405 - stretch}, Vector3::Zero()});
  // Green-Lagrange: T = EA eps |r'| is stiffer than EA (|r'| - 1) by 1.5 times the strain, here 0.2 %.
  EXPECT_NEAR(forces.vehicle.z(), W, 0.01 * W);
  EXPECT_NEAR(-forces.vessel.z(), forces.vehicle.z() + w * p.length, 1e-6 * W);
}

TEST(ElasticCatenary, EndTensionConvergesWithOrder35InElementLength)
{
  const CableProperties p = towCable();
  const Environment sea;
  const IrvineCatenary exact(380.0, 100.0, p.length, wetWeight(p, sea), p.axial_stiffness);
  double error[3];
  const int elements[3] = {5, 10, 20};
  for (int i = 0; i < 3; ++i)
    error[i] =
        std::abs(steadyForces(CableModel(p, elements[i], sea), {{0, 0, -5}, {-380, 0, -105}, Vector3::Zero()})
                     .vessel.norm() -
                 exact.upper());
  RecordProperty("order_5_10", std::to_string(std::log2(error[0] / error[1])));
  RecordProperty("order_10_20", std::to_string(std::log2(error[1] / error[2])));
  EXPECT_GE(std::log2(error[0] / error[1]), 3.5) << error[0] << " " << error[1];
  EXPECT_GE(std::log2(error[1] / error[2]), 3.5) << error[1] << " " << error[2];
}

}  // namespace tether_monitor::core
