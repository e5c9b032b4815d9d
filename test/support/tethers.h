#pragma once

#include <gtest/gtest.h>

#include <random>

#include "tether_monitor/core/assembly/station_profile.h"
#include "tether_monitor/core/element/element_matrices.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::core
{
/// The 400 m tow cable of the paper's first system, with its dry weight.
inline CableProperties towCable()
{
  CableProperties p;
  p.length = 400.0;
  p.diameter = 0.030;
  p.mass_per_length = 1.43;
  p.axial_stiffness = 6.75e7;
  p.axial_damping = 1.0e4 / 6.75e7;
  p.drag_normal = 1.35;
  p.drag_tangential = 0.12566;
  p.working_load = 2.0e4;
  p.breaking_load = 6.0e4;
  return p;
}

/// A uniform tether that the water does not brake and that nothing breaks.
inline CableProperties plainCable(double length, double diameter, double mass_per_length, double axial_stiffness)
{
  CableProperties p;
  p.length = length;
  p.diameter = diameter;
  p.mass_per_length = mass_per_length;
  p.axial_stiffness = axial_stiffness;
  p.working_load = p.breaking_load = 1e9;
  return p;
}

/// No water: nothing but gravity acts.
inline Environment air()
{
  Environment e;
  e.water_density = 0.0;
  return e;
}

/// A random element: a bent, slightly stretched or compressed piece of tether, its parameters and its motion.
struct RandomElement
{
  explicit RandomElement(unsigned seed) : generator(seed)
  {
    const double L = uniform(0.5, 20.0);
    p.length = L;
    p.diameter = uniform(0.005, 0.1);
    p.contact_diameter = p.diameter;
    p.mass = uniform(0.05, 5.0);
    p.area = 0.785 * p.diameter * p.diameter;
    p.drag_normal = uniform(0.5, 2.0);
    p.drag_tangential = uniform(0.0, 0.2);
    p.added_mass = uniform(0.0, 1.5);
    p.added_mass_tangential = 0.3 * p.added_mass;
    const double EA = std::pow(10.0, uniform(3.0, 8.0));
    p.axial = {EA, uniform(0.0, 0.01), EA * uniform(1e-3, 1e-2), 1e-5};  // wide enough for differences
    if (seed % 2 == 1)
      stiffen(EA);
    p.bending_stiffness = uniform(0.0, 100.0);

    const Vector3 chord = vector(1.0).normalized() * L * (1.0 + uniform(-0.01, 0.02));
    const Vector3 start = Vector3(0.0, 0.0, -200.0) + vector(50.0);
    motion.q << start, chord / L + vector(0.15), start + chord, chord / L + vector(0.15);
    for (int i = 0; i < 12; ++i)
    {
      motion.v[i] = uniform(-1.0, 1.0);
      motion.a[i] = uniform(-1.0, 1.0);
    }
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
  Vector3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  // A curve that bends up and down again within the strains of the element.
  void stiffen(double EA)
  {
    p.axial.stiffening.count = 2;
    p.axial.stiffening.strain = {0.0013, 0.0171};
    p.axial.stiffening.change = {2.0 * EA, -1.5 * EA};
  }

  std::mt19937 generator;
  ElementParameters p;
  ElementMotion motion;
};

/// End forces of the steady state between two held ends; fails the calling test by NaN if there is none.
inline EndForces steadyForces(const CableModel& model, const SteadyEnds& ends)
{
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  if (!statics.solve(model, ends, shape).converged())
    return {Vector3::Constant(NAN), Vector3::Constant(NAN)};
  return endForces(model, CableState(0.0, shape, ends.velocity));
}

/// A steady shape; fails the calling test if there is none.
inline NodeField steadyShape(const CableModel& model, const SteadyEnds& ends)
{
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  EXPECT_TRUE(statics.solve(model, ends, shape).converged());
  return shape;
}

/// Both ends held where a state has them.
inline BoundaryConditions heldAt(const CableState& state)
{
  return {EndTrajectory::uniform(state.time, {state.q.front().head<3>(), Vector3::Zero()}),
          EndTrajectory::uniform(state.time, {state.q.back().head<3>(), Vector3::Zero()})};
}

}  // namespace tether_monitor::core
