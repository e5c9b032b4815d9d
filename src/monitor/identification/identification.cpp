#include "tether_monitor/monitor/identification/identification.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double SETTLED = 0.25;            // standard deviations that a pass may still change
constexpr double FOULING_MEMORY = 36000.0;  // [s]: within a record it stays

core::CurrentProfile shifted(const core::CurrentProfile& current, const core::Vector3& by)
{
  if (current.samples().empty())
    return core::CurrentProfile(by);
  std::vector<core::CurrentProfile::Sample> samples = current.samples();
  for (core::CurrentProfile::Sample& sample : samples)
    sample.velocity += by;
  return core::CurrentProfile(samples);
}

// What is configured of a parameter becomes what is believed of it.
class Centre
{
 public:
  explicit Centre(const Config& config) : config_(config) { config_.uncertainty.fouling_memory = FOULING_MEMORY; }

  const Config& config() const { return config_; }
  // Of a report about this centre: its factor on the vehicle's drag becomes one on what the user configured.
  void complete(std::vector<ParameterEstimate>& report) const
  {
    for (ParameterEstimate& p : report)
      if (p.name == VEHICLE_DRAG_NAME)
        for (double* of : {&p.mean, &p.stddev, &p.configured})
          *of *= vehicle_drag_;
  }
  void moveTo(const std::vector<ParameterEstimate>& report)
  {
    const auto factor = [&](const char* name)
    {
      const ParameterEstimate* p = findParameter(report, name);
      return p && p->configured > 0.0 ? p->mean / p->configured : 1.0;
    };
    const auto difference = [&](const char* name)
    {
      const ParameterEstimate* p = findParameter(report, name);
      return p ? p->mean - p->configured : 0.0;
    };
    config_.tether.drag_normal *= factor("tether.drag_normal");
    config_.tether.drag_tangential *= factor("tether.drag_tangential");
    config_.tether.mass_per_length *= factor("tether.mass_per_length");
    if (config_.layout.sections.empty() && config_.layout.attachments.empty())
      config_.tether.length *= factor("tether.length");
    config_.vehicle_body.drag_area *= factor(VEHICLE_DRAG_NAME);
    vehicle_drag_ *= factor(VEHICLE_DRAG_NAME);
    config_.environment.current =
        shifted(config_.environment.current,
                core::Vector3(difference("environment.current.x"), difference("environment.current.y"), 0.0));
  }

 private:
  static constexpr const char* VEHICLE_DRAG_NAME = "vehicle.drag";
  Config config_;
  double vehicle_drag_ = 1.0;
};

// (E24): the prior about the centre of the pass is taken out, that about what is configured put in.
void countPriorOnce(const std::vector<ParameterEstimate>& first, std::vector<ParameterEstimate>& report)
{
  for (std::size_t i = 0; i < report.size(); ++i)
  {
    const double share = std::min(1.0, std::pow(report[i].stddev / first[i].configured_stddev, 2));
    if (first[i].configured_stddev > 0.0)
      report[i].mean -= share * (report[i].configured - first[i].configured);
  }
}

bool areNear(const std::vector<ParameterEstimate>& a, const std::vector<ParameterEstimate>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i].mean - b[i].mean) > SETTLED * b[i].stddev)
      return false;
  return true;
}
}  // namespace

Identification identify(const Config& config, const IdentificationPass& pass, int most_passes)
{
  Identification result;
  Centre centre(config);
  std::vector<ParameterEstimate> first, before;
  for (int k = 0; k < most_passes && !result.has_settled; ++k)
  {
    std::optional<std::vector<ParameterEstimate>> report = pass(centre.config());
    if (!report)
      return Identification();
    centre.complete(*report);
    if (k == 0)
      first = *report;
    countPriorOnce(first, *report);
    result.has_settled = k > 0 && areNear(before, *report);
    ++result.passes;
    centre.moveTo(*report);
    before = std::move(*report);
  }
  result.parameters = std::move(before);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    result.parameters[i].configured = first[i].configured;
    result.parameters[i].configured_stddev = first[i].configured_stddev;
  }
  return result;
}

}  // namespace tether_monitor::monitor
