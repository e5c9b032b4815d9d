#include "tether_monitor/core/assembly/element_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/matrix_compare.h"
#include "support/tethers.h"
#include "tether_monitor/core/element/quadrature.h"

namespace tether_monitor::core
{
class ElementProperty : public ::testing::TestWithParam<unsigned>
{
 protected:
  // Forces of the energies alone: no water, no motion.
  static ElementCoords conservativeForce(const ElementParameters& p, const ElementCoords& q)
  {
    ElementMotion at{q, ElementCoords::Zero(), ElementCoords::Zero()};
    ElementCoords force;
    elementResidual(p, EnvironmentModel(air()), at, force);
    return force;
  }
  static double potential(const ElementParameters& p, const ElementCoords& q)
  {
    return elementEnergy(p, air().gravity, q, ElementCoords::Zero()).total();
  }
  static ElementCoords moved(const ElementCoords& q, const Eigen::Matrix3d& R, const Vector3& shift)
  {
    ElementCoords out;
    for (int i = 0; i < 4; ++i)
      out.segment<3>(3 * i) = R * q.segment<3>(3 * i);
    out.segment<3>(0) += shift;
    out.segment<3>(6) += shift;
    return out;
  }
};

TEST_P(ElementProperty, ForceIsTheGradientOfTheEnergy)
{
  RandomElement random(GetParam());
  const ElementCoords force = conservativeForce(random.p, random.motion.q);
  for (int i = 0; i < 12; ++i)
  {
    const double h = 1e-6;
    ElementCoords hi = random.motion.q, lo = random.motion.q;
    hi[i] += h;
    lo[i] -= h;
    const double difference = (potential(random.p, hi) - potential(random.p, lo)) / (2.0 * h);
    // Rounding of the energy (weight and strain) and the truncation of the difference, whichever is larger.
    const double rounding = 2e-15 *
                            (std::abs(potential(random.p, hi)) + random.p.axial.stiffness +
                             12.0 * random.p.bending_stiffness / std::pow(random.p.length, 3) * 4e4) /
                            h;
    EXPECT_NEAR(force[i], difference, 2e-6 * force.norm() + rounding) << "coordinate " << i;
  }
}

TEST_P(ElementProperty, TangentIsTheDerivativeOfTheResidual)
{
  RandomElement random(GetParam());
  Environment stream;
  stream.current = CurrentProfile(Vector3(0.4, -0.3, 0.1));
  const EnvironmentModel sea(stream);
  const ElementMotion& m = random.motion;
  ElementCoords residual;
  ElementMatrix mass, damping, stiffness;
  elementResidual(random.p, sea, m, {1.0, 0.0, 0.0}, residual, mass);
  elementResidual(random.p, sea, m, {0.0, 1.0, 0.0}, residual, damping);
  elementResidual(random.p, sea, m, {0.0, 0.0, 1.0}, residual, stiffness);
  const auto difference = [&](ElementCoords ElementMotion::*part, int i)
  {
    const double h = part == &ElementMotion::a ? 1.0 : 1e-6;  // linear in the acceleration: no truncation
    ElementMotion hi = m, lo = m;
    (hi.*part)[i] += h;
    (lo.*part)[i] -= h;
    ElementCoords above, below;
    elementResidual(random.p, sea, hi, above);
    elementResidual(random.p, sea, lo, below);
    return ElementCoords((above - below) / (2.0 * h));
  };
  for (int i = 0; i < 12; ++i)
  {
    EXPECT_TRUE(matricesNear(mass.col(i), difference(&ElementMotion::a, i), 1e-5 * (1.0 + mass.norm())));
    EXPECT_TRUE(matricesNear(damping.col(i), difference(&ElementMotion::v, i), 1e-5 * (1.0 + damping.norm())));
    EXPECT_TRUE(matricesNear(stiffness.col(i), difference(&ElementMotion::q, i), 1e-5 * stiffness.norm()));
  }
}

TEST_P(ElementProperty, ResidualIsTheSameWithAndWithoutTangent)
{
  RandomElement random(GetParam());
  ElementCoords with, without;
  ElementMatrix tangent;
  elementResidual(random.p, EnvironmentModel(Environment()), random.motion, {1.0, 1.0, 1.0}, with, tangent);
  elementResidual(random.p, EnvironmentModel(Environment()), random.motion, without);
  EXPECT_TRUE(matricesNear(with, without, 1e-12 * (1.0 + with.norm())));
}

TEST_P(ElementProperty, RigidMotionChangesNoElasticEnergyAndTurnsTheForce)
{
  RandomElement random(GetParam());
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(random.uniform(0.1, 3.0), random.vector(1.0).normalized()).toRotationMatrix();
  const ElementCoords q = random.motion.q;
  const ElementCoords turned = moved(q, R, random.vector(30.0));
  random.p.mass = 0.0;  // elastic part only
  const ElementEnergy before = elementEnergy(random.p, 0.0, q, ElementCoords::Zero());
  const ElementEnergy after = elementEnergy(random.p, 0.0, turned, ElementCoords::Zero());
  EXPECT_NEAR(after.axial, before.axial, 1e-8 * before.axial);
  EXPECT_NEAR(after.bending, before.bending, 1e-8 * (before.bending + 1e-6));
  const ElementCoords force = conservativeForce(random.p, q);
  EXPECT_TRUE(
      matricesNear(conservativeForce(random.p, turned), moved(force, R, Vector3::Zero()), 1e-7 * force.norm()));
}

TEST_P(ElementProperty, ElasticForcesHaveNoNetForceAndNoNetMoment)
{
  RandomElement random(GetParam());
  random.p.mass = 0.0;
  const ElementCoords q = random.motion.q;
  const ElementCoords f = conservativeForce(random.p, q);
  EXPECT_LT((f.segment<3>(0) + f.segment<3>(6)).norm(), 1e-10 * f.norm());
  Vector3 moment = Vector3::Zero();
  for (int i = 0; i < 4; ++i)
    moment += (q.segment<3>(3 * i) - (i % 2 == 0 ? Vector3(q.segment<3>(0)) : Vector3::Zero()))
                  .cross(f.segment<3>(3 * i));
  EXPECT_LT(moment.norm(), 1e-9 * f.norm() * random.p.length);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ElementProperty, ::testing::Range(1u, 31u));

TEST(ElementResponse, UnstretchedStraightElementIsForceFree)
{
  RandomElement random(1);
  random.p.mass = 0.0;
  ElementMotion rest{ElementCoords::Zero(), ElementCoords::Zero(), ElementCoords::Zero()};
  rest.q << 0, 0, -10, 1, 0, 0, random.p.length, 0, -10, 1, 0, 0;
  ElementCoords force;
  elementResidual(random.p, EnvironmentModel(air()), rest, force);
  EXPECT_LT(force.norm(), 1e-9 * random.p.axial.stiffness);
}

TEST(ElementResponse, AddedMassAcrossAndAlong)
{
  RandomElement random(3);
  ElementParameters& p = random.p;
  p.added_mass = 0.9;
  p.added_mass_tangential = 0.25;
  ElementMotion push{ElementCoords::Zero(), ElementCoords::Zero(), ElementCoords::Zero()};
  push.q << 0, 0, -10, 1, 0, 0, p.length, 0, -10, 1, 0, 0;
  push.a << 2, 3, 0, 0, 0, 0, 2, 3, 0, 0, 0, 0;
  ElementCoords force;
  elementResidual(p, EnvironmentModel(Environment()), push, force);
  const double water = 1025.0 * p.area;
  EXPECT_NEAR(force[0] + force[6], p.length * (p.mass + 0.25 * water) * 2.0, 1e-9 * force.norm());
  EXPECT_NEAR(force[1] + force[7], p.length * (p.mass + 0.9 * water) * 3.0, 1e-9 * force.norm());
}

TEST(ElementResponse, AFoldBetweenTheIntegrationPointsCostsEnergy)
{
  // A slope at a node that points backwards, the element otherwise as long as it should be.
  RandomElement random(2);
  random.p.bending_stiffness = 0.0;
  const double L = random.p.length;
  ElementCoords straight, folded;
  straight << 0, 0, 0, 1, 0, 0, L, 0, 0, 1, 0, 0;
  folded = straight;
  folded[3] = -1.7;
  const double EA = random.p.axial.stiffness;
  EXPECT_LT(elementEnergy(random.p, 0.0, straight, ElementCoords::Zero()).axial, 1e-12 * EA * L);
  EXPECT_GT(elementEnergy(random.p, 0.0, folded, ElementCoords::Zero()).axial,
            0.9 * AXIAL_AT_NODES * L * 0.5 * EA * std::pow(0.5 * (1.7 * 1.7 - 1.0), 2));
}

TEST(ElementResponse, WeightInWaterIsTheSubmergedWeight)
{
  RandomElement random(3);
  random.p.bending_stiffness = 0.0;
  ElementMotion rest{ElementCoords::Zero(), ElementCoords::Zero(), ElementCoords::Zero()};
  rest.q << 0, 0, -10, 1, 0, 0, random.p.length, 0, -10, 1, 0, 0;
  ElementCoords force;
  const EnvironmentModel sea{Environment()};
  elementResidual(random.p, sea, rest, force);
  const double weight = (random.p.mass - sea.density() * random.p.area) * sea.gravity() * random.p.length;
  EXPECT_NEAR(force[2] + force[8], weight, 1e-10 * std::abs(weight) + 1e-12);

  rest.q[2] = rest.q[8] = 10.0;  // above the surface: dry
  elementResidual(random.p, sea, rest, force);
  EXPECT_NEAR(force[2] + force[8], random.p.mass * sea.gravity() * random.p.length,
              1e-10 * weight * weight + 1e-9);
}

}  // namespace tether_monitor::core
