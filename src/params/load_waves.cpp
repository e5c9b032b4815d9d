#include "tether_monitor/params/load_waves.h"

#include <optional>

namespace tether_monitor::params
{
namespace
{
core::WaveStretching loadStretching(ParameterReader& in)
{
  const std::string word = in.text("stretching", "wheeler");
  if (word == "none")
    return core::WaveStretching::NONE;
  if (word != "wheeler")
    in.addError("stretching", " = '" + word + "' (must be wheeler or none)");
  return core::WaveStretching::WHEELER;
}

core::WaveProperties loadWave(ParameterReader& in)
{
  core::WaveProperties wave;
  wave.amplitude = in.number("amplitude", wave.amplitude);
  wave.length = in.number("length", wave.length);
  wave.direction = in.number("direction", wave.direction);
  wave.phase = in.number("phase", wave.phase);
  return wave;
}

core::WaveSpectrum loadSpectrum(ParameterReader& in)
{
  core::WaveSpectrum spectrum;
  if (!in.isText("spectrum", "jonswap"))
    in.addError("spectrum", " must be jonswap (gamma: 1 is Pierson and Moskowitz's)");
  spectrum.significant_height = in.number("significant_height");
  spectrum.peak_period = in.number("peak_period");
  spectrum.gamma = in.number("gamma", spectrum.gamma);
  spectrum.direction = in.number("direction", spectrum.direction);
  spectrum.spreading = in.number("spreading", spectrum.spreading);
  spectrum.seed = in.integer("seed", spectrum.seed);
  spectrum.components = in.integer("components", spectrum.components);
  return spectrum;
}
}  // namespace

core::SeaState loadWaves(ParameterReader& environment)
{
  core::SeaState waves;
  if (!environment.isList("waves"))
  {
    ParameterReader in = environment.child("waves");
    if (in.has("spectrum"))
      waves.spectrum = loadSpectrum(in);
    else
      waves.components = {loadWave(in)};
    waves.stretching = loadStretching(in);
    in.finish();
    return waves;
  }
  std::optional<core::WaveStretching> stretching;
  for (ParameterReader& entry : environment.list("waves"))
  {
    waves.components.push_back(loadWave(entry));
    waves.stretching = loadStretching(entry);
    if (stretching && *stretching != waves.stretching)
      entry.addError("stretching", " differs from that of the waves before: all of a list have the same");
    stretching = waves.stretching;
    entry.finish();
  }
  return waves;
}

}  // namespace tether_monitor::params
