#include "tether_monitor/monitor/forecast/forecast_score.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr std::array<double, 8> BOUNDS{0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0};
constexpr double CALM = 10.0;                              // [s] below the limit that separate two events
constexpr std::array<double, 3> WARNINGS{0.5, 0.8, 0.95};  // probabilities
constexpr double EARLY = 10.0;                             // [s] ahead
constexpr double LONGEST_PAUSE = 3.0;                      // [s] in a warning that stands

double medianOf(std::vector<double> x)
{
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return x.empty() ? TetherForecast::NONE : *middle;
}

std::size_t classOf(double probability)
{
  const auto above = std::upper_bound(BOUNDS.begin() + 1, BOUNDS.end() - 1, probability);
  return static_cast<std::size_t>(above - BOUNDS.begin()) - 1;
}
}  // namespace

void ForecastScore::observe(double t, bool is_over)
{
  now_ = t;
  is_over_ = is_over;
  if (!is_over)
    return;
  if (t - last_over_ > CALM)
    onsets_.push_back(t);
  last_over_ = t;
  over_times_.push_back(t);
}

void ForecastScore::add(const TetherForecast& forecast, bool is_estimate_over)
{
  if (forecast.members > 0)
    made_.push_back({forecast.t, forecast.horizon, forecast.probability_over_tension, is_over_, is_estimate_over});
}

void ForecastScore::add(const ForecastScore& other)
{
  others_.push_back(other.evaluate());
  others_.insert(others_.end(), other.others_.begin(), other.others_.end());
}

double ForecastScore::nextOver(double t) const
{
  const auto next = std::upper_bound(over_times_.begin(), over_times_.end(), t);
  return next == over_times_.end() ? 1e300 : *next;
}

void ForecastScore::countForecasts(Sums& sums) const
{
  for (const Made& made : made_)
  {
    if (made.was_estimate_over || made.t + made.horizon > now_)
      continue;
    const bool came = nextOver(made.t) <= made.t + made.horizon;
    const std::size_t k = classOf(made.probability);
    ++sums.forecasts[k];
    sums.came_true[k] += came;
    sums.probability[k] += made.probability;
    sums.square += std::pow(made.probability - (came ? 1.0 : 0.0), 2);
  }
}

void ForecastScore::countWarnings(double probability, WarningSums& sums) const
{
  double began = -1.0, ended = -1e300, horizon = 0.0;
  const auto endSpell = [&]
  {
    if (began < 0.0)
      return;
    const bool came = nextOver(began) <= ended + horizon;
    const bool is_known = came || now_ >= began + horizon;
    sums.warnings += is_known;
    sums.false_warnings += is_known && !came;
    began = -1.0;
  };
  for (const Made& made : made_)
  {
    if (made.t - ended > CALM)
      endSpell();
    const bool is_warning = !made.was_estimate_over && made.probability >= probability;
    if (is_warning && began < 0.0)
      began = made.t;
    if (is_warning || made.was_estimate_over)
    {
      ended = made.t;
      horizon = made.horizon;
    }
  }
  endSpell();
}

bool ForecastScore::couldBeKnown(double onset) const
{
  return std::any_of(made_.begin(), made_.end(),
                     [&](const Made& made)
                     {
                       const double ahead = onset - made.t;
                       return !made.was_over && ahead >= EARLY && ahead <= made.horizon;
                     });
}

double ForecastScore::leadTime(double onset, double probability) const
{
  double first = onset;
  for (auto made = made_.rbegin(); made != made_.rend(); ++made)
  {
    if (made->t >= onset || made->was_over)
      continue;
    if (first - made->t > LONGEST_PAUSE || onset - made->t > made->horizon)
      break;
    if (made->probability >= probability || made->was_estimate_over)
      first = made->t;
  }
  return onset - first;
}

ForecastScore::Sums ForecastScore::evaluate() const
{
  Sums sums;
  countForecasts(sums);
  for (std::size_t k = 0; k < WARNINGS.size(); ++k)
    countWarnings(WARNINGS[k], sums.warnings[k]);
  for (const double onset : onsets_)
  {
    if (!couldBeKnown(onset))
      continue;
    ++sums.events;
    for (std::size_t k = 0; k < WARNINGS.size(); ++k)
    {
      const double lead = leadTime(onset, WARNINGS[k]);
      sums.warnings[k].warned += lead >= EARLY;
      sums.warnings[k].lead.push_back(lead);
    }
  }
  return sums;
}

ForecastScore::Result ForecastScore::result() const
{
  std::vector<Sums> all = others_;
  all.push_back(evaluate());
  Result r;
  Sums total;
  for (const Sums& sums : all)
  {
    for (std::size_t k = 0; k + 1 < BOUNDS.size(); ++k)
    {
      total.forecasts[k] += sums.forecasts[k];
      total.came_true[k] += sums.came_true[k];
      total.probability[k] += sums.probability[k];
    }
    total.square += sums.square;
    r.events += sums.events;
    for (std::size_t k = 0; k < WARNINGS.size(); ++k)
    {
      WarningSums& w = total.warnings[k];
      w.warned += sums.warnings[k].warned;
      w.warnings += sums.warnings[k].warnings;
      w.false_warnings += sums.warnings[k].false_warnings;
      w.lead.insert(w.lead.end(), sums.warnings[k].lead.begin(), sums.warnings[k].lead.end());
    }
  }
  long forecasts = 0;
  for (std::size_t k = 0; k + 1 < BOUNDS.size(); ++k)
  {
    const auto n = static_cast<double>(std::max(total.forecasts[k], 1L));
    forecasts += total.forecasts[k];
    r.reliability.push_back({BOUNDS[k], BOUNDS[k + 1], total.forecasts[k], total.probability[k] / n,
                             static_cast<double>(total.came_true[k]) / n});
  }
  r.brier_score = total.square / static_cast<double>(std::max(forecasts, 1L));
  for (std::size_t k = 0; k < WARNINGS.size(); ++k)
  {
    const WarningSums& w = total.warnings[k];
    r.warnings.push_back({WARNINGS[k], w.warned, medianOf(w.lead), w.warnings, w.false_warnings});
  }
  return r;
}

}  // namespace tether_monitor::monitor
