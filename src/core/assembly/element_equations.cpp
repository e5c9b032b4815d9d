#include "tether_monitor/core/assembly/element_equations.h"

#include <Eigen/Dense>

#include "tether_monitor/core/assembly/element_assembly.h"
#include "tether_monitor/core/element/element_matrices.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"

namespace tether_monitor::core
{
namespace
{
CableState stateOf(const ElementMotion& motion)
{
  CableState state(motion.time, NodeField(2), Vector3::Zero());
  for (int node = 0; node < 2; ++node)
  {
    state.q[node] = motion.q.segment<6>(6 * node);
    state.v[node] = motion.v.segment<6>(6 * node);
    state.a[node] = motion.a.segment<6>(6 * node);
  }
  return state;
}
}  // namespace

void elementResidual(const ElementParameters& p, const EnvironmentModel& environment, const ElementMotion& motion,
                     ElementCoords& residual)
{
  ElementAssembler assembler(1);
  assembler.set(0, p);
  assembler.residuals(kernel::best(), environment, stateOf(motion), 0, 1, &residual);
}

void elementResidual(const ElementParameters& p, const EnvironmentModel& environment, const ElementMotion& motion,
                     const TangentWeights& weights, ElementCoords& residual, ElementMatrix& tangent)
{
  ElementAssembler assembler(1);
  assembler.set(0, p);
  NodeField nodes(2);
  BlockTridiagonal matrix(2);
  assembler.assemble(kernel::best(), environment, stateOf(motion), weights, TangentKind::COMPLETE, nodes, matrix);
  residual << nodes[0], nodes[1];
  tangent << matrix.diagonal(0), matrix.upper(0), matrix.lower(0), matrix.diagonal(1);
}

ElementEnergy elementEnergy(const ElementParameters& p, double gravity, const ElementCoords& q,
                            const ElementCoords& v)
{
  ElementEnergy energy{0.0, 0.0, 0.0, 0.0};
  const ShapeMatrix bending = bendingMatrix(p.length) * p.bending_stiffness;
  const ShapeMatrix mass = massMatrix(p.length) * p.mass;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
    {
      energy.bending += 0.5 * bending(i, j) * q.segment<3>(3 * i).dot(q.segment<3>(3 * j));
      energy.kinetic += 0.5 * mass(i, j) * v.segment<3>(3 * i).dot(v.segment<3>(3 * j));
    }
  for (const QuadraturePoint& point : QUADRATURE)
  {
    const double weight = point.weight * p.length;
    const Vector3 slope = interpolate(shapeSlopes(point.xi, p.length), q);
    const double strain = 0.5 * (slope.squaredNorm() / (p.natural_stretch * p.natural_stretch) - 1.0);
    energy.axial += point.axial * p.length * p.natural_stretch * axialEnergy(p.axial, strain);
    energy.weight += weight * p.mass * gravity * interpolate(shapeFunctions(point.xi, p.length), q).z();
  }
  for (const int node : {3, 9})
  {
    const double strain = 0.5 * (q.segment<3>(node).squaredNorm() / (p.natural_stretch * p.natural_stretch) - 1.0);
    energy.axial += AXIAL_AT_NODES * p.length * p.natural_stretch * axialEnergy(p.axial, strain);
  }
  return energy;
}

}  // namespace tether_monitor::core
