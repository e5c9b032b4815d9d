#include "tether_monitor/monitor/vessel/track_wave_regression.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double MIN_WAVE_FREQUENCY = 0.25, MAX_WAVE_FREQUENCY = 2.0;  // waves [rad/s]
constexpr int GRID = std::tuple_size<WaveProbabilities>::value - 1;
constexpr double AMPLITUDE_PRIOR_STDDEV = 1.0;         // amplitude of a wave, standard deviation [m]
constexpr double MODEL_RESIDUAL_STDDEV = 0.05;         // what a sine leaves of a wave [m], ...
constexpr double RESIDUAL_BANDWIDTH = 2.0;             // ... as often as this anew [Hz]
constexpr double LEAST_NOISE = 1e-3;                   // [m]
constexpr double MAX_TRACK_SPEED = 20.0;               // velocity of a vessel [m/s]
constexpr double FARTHEST = 1e3;                       // from the last sample [m]
constexpr double OUTLIER = 4.0;                        // over the standard deviation of what is left [-]
constexpr double IRREGULAR_SEA_VELOCITY_RATIO = 0.15;  // about the track, over the velocity in the waves [-]
constexpr double NEW_WAVE_PROBABILITY = 0.05;  // chance of waves in one coordinate that are not in another [-]
constexpr int PASSES = 5;

using Terms = Eigen::Vector4d;  // line, then cosine and sine
using Normal = Eigen::Matrix4d;

struct Fit
{
  Terms terms = Terms::Zero();
  double rate = 0.0;  // 0: the line alone
  double velocity_variance = 0.0;
  double log_evidence = 0.0;
};

// Samples, less the last one's value, and which of them count.
struct Samples
{
  const TrackSample* first;
  std::size_t count;
  double t;
  bool level;
  std::array<bool, MAX_TRACK_SAMPLES> keep;
  double rough = 0.0;  // variance [m^2]
  double scale = 1.0;  // of what is left over what was expected, squared

  double value(std::size_t i) const { return first[i].value - first[count - 1].value; }
  template <class Square>
  double meanOver(const Square& square) const
  {
    double sum = 0.0, kept = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      if (keep[i])
      {
        sum += square(i);
        kept += 1.0;
      }
    return std::max(sum / kept, 1.0);
  }
  Terms row(std::size_t i, double rate) const
  {
    const double dt = first[i].t - t;
    return {1.0, level ? 0.0 : dt, rate > 0.0 ? std::cos(rate * dt) : 0.0, rate > 0.0 ? std::sin(rate * dt) : 0.0};
  }
  double variance(std::size_t i) const { return std::pow(std::max(first[i].stddev, LEAST_NOISE), 2) + rough; }
};

// Bayes' linear regression with given noise and priors; two terms without samples are their prior.
Fit fitOne(const Samples& samples, double rate)
{
  const Terms prior =
      Terms(FARTHEST, samples.level ? 1e-9 : MAX_TRACK_SPEED, AMPLITUDE_PRIOR_STDDEV, AMPLITUDE_PRIOR_STDDEV)
          .cwiseAbs2()
          .cwiseInverse();
  Normal N = prior.asDiagonal();
  Terms b = Terms::Zero();
  for (std::size_t i = 0; i < samples.count; ++i)
    if (samples.keep[i])
    {
      const Terms row = samples.row(i, rate);
      const double weight = 1.0 / (samples.scale * samples.variance(i));
      N += weight * row * row.transpose();
      b += weight * samples.value(i) * row;
    }
  const Eigen::LDLT<Normal> ldlt(N);
  const Normal covariance = ldlt.solve(Normal::Identity());
  Fit fit;
  fit.rate = rate;
  fit.terms = covariance * b;
  fit.velocity_variance = samples.level ? 0.0 : covariance(1, 1);
  fit.log_evidence = 0.5 * (b.dot(fit.terms) - ldlt.vectorD().array().log().sum() + prior.array().log().sum());
  return fit;
}
}  // namespace

WaveProbabilities uniformWavePrior()
{
  WaveProbabilities probabilities;
  probabilities.fill(0.5 / GRID);
  probabilities[0] = 0.5;
  return probabilities;
}

TrackFit fitTrackAndWave(const TrackSample* first, std::size_t count, double t, bool level,
                         const WaveProbabilities& probabilities)
{
  const WaveProbabilities usual = uniformWavePrior();
  Samples samples{first, std::min(count, MAX_TRACK_SAMPLES), t, level, {}};
  samples.keep.fill(true);
  const double span = first[samples.count - 1].t - first[0].t;
  samples.rough = MODEL_RESIDUAL_STDDEV * MODEL_RESIDUAL_STDDEV *
                  std::max(1.0, static_cast<double>(samples.count) / (1.0 + RESIDUAL_BANDWIDTH * span));
  std::array<Fit, GRID + 1> fits;
  std::size_t best = 0;
  for (int pass = 0; pass < PASSES; ++pass)
  {
    best = 0;
    for (std::size_t k = 0; k < fits.size(); ++k)
    {
      fits[k] = fitOne(samples, k == 0 ? 0.0
                                       : MIN_WAVE_FREQUENCY * std::pow(MAX_WAVE_FREQUENCY / MIN_WAVE_FREQUENCY,
                                                                       (k - 1.0) / (GRID - 1.0)));
      fits[k].log_evidence +=
          std::log(NEW_WAVE_PROBABILITY * usual[k] + (1.0 - NEW_WAVE_PROBABILITY) * probabilities[k]);
      best = fits[k].log_evidence > fits[best].log_evidence ? k : best;
    }
    const auto square = [&](std::size_t i)
    {
      const double left = samples.value(i) - fits[best].terms.dot(samples.row(i, fits[best].rate));
      return left * left / samples.variance(i);
    };
    const double limit = OUTLIER * OUTLIER * samples.meanOver(square);
    for (std::size_t i = 0; i < samples.count; ++i)
      samples.keep[i] = square(i) <= limit;
    samples.scale = samples.meanOver(square);
  }
  // What all of them say, each as far as it is likely.
  TrackFit track;
  double total = 0.0, velocity_square = 0.0;
  for (const Fit& fit : fits)
  {
    const double weight = std::exp(fit.log_evidence - fits[best].log_evidence);
    total += weight;
    track.probabilities[&fit - fits.data()] = weight;
    track.position += weight * fit.terms[0];
    track.velocity += weight * fit.terms[1];
    velocity_square += weight * (fit.velocity_variance + fit.terms[1] * fit.terms[1]);
  }
  for (double& share : track.probabilities)
    share /= total;
  track.position /= total;
  track.velocity /= total;
  const double spread = std::max(velocity_square / total - track.velocity * track.velocity, 0.0);
  track.position += first[samples.count - 1].value;
  track.wave_frequency = fits[best].rate;
  track.wave_stddev = best > 0 ? std::sqrt(0.5) * fits[best].terms.tail<2>().norm() : 0.0;
  const double swing = IRREGULAR_SEA_VELOCITY_RATIO * track.wave_frequency * track.wave_stddev;
  track.velocity_stddev = level ? 0.0 : std::sqrt(spread + swing * swing);
  return track;
}

}  // namespace tether_monitor::monitor
