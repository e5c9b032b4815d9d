#include "tether_monitor/core/assembly/lumped_attachment.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
TEST(LumpedAttachment, AWavePushesItWithItsDragAndItsAcceleration)
{
  Environment waves;
  waves.waves.components = {{1.0, 60.0, 0.0, 0.0}};
  const EnvironmentModel sea(waves);
  const LumpedAttachment load{0, 20.0, 0.05, 0.3};
  const Vector3 place(3.0, 0.0, -4.0);
  for (const double t : {0.3, 1.9, 3.1})
  {
    const WaveMotion water = sea.waves().at(place, t);
    const Vector3 needed = lumpedAttachmentResidual(load, sea, t, {place, Vector3::Zero(), Vector3::Zero()});
    const Vector3 push =
        0.5 * 1025.0 * 0.3 * water.velocity.norm() * water.velocity + 1025.0 * 0.05 * water.acceleration;
    const Vector3 weight(0.0, 0.0, -9.81 * (20.0 - 1025.0 * 0.05));
    EXPECT_LT((needed + push + weight).norm(), 1e-9);
  }
}

TEST(LumpedAttachment, TangentIsTheDerivativeOfItsForce)
{
  // Submerged with drag; and at the waterline without, since the drag's change with submergence is left out of the
  // tangent.
  for (const auto& [load, z] :
       {std::pair(LumpedAttachment{0, 20.0, 0.05, 0.3}, -5.0), {LumpedAttachment{0, 20.0, 0.05, 0.0}, -0.05}})
  {
    const LumpedAttachment& point = load;
    const Vector3 r(1, 2, z), v(0.5, -0.2, 0.3), a(0.1, 0.2, 0.3);
    const TangentWeights weights{0.7, 1.3, 2.1};
    const EnvironmentModel sea{Environment()};
    const Matrix3 tangent = lumpedAttachmentTangent(point, sea, 0.0, {r, v, a}, weights);
    const auto f = [&](const Vector3& x, const Vector3& y, const Vector3& w) {
      return lumpedAttachmentResidual(point, sea, 0.0, {x, y, w});
    };
    const double h = 1e-6;
    for (int i = 0; i < 3; ++i)
    {
      const Vector3 d = h * Vector3::Unit(i);
      const Vector3 expected = (weights.stiffness * (f(r + d, v, a) - f(r - d, v, a)) +
                                weights.damping * (f(r, v + d, a) - f(r, v - d, a)) +
                                weights.mass * (f(r, v, a + d) - f(r, v, a - d))) /
                               (2 * h);
      EXPECT_TRUE(matricesNear(tangent.col(i), expected, 1e-4)) << i;
    }
  }
}

}  // namespace tether_monitor::core
