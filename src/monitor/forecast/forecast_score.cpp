#include "tether_monitor/monitor/forecast/forecast_score.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr std::array<double, 8> BOUNDS{0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0};
constexpr double CALM = 10.0;          // [s] below the limit that separate two events
constexpr double WARNING = 0.5;        // probability
constexpr double EARLY = 10.0;         // [s] ahead
constexpr double LONGEST_PAUSE = 3.0;  // [s] in a warning that stands

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

ForecastScore::Sums ForecastScore::evaluate() const
{
  Sums sums;
  const auto nextOf = [](const std::vector<double>& times, double t)
  {
    const auto next = std::upper_bound(times.begin(), times.end(), t);
    return next == times.end() ? 1e300 : *next;
  };
  double spell_began = -1.0, spell_ended = -1e300, horizon = 0.0;
  const auto endSpell = [&]
  {
    if (spell_began < 0.0)
      return;
    const bool came = nextOf(over_times_, spell_began) <= spell_ended + horizon;
    const bool is_known = came || now_ >= spell_began + horizon;
    sums.warnings += is_known;
    sums.false_warnings += is_known && !came;
    spell_began = -1.0;
  };
  for (const Made& made : made_)
  {
    if (made.t - spell_ended > CALM)
      endSpell();
    const bool is_warning = !made.was_estimate_over && made.probability >= WARNING;
    if (is_warning && spell_began < 0.0)
      spell_began = made.t;
    if (is_warning || made.was_estimate_over)
    {
      spell_ended = made.t;
      horizon = made.horizon;
    }
    if (made.was_estimate_over)
      continue;
    if (made.t + made.horizon > now_)
      continue;
    const bool came = nextOf(over_times_, made.t) <= made.t + made.horizon;
    const std::size_t k = classOf(made.probability);
    ++sums.forecasts[k];
    sums.came_true[k] += came;
    sums.probability[k] += made.probability;
    sums.square += std::pow(made.probability - (came ? 1.0 : 0.0), 2);
  }
  endSpell();
  // An event that comes before there was any time to warn of it is none to be warned of.
  for (const double onset : onsets_)
  {
    const bool could = std::any_of(made_.begin(), made_.end(),
                                   [&](const Made& made)
                                   {
                                     const double ahead = onset - made.t;
                                     return !made.was_over && ahead >= EARLY && ahead <= made.horizon;
                                   });
    if (!could)
      continue;
    double first = onset, last = onset;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made)
    {
      if (made->t >= onset || made->was_over)
        continue;
      if (last - made->t > LONGEST_PAUSE || onset - made->t > made->horizon)
        break;
      if (made->probability < WARNING && !made->was_estimate_over)
        continue;
      first = last = made->t;
    }
    ++sums.events;
    sums.warned += onset - first >= EARLY;
    sums.lead.push_back(onset - first);
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
    r.warned += sums.warned;
    r.warnings += sums.warnings;
    r.false_warnings += sums.false_warnings;
    total.lead.insert(total.lead.end(), sums.lead.begin(), sums.lead.end());
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
  if (!total.lead.empty())
  {
    const auto middle = total.lead.begin() + static_cast<std::ptrdiff_t>(total.lead.size() / 2);
    std::nth_element(total.lead.begin(), middle, total.lead.end());
    r.median_lead_time = *middle;
  }
  return r;
}

}  // namespace tether_monitor::monitor
