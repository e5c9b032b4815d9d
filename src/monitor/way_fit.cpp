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
constexpr double OUTLIER = 4.0;        // over the standard deviation of what is left [-]
constexpr double LEAST_NUMBER = 12;    // samples for a wave
using Terms = Eigen::Vector4d;         // line, then cosine and sine
using Normal = Eigen::Matrix4d;

struct Fit
{
  Terms terms = Terms::Zero();
  double rate = 0.0;
  double count = 0.0;
  double left = std::numeric_limits<double>::infinity();  // mean square
};

Terms row(double dt, bool level, double rate)
{
  return {1.0, level ? 0.0 : dt, rate > 0.0 ? std::cos(rate * dt) : 0.0, rate > 0.0 ? std::sin(rate * dt) : 0.0};
}

// What a fit is made of.
class Samples
{
 public:
  Samples(const WaySample* samples, std::size_t count, double t, bool level)
    : samples_(samples), count_(count), t_(t), datum_(samples[count - 1].value), level_(level)
  {
  }

  // From now on, only what is no farther than `limit` from a fit.
  void keepNear(const Fit& fit, double limit)
  {
    near_ = fit;
    limit_ = limit;
  }

  // rate 0: the line alone.
  Fit fit(double rate) const
  {
    Normal N = Normal::Zero();
    Terms b = Terms::Zero();
    double total = 0.0;
    Fit found;
    for (std::size_t i = 0; i < count_; ++i)
    {
      const double dt = samples_[i].t - t_, y = samples_[i].value - datum_;
      if (limit_ > 0.0 && std::abs(y - near_.terms.dot(row(dt, level_, near_.rate))) > limit_)
        continue;
      const Terms terms = row(dt, level_, rate);
      N += terms * terms.transpose();
      b += y * terms;
      total += y * y;
      found.count += 1.0;
    }
    N.diagonal() += found.count * Terms(1e-12, level_ ? 1.0 : 1e-12, SMALL, SMALL);
    found.terms = N.ldlt().solve(b);
    found.rate = rate;
    found.left = std::max(total - b.dot(found.terms), 0.0) / found.count;
    return found;
  }

  Fit best(double slowest) const
  {
    Fit best = fit(0.0);
    for (int k = 0; k < GRID && best.count >= LEAST_NUMBER && slowest < FASTEST; ++k)
    {
      const Fit other = fit(slowest * std::pow(FASTEST / slowest, k / (GRID - 1.0)));
      if (other.left < best.left)
        best = other;
    }
    return best;
  }

  double datum() const { return datum_; }

 private:
  const WaySample* samples_;
  std::size_t count_;
  double t_, datum_;
  bool level_;
  Fit near_;
  double limit_ = 0.0;
};
}  // namespace

Way fitWay(const WaySample* samples, std::size_t count, double t, bool level)
{
  const double span = samples[count - 1].t - samples[0].t;
  const double slowest = std::max(SLOWEST, LEAST_PERIODS * 2.0 * M_PI / std::max(span, 1e-3));
  Samples kept(samples, count, t, level || !(span > 0.0));
  Fit best = kept.best(slowest);
  for (int pass = 0; pass < 2 && best.count >= LEAST_NUMBER; ++pass)
  {
    kept.keepNear(best, OUTLIER * std::sqrt(best.left));
    best = kept.best(slowest);
  }
  Way way;
  way.position = best.terms[0] + kept.datum();
  way.velocity = best.terms[1];
  way.wave_rate = best.rate;
  way.wave_height = std::sqrt(0.5) * best.terms.tail<2>().norm();
  const double rate = way.wave_rate > 0.0 ? way.wave_rate : SLOWEST;
  way.velocity_stddev = level ? 0.0 : DOUBT * rate * std::sqrt(way.wave_height * way.wave_height + best.left);
  return way;
}

}  // namespace tether_monitor::monitor
