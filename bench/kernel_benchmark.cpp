// Google Benchmark: cost of a Newton iteration by its parts, of a step, of a simulated second; for every kernel
// that the machine can run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>

#include "bench/member_elimination.h"
#include "tether_monitor/core/assembly/deployed_cable.h"
#include "verification/reference_cases.h"

namespace tether_monitor::bench
{
namespace
{
constexpr int COUNTS[] = {20, 50, 100, 200, 1000};

// Case A in the middle of its motion.
struct Setting
{
  explicit Setting(int elements, const core::kernel::Kernel& kernel)
    : motion(cases().front()),
      model(core::CableModel(motion.tether, elements, motion.sea).withKernel(kernel)),
      cable(model),
      stepper(model, core::StepperOptions())
  {
    core::SteadyStateSolver statics(model.nodes());
    core::NodeField shape;
    statics.solve(model, motion.start, shape);
    state = core::CableState(0.0, shape, motion.start.velocity);
    advance(20.0);
  }
  core::SolveReport advance(double duration)
  {
    core::SolveReport total;
    for (const double end = state.time + duration; state.time < end - 1e-9;)
    {
      const double t0 = state.time, t = t0 + 0.05;
      core::BoundaryConditions ends;
      ends.vessel = core::EndTrajectory::between(t0, motion.vessel(t0), t, motion.vessel(t));
      ends.vehicle = core::EndTrajectory::between(t0, motion.vehicle(t0), t, motion.vehicle(t));
      total.addCost(stepper.advance(model, ends, t, state));
    }
    return total;
  }

