#include "tether_monitor/core/integrator.h"

#include <cmath>
#include <stdexcept>

#include "tether_monitor/core/bounds.h"
#include "tether_monitor/core/held_ends.h"

namespace tether_monitor::core
{
GeneralizedAlpha::GeneralizedAlpha(int nodes, double spectral_radius, const NewtonOptions& options)
  : options_(options), residual_(nodes, NodeCoords::Zero()), tangent_(nodes)
{
  BoundsCheck check;
  check.within("spectral_radius", spectral_radius, 0.0, 1.0, "[-]");
  throwIfAny("GeneralizedAlpha", check.problems());
  // Chung & Hulbert (1993): least damping of slow motion for the wanted damping of fast motion.
  alpha_m_ = (2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0);
  alpha_f_ = spectral_radius / (spectral_radius + 1.0);
  gamma_ = 0.5 - alpha_m_ + alpha_f_;
  beta_ = 0.25 * (1.0 + alpha_f_ - alpha_m_) * (1.0 + alpha_f_ - alpha_m_);
  trial_ = CableState(0.0, residual_, Vector3::Zero());
}

void GeneralizedAlpha::placeEnds(const EndPaths& ends)
{
  const double t = trial_.time;
  const auto place = [&](const EndPath& path, std::size_t node)
  {
    trial_.q[node].head<3>() = path.position(t);
    trial_.v[node].head<3>() = path.velocity(t);
    trial_.a[node].head<3>() = path.acceleration(t);
  };
  place(ends.vessel, 0);
  place(ends.vehicle, trial_.q.size() - 1);
}

SolveReport GeneralizedAlpha::step(const CableModel& model, const EndPaths& ends, double h, CableState& state)
{
  const std::size_t n = state.q.size();
  const double scale = (1.0 - alpha_f_) / (1.0 - alpha_m_);
  const TangentWeights weights{1.0, gamma_ * h * scale, beta_ * h * h * scale};

  // Predictor: the acceleration stays; (M12) gives the coordinates.
  trial_.time = state.time + h;
  trial_.step = h;
  for (std::size_t i = 0; i < n; ++i)
  {
    trial_.a[i] = state.a[i];
    trial_.aux[i] = (state.a[i] - alpha_m_ * state.aux[i]) / (1.0 - alpha_m_);
    trial_.v[i] = state.v[i] + h * ((1.0 - gamma_) * state.aux[i] + gamma_ * trial_.aux[i]);
    trial_.q[i] = state.q[i] + h * state.v[i] + h * h * ((0.5 - beta_) * state.aux[i] + beta_ * trial_.aux[i]);
  }
  placeEnds(ends);

  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;
  double previous = 0.0;
  for (int k = 0;; ++k)
  {
    model.assemble(trial_.q, trial_.v, trial_.a, weights, residual_, tangent_);
    const ResidualSize size = holdEnds(model, trial_.q, options_, HeldEnds(), residual_);
    report.residual = size.largest;
    if (size.largest <= size.tolerance)
    {
      report.status = SolveStatus::CONVERGED;
      report.steps = 1;
      std::swap(state, trial_);
      return report;
    }
    const bool diverging = k >= 3 && size.largest > 2.0 * previous;
    if (k == options_.max_iterations || diverging)
      return report;
    previous = size.largest;
    holdEnds(HeldEnds(), tangent_);
    ++report.iterations;
    if (!std::isfinite(size.largest) || !tangent_.solve(residual_))
    {
      report.status = SolveStatus::SINGULAR;
      return report;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      trial_.a[i] -= residual_[i];
      trial_.aux[i] -= scale * residual_[i];
      trial_.v[i] -= weights.damping * residual_[i];
      trial_.q[i] -= weights.stiffness * residual_[i];
    }
  }
}

SolveReport GeneralizedAlpha::initialiseAcceleration(const CableModel& model, const EndPaths& ends,
                                                     CableState& state)
{
  SolveReport report;
  trial_ = state;
  for (NodeCoords& a : trial_.a)
    a.setZero();
  placeEnds(ends);
  model.assemble(trial_.q, trial_.v, trial_.a, TangentWeights{1.0, 0.0, 0.0}, residual_, tangent_);
  report.residual = holdEnds(model, trial_.q, options_, HeldEnds(), residual_).largest;
  holdEnds(HeldEnds(), tangent_);
  report.iterations = 1;
  if (!std::isfinite(report.residual) || !tangent_.solve(residual_))
  {
    report.status = SolveStatus::SINGULAR;
    return report;
  }
  for (std::size_t i = 0; i < trial_.a.size(); ++i)
    trial_.a[i] -= residual_[i];
  trial_.aux = trial_.a;
  std::swap(state, trial_);
  return report;
}

}  // namespace tether_monitor::core
