#pragma once

#include <vector>

#include "tether_monitor/core/cable/axial_stiffening.h"
#include "tether_monitor/core/kernel/block_solve_kernel.h"
#include "tether_monitor/core/kernel/wave_block.h"

namespace tether_monitor::core
{
/**
 * The arithmetic of the stepping path, compiled for several instruction sets and chosen at run time.
 *
 * Plain numbers and pointers only: nothing inlined for one instruction set may meet code for another. Coordinates
 * and residuals have six numbers a node (see NodeCoords); 6 x 6 blocks are stored by columns of 8, rows 6 and 7
 * zero.
 */
namespace kernel
{
constexpr int BLOCK = 8;   ///< elements that one call takes at most.
constexpr int POINTS = 3;  ///< integration points of an element.

/// Rows of the table of constants, one number for each element of a block; see ElementParameters.
enum Constant
{
  LENGTH,
  MASS,
  DIAMETER,
  AREA,
  DRAG_NORMAL,
  DRAG_TANGENTIAL,
  ADDED_MASS,
  ADDED_MASS_TANGENTIAL,
  AXIAL_STIFFNESS,
  AXIAL_VISCOSITY,              ///< tau EA [N s].
  COMPRESSION_LIMIT,            ///< Pc [N].
  COMPRESSION_STIFFNESS_RATIO,  ///< kappa [-].
  BENDING_STIFFNESS,
  COMPRESSION,
  NATURAL_STRETCH,
  TRANSPORT_GROWTH,
  TRANSPORT_ACCELERATION,
  TRANSPORT_SPEED_A,
  TRANSPORT_SPEED_B,
  TRANSPORT_RATE_A,
  TRANSPORT_RATE_B,
  STIFFENING_STRAIN,                                              ///< AxialStiffening::MOST rows [-].
  STIFFENING_CHANGE = STIFFENING_STRAIN + AxialStiffening::MOST,  ///< likewise [N].
  CONSTANTS = STIFFENING_CHANGE + AxialStiffening::MOST
};

/// Rows of the table of what the water does at an integration point.
enum WaterRow
{
  WATER_VELOCITY = 0,      ///< 3 rows [m/s]
  WATER_ACCELERATION = 3,  ///< 3 rows [m/s^2]
  WATER_SURFACE = 6,       ///< height above z = 0 [m]
  WATER_ROWS = 7
};

/// Surroundings of all elements.
struct Surroundings
{
  double density, gravity, air_density;
  double current[3];   ///< [m/s] at the surface, where there is no table of the water.
  double shear[3];     ///< its change per metre of depth [1/s], down to shear_depth.
  double shear_depth;  ///< [m], >= 0.
  double wind[3];
  bool has_wind;
};

/// Up to BLOCK neighbouring elements: what goes in and where the answer goes.
struct ElementBlock
{
  int count;                ///< elements, 1..BLOCK.
  int nodes_after;          ///< nodes that follow the last one of this block in the arrays, >= 0.
  const double* constants;  ///< [CONSTANTS][BLOCK]
  bool has_damping, has_compression, has_transport, has_stiffening;  ///< of any element of the block.
  const double* q;                                                   ///< coordinates, count + 1 nodes.
  const double* v;                                                   ///< their rates.
  const double* a;
  const Surroundings* around;
  const double* water;              ///< [POINTS][WATER_ROWS][BLOCK], null: the uniform current and no waves.
  double mass, damping, stiffness;  ///< see TangentWeights; not used by residuals.
  double* element_residual;         ///< residuals(): out [count][12].
  double* residual;                 ///< tangents: out [count + 1][6]; added to at the first node, set elsewhere.
  double* diagonal;  ///< tangents: out, blocks of count + 1 nodes; added to at the first, set elsewhere.
  double* upper;     ///< tangents: out, block in the row of node a, column of node b, of each element.
  double* lower;     ///< tangents: out, block in the row of node b, column of node a.
};

/// One set of functions. All are reentrant and allocate nothing.
struct Kernel
{
  const char* name;
  int width;                               ///< numbers in a vector register.
  void (*residuals)(const ElementBlock&);  ///< residual of every element alone.
  void (*symmetric)(const ElementBlock&);  ///< residual, and the symmetric part of the tangent that matters in a
                                           ///< time step: without the turning of drag with the tether.
  void (*complete)(const ElementBlock&);   ///< residual and the whole tangent.
  BlockSolveKernel solve;
  WaveKernel waves;
  double (*multiplyAdds)(
      long rounds);  ///< nothing but independent multiply-adds: what the machine can do at most.
};

/// Floating-point operations in one round of Kernel::multiplyAdds, over its width.
constexpr int OPERATIONS_A_ROUND = 2 * 12;

/// The kernels that this machine can run, the widest first; the last is for every machine.
std::vector<const Kernel*> available();
/// The first of available().
const Kernel& best();
}  // namespace kernel
}  // namespace tether_monitor::core
