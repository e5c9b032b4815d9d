#pragma once

#include "tether_monitor/core/environment/wave_constants.h"

namespace tether_monitor::core::kernel
{
/// Up to BLOCK points in the water of a sea, (M21) of doc/model.md.
struct WaveBlock
{
  const double* x;  ///< [BLOCK], of the points in the world [m]; all of them finite.
  const double* y;
  const double* z;
  int count;                   ///< points, 1..BLOCK; what is written beyond them is no number of use.
  double time;                 ///< [s]
  const WaveConstants* waves;  ///< components of the sea.
  int waves_count;             ///< >= 0
  double depth;                ///< h [m], > 0, or infinite.
  bool is_stretched;           ///< after Wheeler.
  double* velocity;            ///< [3][BLOCK], in and out: that of the waves is added [m/s].
  double* acceleration;        ///< [3][BLOCK], out [m/s^2].
  double* surface;             ///< [BLOCK], out: height of the surface above still water [m].
};

/// Motion of the water at the points of a block.
using WaveKernel = void (*)(const WaveBlock&);
}  // namespace tether_monitor::core::kernel
