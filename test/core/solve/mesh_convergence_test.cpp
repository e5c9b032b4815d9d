#include "tether_monitor/core/solve/mesh_convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/tethers.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/dynamic_relaxation.h"

namespace tether_monitor::core
{
namespace
{
using MakeModel = std::function<CableModel(int)>;

// Vessel tensions, every 0.1 s, while the vessel heaves by 0.8 m at 8 s: from the steady state, contact settled.
std::vector<double> heave(const CableModel& model, const SteadyEnds& ends, double step)
{
  SteadyStateSolver solver(model.nodes());
  NodeField shape;
  EXPECT_TRUE(findSteadyState(solver, model, ends, shape).converged());
  CableState state(0.0, shape, Vector3::Zero());
  initializeContact(model, state);
  EXPECT_TRUE(settleContact(solver, model, ends, state).converged());
  StepperOptions options;
  options.step = step;
  AdaptiveStepper stepper(model, options);
  std::vector<double> tension;
  for (int k = 1; k <= 300; ++k)
  {
    const auto at = [&](double t)
    {
      const double w = 2.0 * M_PI / 8.0, rest = std::exp(-t * t / 36.0), grown = 1.0 - rest;
      const double rate = grown * w * std::cos(w * t) + t / 18.0 * rest * std::sin(w * t);
      return EndMotion{ends.vessel + Vector3(0.0, 0.0, 0.8 * grown * std::sin(w * t)),
                       Vector3(0.0, 0.0, 0.8 * rate)};
    };
    BoundaryConditions held = heldAt(state);
    held.vessel =
        EndTrajectory::between(state.time, {state.q[0].head<3>(), state.v[0].head<3>()}, 0.1 * k, at(0.1 * k));
    EXPECT_TRUE(stepper.advance(model, held, 0.1 * k, state).converged());
    tension.push_back(endForces(model, state).vessel.norm());
  }
  return tension;
}

// RMS over the mean of what a chosen mesh makes of it, against four times the elements and a quarter of the step.
double error(const MakeModel& make, const SteadyEnds& ends, const MeshSelection& mesh)
{
  const std::vector<double> chosen = heave(make(mesh.elements), ends, mesh.step);
  const std::vector<double> fine = heave(make(4 * mesh.elements), ends, 0.25 * mesh.step);
  double square = 0.0, mean = 0.0;
  for (std::size_t k = 0; k < fine.size(); ++k)
  {
    square += std::pow(chosen[k] - fine[k], 2) / fine.size();
    mean += fine[k] / fine.size();
  }
  return std::sqrt(square) / mean;
}
}  // namespace

// The touchdown point slaps: the error falls slowly with the elements, and what is claimed, of another motion than
// this, is right within a factor.
TEST(SelectMesh, KnowsItsAccuracyOnTheSeabed)
{
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->depth = 100.0;
  sea.seabed->friction = 0.5;
  CableProperties p = towCable();
  p.length = 260.0;
  const MakeModel make = [&](int elements) { return CableModel(p, elements, sea); };
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -1.0};
  ends.vehicle = {200.0, 0.0, -100.0 + 0.5 * p.diameter};
  const MeshSelection mesh = selectMesh(make, ends, 1e-2, StepperOptions());
  EXPECT_LT(error(make, ends, mesh), 3.0 * mesh.error)
      << mesh.elements << " elements, " << mesh.step << " s, expected " << mesh.error;
}

TEST(SelectMesh, KeepsItsAccuracyInWaves)
{
  Environment sea;
  sea.waves.components = {{1.5, 90.0, 0.5, 0.0}, {0.5, 40.0, 0.0, 1.0}};
  CableProperties p = towCable();
  p.length = 150.0;
  const MakeModel make = [&](int elements) { return CableModel(p, elements, sea); };
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -3.0};
  ends.vehicle = {60.0, 0.0, -120.0};
  const MeshSelection mesh = selectMesh(make, ends, 3e-3, StepperOptions());
  EXPECT_LT(error(make, ends, mesh), 3e-3)
      << mesh.elements << " elements, " << mesh.step << " s, expected " << mesh.error;
}

}  // namespace tether_monitor::core