  Case motion;
  core::CableModel model;
  core::DeployedCable cable;
  core::AdaptiveStepper stepper;
  core::CableState state;
};

const core::kernel::Kernel& kernelOf(const benchmark::State& run)
{
  return *core::kernel::available()[run.range(1)];
}

void label(benchmark::State& run)
{
  run.SetLabel(kernelOf(run).name);
  run.counters["time_per_element"] =
      benchmark::Counter(static_cast<double>(run.range(0)),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// Assembly of residual and symmetric tangent, elimination, update of coordinates: what an iteration of a step
// does.
void newtonIteration(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::CableState trial = s.state;
  core::NodeField b(s.model.nodes());
  core::BlockTridiagonal tangent(s.model.nodes());
  const core::TangentWeights weights{1.0, 0.03, 0.0006};
  for (auto _ : run)
  {
    s.cable.assemble(trial, weights, b, tangent, core::TangentKind::SYMMETRIC);
    core::imposePrescribedEnds(core::PrescribedEnds(), tangent);
    b.front().head<3>().setZero();
    b.back().head<3>().setZero();
    tangent.solve(s.model.kernel().solve, b);
    for (std::size_t i = 0; i < b.size(); ++i)
    {
      trial.a[i] -= b[i];
      trial.v[i] -= weights.damping * b[i];
      trial.q[i] -= weights.stiffness * b[i];
    }
    benchmark::ClobberMemory();
  }
  label(run);
}

void residual(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::NodeField b(s.model.nodes());
  for (auto _ : run)
  {
    s.cable.assemble(s.state, b);
    benchmark::ClobberMemory();
  }
  label(run);
}

template <core::TangentKind KIND>
void assembly(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::NodeField b(s.model.nodes());
  core::BlockTridiagonal tangent(s.model.nodes());
  for (auto _ : run)
  {
    s.cable.assemble(s.state, {1.0, 0.03, 0.0006}, b, tangent, KIND);
    benchmark::ClobberMemory();
  }
  label(run);
}

void elimination(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::NodeField right(s.model.nodes()), b = right;
  core::BlockTridiagonal tangent(s.model.nodes());
  s.cable.assemble(s.state, {1.0, 0.03, 0.0006}, right, tangent, core::TangentKind::SYMMETRIC);
  core::imposePrescribedEnds(core::PrescribedEnds(), tangent);
  for (auto _ : run)
  {
    b = right;
    tangent.solve(s.model.kernel().solve, b);
    benchmark::ClobberMemory();
  }
  label(run);
}

// The same for eight members of an ensemble at once, a lane each; time a member is an eighth. Systems are copied
// in between, and the copy alone is `elimination_members_copy`.
template <bool SOLVES>
void memberElimination(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::NodeField right(s.model.nodes()), expected;
  core::BlockTridiagonal tangent(s.model.nodes());
  s.cable.assemble(s.state, {1.0, 0.03, 0.0006}, right, tangent, core::TangentKind::SYMMETRIC);
  core::imposePrescribedEnds(core::PrescribedEnds(), tangent);
  MemberElimination members(s.model.nodes());
  for (int lane = 0; lane < MemberElimination::MEMBERS; ++lane)
    members.set(lane, tangent, right);
  MemberElimination now = members;
  for (auto _ : run)
  {
    now = members;
    if (SOLVES)
      now.solve(kernelOf(run).name);
    benchmark::ClobberMemory();
  }
  if (SOLVES)
  {
    expected = right;
    tangent.solve(s.model.kernel().solve, expected);
    const int middle = s.model.nodes() / 2;
    if ((now.solution(3, middle) - expected[middle]).norm() > 1e-9 * expected[middle].norm())
      throw std::logic_error("the two eliminations differ");
  }
  label(run);
}

void step(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::SolveReport total;
  for (auto _ : run)
    total.addCost(s.advance(0.05));
  label(run);
  run.counters["iterations_per_step"] = static_cast<double>(total.iterations) / total.steps;
}

void simulatedSecond(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  for (auto _ : run)
    s.advance(1.0);
  label(run);
  run.counters["times_real_time"] = benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
}

// A copy and its restoration: what look-ahead and late measurements cost beside the stepping.
void saveAndRestore(benchmark::State& run)
{
  Setting s(static_cast<int>(run.range(0)), kernelOf(run));
  core::CableState saved = s.state;
  for (auto _ : run)
  {
    saved = s.state;
    s.state = saved;
    benchmark::ClobberMemory();
  }
  label(run);
}

// What the machine can do at most with this kernel's vectors.
void peak(benchmark::State& run)
{
  constexpr long ROUNDS = 10000;
  for (auto _ : run)
    benchmark::DoNotOptimize(kernelOf(run).multiplyAdds(ROUNDS));
  run.SetLabel(kernelOf(run).name);
  run.counters["flops"] =
      benchmark::Counter(static_cast<double>(ROUNDS) * core::kernel::OPERATIONS_A_ROUND * kernelOf(run).width,
                         benchmark::Counter::kIsIterationInvariantRate);
}
}  // namespace

void registerAll()
{
  const int kernels = static_cast<int>(core::kernel::available().size());
  const auto add = [&](const char* name, void (*function)(benchmark::State&))
  {
    auto* benchmark = benchmark::RegisterBenchmark(name, function)->ArgNames({"elements", "kernel"});
    for (int kernel = 0; kernel < kernels; ++kernel)
      for (const int elements : COUNTS)
        benchmark->Args({elements, kernel});
  };
  for (int kernel = 0; kernel < kernels; ++kernel)
    benchmark::RegisterBenchmark("peak", peak)->ArgNames({"elements", "kernel"})->Args({0, kernel});
  add("newton_iteration", newtonIteration);
  add("residual", residual);
  add("assembly_symmetric", assembly<core::TangentKind::SYMMETRIC>);
  add("assembly_complete", assembly<core::TangentKind::COMPLETE>);
  add("elimination", elimination);
  add("elimination_members", memberElimination<true>);
  add("elimination_members_copy", memberElimination<false>);
  add("step", step);
  add("simulated_second", simulatedSecond);
  add("save_and_restore", saveAndRestore);
}
}  // namespace tether_monitor::bench

int main(int count, char** words)
{
  benchmark::Initialize(&count, words);
  tether_monitor::bench::registerAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
