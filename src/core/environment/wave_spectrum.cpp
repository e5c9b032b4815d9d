#include "tether_monitor/core/environment/wave_spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LOWEST = 0.5, HIGHEST = 5.0;  // frequencies over that of the peak
constexpr int GRID = 4000;                     // points at which the spectrum is integrated
constexpr double STEEPEST = 0.1;               // Hs over the length of the peak's waves
constexpr double MOST_SPREADING = 1.0;

// Uniform in [0, 1), alike with every standard library.
double uniform(std::mt19937& random)
{
  return static_cast<double>(random()) / 4294967296.0;
}

std::vector<double> cumulative(double from, double to, double (*density)(const WaveSpectrum&, double),
                               const WaveSpectrum& spectrum)
{
  std::vector<double> sum(GRID + 1, 0.0);
  const double step = (to - from) / GRID;
  for (int i = 0; i < GRID; ++i)
    sum[i + 1] = sum[i] + step * density(spectrum, from + (i + 0.5) * step);
  return sum;
}

// Place on the grid, in its steps, where a cumulative sum reaches a share of its last value.
double quantile(const std::vector<double>& sum, double share)
{
  const double wanted = share * sum.back();
  const auto above = std::upper_bound(sum.begin() + 1, sum.end() - 1, wanted);
  const double lower = *(above - 1), upper = *above;
  return static_cast<double>(above - 1 - sum.begin()) +
         (upper > lower ? std::clamp((wanted - lower) / (upper - lower), 0.0, 1.0) : 0.5);
}

double valueAt(const std::vector<double>& sum, double place)
{
  const int i = std::min(static_cast<int>(place), GRID - 1);
  return sum[i] + (place - i) * (sum[i + 1] - sum[i]);
}

double squaredFrequencyShape(const WaveSpectrum& spectrum, double w)
{
  return w * w * jonswapShape(spectrum, w);
}

double spreadingShape(const WaveSpectrum& spectrum, double angle)
{
  const double s = 2.0 / (spectrum.spreading * spectrum.spreading) - 1.0;
  return std::pow(std::cos(0.5 * angle), 2.0 * s);
}
}  // namespace

std::vector<std::string> validate(const WaveSpectrum& spectrum, double gravity)
{
  BoundsCheck check("environment.waves.");
  check.positive("significant_height", spectrum.significant_height, "m");
  check.positive("peak_period", spectrum.peak_period, "s");
  check.within("gamma", spectrum.gamma, 1.0, 10.0, "[-]");
  check.finite("direction", spectrum.direction, "rad");
  check.within("spreading", spectrum.spreading, 0.0, MOST_SPREADING, "rad");
  check.check(spectrum.seed >= 0, "seed", spectrum.seed, ">= 0");
  check.within("components", spectrum.components, 1, MOST_WAVES, "[-]");
  const double peak_length = gravity * spectrum.peak_period * spectrum.peak_period / (2.0 * M_PI);
  check.check(!(spectrum.significant_height > STEEPEST * peak_length), "significant_height",
              spectrum.significant_height,
              "at most a tenth of the length of the waves of peak_period: steeper seas break");
  return check.problems();
}

double jonswapShape(const WaveSpectrum& spectrum, double w)
{
  const double peak = 2.0 * M_PI / spectrum.peak_period, ratio = peak / w;
  const double width = w <= peak ? 0.07 : 0.09;
  const double off = (w / peak - 1.0) / width;
  return std::pow(ratio, 5.0) * std::exp(-1.25 * std::pow(ratio, 4.0)) *
         std::pow(spectrum.gamma, std::exp(-0.5 * off * off));
}

double waveLength(double w, double gravity, double depth)
{
  const double deep = w * w / gravity;
  double k = deep;
  if (std::isfinite(depth))
  {
    k = deep / std::sqrt(std::tanh(deep * depth));  // within 5 %
    for (int i = 0; i < 20; ++i)
    {
      const double tanh = std::tanh(k * depth);
      k -= (k * tanh - deep) / (tanh + k * depth * (1.0 - tanh * tanh));
    }
  }
  return 2.0 * M_PI / k;
}

std::vector<WaveProperties> waveComponents(const WaveSpectrum& spectrum, double gravity, double depth)
{
  const double peak = 2.0 * M_PI / spectrum.peak_period;
  const double lowest = LOWEST * peak, highest = HIGHEST * peak;
  const std::vector<double> energy = cumulative(lowest, highest, jonswapShape, spectrum);
  const std::vector<double> squares = cumulative(lowest, highest, squaredFrequencyShape, spectrum);
  std::vector<double> angles;
  if (spectrum.spreading > 0.0)
    angles = cumulative(-M_PI, M_PI, spreadingShape, spectrum);

  const int n = spectrum.components;
  const double amplitude = spectrum.significant_height / std::sqrt(8.0 * n);
  std::mt19937 random(static_cast<std::uint32_t>(spectrum.seed));
  std::vector<WaveProperties> waves(n);
  double from = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const double to = quantile(energy, (i + 1.0) / n);
    const double w = std::sqrt((valueAt(squares, to) - valueAt(squares, from)) * n / energy.back());
    from = to;
    waves[i].amplitude = amplitude;
    waves[i].length = waveLength(w, gravity, depth);
    waves[i].phase = 2.0 * M_PI * uniform(random);
    const double share = uniform(random);
    waves[i].direction =
        spectrum.direction + (angles.empty() ? 0.0 : 2.0 * M_PI * quantile(angles, share) / GRID - M_PI);
  }
  return waves;
}

WaveProperties peakWave(const WaveSpectrum& spectrum, double gravity, double depth)
{
  return {spectrum.significant_height / std::sqrt(8.0),
          waveLength(2.0 * M_PI / spectrum.peak_period, gravity, depth), spectrum.direction, 0.0};
}

}  // namespace tether_monitor::core
