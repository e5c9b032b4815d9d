#include "tether_monitor/core/assembly/element_assembly.h"

#include <algorithm>

#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"

namespace tether_monitor::core
{
namespace
{
using namespace kernel;  // NOLINT: all of this file is about the kernels

constexpr int WATER_TABLE = POINTS * WATER_ROWS * BLOCK;

Surroundings surroundings(const EnvironmentModel& environment, const PropertyVariation& variation)
{
  const Vector3 current = environment.waterKinematics(Vector3::Zero(), 0.0).velocity + variation.current;
  return {environment.density(),
          environment.gravity(),
          EnvironmentModel::AIR_DENSITY,
          {current.x(), current.y(), current.z()},
          {variation.shear.x(), variation.shear.y(), variation.shear.z()},
          variation.shear_depth,
          {environment.wind().x(), environment.wind().y(), environment.wind().z()},
          environment.hasWind()};
}

// Places of the integration points, [POINTS][3][BLOCK] in the world, and the current there.
void sampleCurrent(const EnvironmentModel& environment, const CableState& state, int first, int count,
                   const double length_of[], double (&place)[POINTS][3][BLOCK], double* table)
{
  const CurrentProfile& profile = environment.current();
  for (int lane = 0; lane < BLOCK; ++lane)
  {
    // The last element stands for those that are missing in its block.
    const int i = std::min(lane, count - 1);
    const auto e = elementCoords(state.q, first + i);
    for (int g = 0; g < POINTS; ++g)
    {
      const Vector3 r = interpolate(shapeFunctions(QUADRATURE[g].xi, length_of[i]), e);
      Vector3 current = state.deployment.variation.currentAt(r.z());
      if (!profile.samples().empty())
        current += profile.at(r.z());
      for (int k = 0; k < 3; ++k)
      {
        place[g][k][lane] = r[k] + environment.origin()[k];
        table[(g * WATER_ROWS + WATER_VELOCITY + k) * BLOCK + lane] = current[k];
      }
    }
  }
}

void sampleWater(const Kernel& kernel, const EnvironmentModel& environment, const CableState& state, int first,
                 int count, const double length_of[], double* table)
{
  double place[POINTS][3][BLOCK];
  sampleCurrent(environment, state, first, count, length_of, place, table);
  const WaveField& waves = environment.waves();
  for (int g = 0; g < POINTS; ++g)
  {
    double* rows = table + g * WATER_ROWS * BLOCK;
    kernel.waves({place[g][0], place[g][1], place[g][2], count, state.time, waves.constants().data(),
                  static_cast<int>(waves.constants().size()), waves.depth(), waves.isStretched(),
                  rows + WATER_VELOCITY * BLOCK, rows + WATER_ACCELERATION * BLOCK, rows + WATER_SURFACE * BLOCK});
  }
}
}  // namespace

ElementAssembler::ElementAssembler(int elements) : count_(elements), blocks_((elements + BLOCK - 1) / BLOCK)
{
}

void ElementAssembler::set(int i, const ElementParameters& p)
{
  Constants& block = blocks_[i / BLOCK];
  // The last element stands for those that are missing in its block.
  const int last_lane = i + 1 == count_ ? BLOCK - 1 : i % BLOCK;
  for (int lane = i % BLOCK; lane <= last_lane; ++lane)
  {
    const auto put = [&](Constant row, double value) { block.x[row][lane] = value; };
    put(LENGTH, p.length);
    put(MASS, p.mass);
    put(DIAMETER, p.diameter);
    put(AREA, p.area);
    put(DRAG_NORMAL, p.drag_normal);
    put(DRAG_TANGENTIAL, p.drag_tangential);
    put(ADDED_MASS, p.added_mass);
    put(ADDED_MASS_TANGENTIAL, p.added_mass_tangential);
    put(AXIAL_STIFFNESS, p.axial.stiffness);
    put(AXIAL_VISCOSITY, p.axial.damping * p.axial.stiffness);
    put(COMPRESSION_LIMIT, p.axial.compression_limit);
    put(COMPRESSION_STIFFNESS_RATIO, p.axial.compression_stiffness_ratio);
    put(BENDING_STIFFNESS, p.bending_stiffness);
    put(COMPRESSION, p.compression);
    put(NATURAL_STRETCH, p.natural_stretch);
    put(TRANSPORT_GROWTH, p.transport.active ? p.transport.growth : 0.0);
    put(TRANSPORT_ACCELERATION, p.transport.active ? p.transport.acceleration : 0.0);
    put(TRANSPORT_SPEED_A, p.transport.active ? p.transport.speed_a : 0.0);
    put(TRANSPORT_SPEED_B, p.transport.active ? p.transport.speed_b : 0.0);
    put(TRANSPORT_RATE_A, p.transport.active ? p.transport.rate_a : 0.0);
    put(TRANSPORT_RATE_B, p.transport.active ? p.transport.rate_b : 0.0);
    for (int k = 0; k < AxialStiffening::MOST; ++k)
    {
      const bool acts = k < p.axial.stiffening.count;
      put(static_cast<Constant>(STIFFENING_STRAIN + k), acts ? p.axial.stiffening.strain[k] : 0.0);
      put(static_cast<Constant>(STIFFENING_CHANGE + k), acts ? p.axial.stiffening.change[k] : 0.0);
    }
    block.stiffening[lane] = p.axial.stiffening.count > 0;
    block.damping[lane] = p.axial.damping > 0.0;
    block.compression[lane] = p.compression > 0.0;
    block.transport[lane] = p.transport.active;
  }
}

ElementBlock ElementAssembler::block(const EnvironmentModel& environment, const Surroundings& around,
                                     const Kernel& kernel, const CableState& state, int first, int count,
                                     double* water) const
{
  const Constants& constants = blocks_[first / BLOCK];
  const auto any = [](const bool(&flags)[BLOCK])
  { return std::find(flags, flags + BLOCK, true) != flags + BLOCK; };
  ElementBlock out{};
  out.count = count;
  out.nodes_after = count_ - first - count;
  out.constants = constants.x[0];
  out.has_damping = any(constants.damping);
  out.has_compression = any(constants.compression);
  out.has_transport = any(constants.transport);
  out.has_stiffening = any(constants.stiffening);
  out.q = state.q[first].data();
  out.v = state.v[first].data();
  out.a = state.a[first].data();
  out.around = &around;
  if (!environment.isUniform())
  {
    sampleWater(kernel, environment, state, first, count, constants.x[LENGTH], water);
    out.water = water;
  }
  return out;
}

void ElementAssembler::residuals(const Kernel& kernel, const EnvironmentModel& environment,
                                 const CableState& state, int first, int count, ElementCoords* out) const
{
  alignas(64) double water[WATER_TABLE];
  const Surroundings around = surroundings(environment, state.deployment.variation);
  ElementBlock b = block(environment, around, kernel, state, first, count, water);
  b.element_residual = out->data();
  kernel.residuals(b);
}

void ElementAssembler::assemble(const Kernel& kernel, const EnvironmentModel& environment, const CableState& state,
                                const TangentWeights& weights, TangentKind kind, NodeField& residual,
                                BlockTridiagonal& tangent) const
{
  alignas(64) double water[WATER_TABLE];
  const Surroundings around = surroundings(environment, state.deployment.variation);
  residual.front().setZero();
  tangent.diagonal(0).setZero();
  for (int first = 0; first < count_; first += BLOCK)
  {
    ElementBlock b = block(environment, around, kernel, state, first, std::min(BLOCK, count_ - first), water);
    b.mass = weights.mass;
    b.damping = weights.damping;
    b.stiffness = weights.stiffness;
    b.residual = residual[first].data();
    b.diagonal = tangent.diagonalData(first);
    b.upper = tangent.upperData(first);
    b.lower = tangent.lowerData(first);
    if (kind == TangentKind::SYMMETRIC)
      kernel.symmetric(b);
    else
      kernel.complete(b);
  }
}

}  // namespace tether_monitor::core
