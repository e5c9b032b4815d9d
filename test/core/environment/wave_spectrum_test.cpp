#include "tether_monitor/core/environment/wave_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tether_monitor/core/environment/wave_field.h"

namespace tether_monitor::core
{
namespace
{
WaveSpectrum storm()
{
  WaveSpectrum spectrum;
  spectrum.significant_height = 3.0;
  spectrum.peak_period = 9.0;
  return spectrum;
}

double frequencyOf(const WaveProperties& wave)
{
  return std::sqrt(9.81 * 2.0 * M_PI / wave.length);
}
}  // namespace

TEST(WaveSpectrum, SurfaceHasTheHeightAndThePeriodOfTheSpectrum)
{
  SeaState waves;
  waves.spectrum = storm();
  const WaveField sea(waves, 9.81);
  double square = 0.0, before = sea.elevation(0.0, 0.0, 0.0);
  int up = 0;
  const double step = 0.25;
  const int steps = 40000;
  for (int i = 1; i <= steps; ++i)
  {
    const double eta = sea.elevation(0.0, 0.0, i * step);
    square += eta * eta / steps;
    up += before < 0.0 && eta >= 0.0;
    before = eta;
  }
  EXPECT_NEAR(4.0 * std::sqrt(square), 3.0, 0.1);
  // Zero-upcrossing period of a JONSWAP sea with gamma 3.3: Tp / 1.286 (DNV-RP-C205, 3.5.5), with all of its tail.
  EXPECT_NEAR(steps * step / up, 9.0 / 1.286, 0.04 * 7.0);
}

TEST(WaveSpectrum, SurfaceHasTheMeanSquareVelocityOfTheSpectrum)
{
  const double peak = 2.0 * M_PI / 9.0, step = 4.5 * peak / 5000;
  double m0 = 0.0, m2 = 0.0, sum = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const double w = 0.5 * peak + (i + 0.5) * step;
    m0 += jonswapShape(storm(), w);
    m2 += w * w * jonswapShape(storm(), w);
  }
  for (const WaveProperties& wave : waveComponents(storm(), 9.81, AiryWave::DEEP))
    sum += 0.5 * std::pow(wave.amplitude * frequencyOf(wave), 2);
  EXPECT_NEAR(sum, m2 / m0 * 9.0 / 16.0, 1e-4 * sum);
}

TEST(WaveSpectrum, EnergyLiesWhereTheSpectrumHasIt)
{
  WaveSpectrum spectrum = storm();
  spectrum.components = 400;
  const std::vector<WaveProperties> waves = waveComponents(spectrum, 9.81, AiryWave::DEEP);
  const double peak = 2.0 * M_PI / 9.0;
  const auto integral = [&](double from, double to)
  {
    double sum = 0.0;
    for (int i = 0; i < 2000; ++i)
      sum += (to - from) / 2000 * jonswapShape(spectrum, from + (i + 0.5) * (to - from) / 2000);
    return sum;
  };
  const double whole = integral(0.5 * peak, 4.0 * peak);
  for (const double from : {0.5, 0.8, 0.95, 1.0, 1.1, 1.4, 2.0})
  {
    double energy = 0.0;
    for (const WaveProperties& wave : waves)
      if (frequencyOf(wave) >= from * peak && frequencyOf(wave) < 1.3 * from * peak)
        energy += 0.5 * wave.amplitude * wave.amplitude;
    EXPECT_NEAR(energy / (9.0 / 16.0), integral(from * peak, 1.3 * from * peak) / whole, 0.005) << from;
  }
}

TEST(WaveSpectrum, ItsPeakIsThePeaksAndGammaRaisesIt)
{
  WaveSpectrum spectrum = storm();
  const double peak = 2.0 * M_PI / 9.0;
  EXPECT_GT(jonswapShape(spectrum, peak), jonswapShape(spectrum, 0.97 * peak));
  EXPECT_GT(jonswapShape(spectrum, peak), jonswapShape(spectrum, 1.03 * peak));
  const double with = jonswapShape(spectrum, peak);
  spectrum.gamma = 1.0;
  EXPECT_NEAR(with / jonswapShape(spectrum, peak), 3.3, 1e-12);
}

TEST(WaveSpectrum, DirectionsSpreadAsTold)
{
  WaveSpectrum spectrum = storm();
  spectrum.components = MOST_WAVES;
  spectrum.direction = 1.0;
  spectrum.spreading = 0.5;
  std::complex<double> mean;
  for (const WaveProperties& wave : waveComponents(spectrum, 9.81, AiryWave::DEEP))
    mean += std::polar(1.0 / MOST_WAVES, wave.direction);
  EXPECT_NEAR(std::arg(mean), 1.0, 0.07);
  EXPECT_NEAR(std::sqrt(2.0 * (1.0 - std::abs(mean))), 0.5, 0.04) << "circular standard deviation";
  spectrum.spreading = 0.0;
  for (const WaveProperties& wave : waveComponents(spectrum, 9.81, AiryWave::DEEP))
    EXPECT_EQ(wave.direction, 1.0);
}

TEST(WaveSpectrum, TheSeedDecidesTheSea)
{
  const std::vector<WaveProperties> one = waveComponents(storm(), 9.81, 50.0),
                                    again = waveComponents(storm(), 9.81, 50.0);
  WaveSpectrum other = storm();
  other.seed = 2;
  const std::vector<WaveProperties> different = waveComponents(other, 9.81, 50.0);
  EXPECT_EQ(one[17].phase, again[17].phase);
  EXPECT_EQ(one[17].length, again[17].length);
  EXPECT_NE(one[17].phase, different[17].phase);
  EXPECT_NEAR(one[0].phase, 2.0 * M_PI * 1791095845.0 / 4294967296.0, 1e-12) << "first number of mt19937(1)";
}

TEST(WaveSpectrum, LengthsObeyTheDispersionRelation)
{
  for (const double depth : {2.0, 20.0, 500.0})
    for (const double w : {0.05, 0.5, 3.0})
    {
      const double k = 2.0 * M_PI / waveLength(w, 9.81, depth);
      EXPECT_NEAR(9.81 * k * std::tanh(k * depth), w * w, 1e-9 * w * w);
    }
  EXPECT_NEAR(waveLength(1.0, 9.81, AiryWave::DEEP), 2.0 * M_PI * 9.81, 1e-9);
}

TEST(WaveSpectrum, NamesEveryViolatedBound)
{
  WaveSpectrum bad;
  bad.gamma = 0.5;
  bad.spreading = 2.0;
  bad.seed = -1;
  bad.components = MOST_WAVES + 1;
  EXPECT_EQ(validate(bad, 9.81).size(), 6u);
  WaveSpectrum steep = storm();
  steep.significant_height = 13.0;
  EXPECT_EQ(validate(steep, 9.81).size(), 1u);
  EXPECT_TRUE(validate(storm(), 9.81).empty());
}

}  // namespace tether_monitor::core
