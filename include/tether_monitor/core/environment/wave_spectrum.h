#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/environment/airy_wave.h"

namespace tether_monitor::core
{
/// Most components of a sea state: what a step may cost is bounded.
constexpr int MOST_WAVES = 500;

/// A JONSWAP sea state, as a user gives it. Hasselmann et al. (1973); gamma = 1 is Pierson and Moskowitz's.
struct WaveSpectrum
{
  double significant_height = 0.0;  ///< Hs [m], four standard deviations of the surface, > 0.
  double peak_period = 0.0;         ///< Tp [s], > 0.
  double gamma = 3.3;               ///< peak enhancement [-], 1 .. 10.
  double direction = 0.0;           ///< mean direction towards which the waves run [rad], from x towards y.
  double spreading =
      0.0;               ///< standard deviation of the direction [rad], 0 .. 1 (Kuik et al. 1988); 0: long crests.
  int seed = 1;          ///< of the phases and directions, >= 0.
  int components = 100;  ///< 1 .. MOST_WAVES
};

/// Every bound of WaveSpectrum that `spectrum` violates, one sentence each.
/// @param gravity  [m/s^2], > 0.
std::vector<std::string> validate(const WaveSpectrum& spectrum, double gravity);

/// Spectral density of the surface [m^2 s] at an angular frequency w [rad/s], > 0, not yet scaled to Hs.
double jonswapShape(const WaveSpectrum& spectrum, double w);

/**
 * The sea state as a sum of regular waves: the same for the same seed, on every machine.
 *
 * Model: (M21) of doc/model.md. Components of equal energy: each stands for a piece of the spectrum between
 * 0.5 and 5 peak frequencies that carries m0 / n, m0 = Hs^2 / 16, at the root of the piece's mean square
 * frequency: m0 and m2 of the sum are those of the spectrum, and the sea does not repeat itself. Phases are
 * uniform; directions follow cos^2s of half the angle, s = 2 / spreading^2 - 1, and are independent of the
 * frequency.
 *
 * @param spectrum  without violated bounds.
 * @param depth     of the sea [m], > 0, AiryWave::DEEP: infinite; a frequency's length follows from it.
 */
std::vector<WaveProperties> waveComponents(const WaveSpectrum& spectrum, double gravity, double depth);

/// Wave of the peak frequency with the energy of the whole sea state, phase 0.
WaveProperties peakWave(const WaveSpectrum& spectrum, double gravity, double depth);

/// Length [m] of the waves of angular frequency w [rad/s], > 0, in water of depth h [m]: w^2 = g k tanh(k h).
double waveLength(double w, double gravity, double depth);

}  // namespace tether_monitor::core
