#include "tether_monitor/monitor/way_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double SLOWEST = 0.25, FASTEST = 2.0;  // waves [rad/s]
constexpr int GRID = 24;
constexpr double LEAST_PERIODS = 0.9;  // of a wave that the samples can tell from a line
constexpr double SMALL = 1e-4;         // squared noise over squared wave height [-]
constexpr double DOUBT = 0.15;         // about the way, over the velocity in the waves [-]
constexpr double LEAST_NUMBER = 12;    // samples for a wave
using Terms = Eigen::Vector4d;         // line, then cosine and sine
using Normal = Eigen::Matrix4d;

struct Fit
{
  Terms terms = Terms::Zero();
  double rate = 0.0;
  double left = std::numeric_limits<double>::infinity();  // sum of squares
};

// rate 0: the line alone.
Fit fit(const WaySample* samples, std::size_t count, double t, bool level, double rate)
{
  const double datum = samples[count - 1].value;
  Normal N = Normal::Zero();
  Terms b = Terms::Zero();
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double dt = samples[i].t - t, y = samples[i].value - datum;
    const Terms row(1.0, level ? 0.0 : dt, rate > 0.0 ? std::cos(rate * dt) : 0.0,
                    rate > 0.0 ? std::sin(rate * dt) : 0.0);
    N += row * row.transpose();
    b += y * row;
    total += y * y;
  }
  const double weight = static_cast<double>(count);
  N.diagonal() += Terms(1e-12, level ? 1.0 : 1e-12, SMALL, SMALL) * weight;
  Fit found;
  found.rate = rate;
  found.terms = N.ldlt().solve(b);
  found.left = std::max(total - b.dot(found.terms), 0.0);
  found.terms[0] += datum;
  return found;
}
}  // namespace

Way fitWay(const WaySample* samples, std::size_t count, double t, bool level)
{
  const double span = samples[count - 1].t - samples[0].t;
  Fit best = fit(samples, count, t, level || !(span > 0.0), 0.0);
  const double slowest = std::max(SLOWEST, LEAST_PERIODS * 2.0 * M_PI / std::max(span, 1e-3));
  for (int k = 0; k < GRID && count >= LEAST_NUMBER && slowest < FASTEST; ++k)
  {
    const double rate = slowest * std::pow(FASTEST / slowest, k / (GRID - 1.0));
    const Fit other = fit(samples, count, t, level, rate);
    if (other.left < best.left)
      best = other;
  }
  Way way;
  way.position = best.terms[0];
  way.velocity = best.terms[1];
  way.wave_rate = best.rate;
  way.wave_height = std::sqrt(0.5) * best.terms.tail<2>().norm();
  const double rest = std::sqrt(best.left / static_cast<double>(count));
  const double swing = std::hypot(way.wave_height, rest);
  const double rate = way.wave_rate > 0.0 ? way.wave_rate : SLOWEST;
  way.velocity_stddev = level ? 0.0 : DOUBT * rate * swing;
  return way;
}

}  // namespace tether_monitor::monitor
