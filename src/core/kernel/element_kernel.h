#pragma once

#include "laws.h"
#include "nodal_coordinates.h"

// The equations of an element, (M1)-(M11) and (M24) of doc/model.md, for W elements at once. Inside, slopes are
// multiplied by the element's length: then the shape functions are the same numbers for all elements.

namespace tether_monitor::core::kernel
{
enum class Task
{
  RESIDUALS,
  SYMMETRIC,
  COMPLETE
};

// Tangent of the loads at one point: of f with r, of f with r', of n with r', each times the point's weight.
template <class V, Task TASK>
struct PointTangent
{
  V f_r[6], n_dr[TASK == Task::COMPLETE ? 9 : 6], f_dr[TASK == Task::COMPLETE ? 9 : 1];
};

template <int W, Task TASK>
TM_INLINE void elements(const ElementBlock& in, int first, int count)
{
  using V = typename Simd<W>::Vector;
  constexpr bool TANGENT = TASK != Task::RESIDUALS;
  constexpr bool COMPLETE = TASK == Task::COMPLETE;
  const auto constant = [&](Constant row) { return load<W>(in.constants + row * BLOCK + first); };
  const Surroundings& sea = *in.around;

  const V length = constant(LENGTH), inverse_length = 1.0 / length;
  const bool may_overrun = in.count - first > W || in.nodes_after > 0;
  const Coords<V> q = coordsAt<W>(in.q + 6 * first, count, may_overrun, length);
  const Coords<V> v = coordsAt<W>(in.v + 6 * first, count, may_overrun, length);
  const Coords<V> a = coordsAt<W>(in.a + 6 * first, count, may_overrun, length);

  const V mass = constant(MASS), diameter = constant(DIAMETER);
  const V EA = constant(AXIAL_STIFFNESS), stiff_part = constant(AXIAL_RESIDUAL) * EA;
  const AxialConstants<V> cable{stiff_part, EA - stiff_part, EA / constant(COMPRESSION_LIMIT),
                                constant(AXIAL_VISCOSITY), 1.0 / constant(NATURAL_STRETCH)};
  const V half_rho_d = 0.5 * sea.density * diameter, rho_area = sea.density * constant(AREA);
  const V drag_normal = constant(DRAG_NORMAL), drag_tangential = constant(DRAG_TANGENTIAL);
  const V added_mass = constant(ADDED_MASS), compression = constant(COMPRESSION);

  // Inertia (M7) and bending (M6) are linear.
  const V inertia = mass * length;
  const V bending = constant(BENDING_STIFFNESS) * inverse_length * inverse_length * inverse_length;
  V R[4][3];
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i)
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      R[i][k] = inertia * (MASS_SHARE[i][0] * a.x[0][k] + MASS_SHARE[i][1] * a.x[1][k] +
                           MASS_SHARE[i][2] * a.x[2][k] + MASS_SHARE[i][3] * a.x[3][k]) +
                bending * (BENDING_SHARE[i][2] * (q.x[2][k] - q.x[0][k]) + BENDING_SHARE[i][1] * q.x[1][k] +
                           BENDING_SHARE[i][3] * q.x[3][k]);

  PointTangent<V, TASK> tangent[POINTS];
#pragma GCC unroll 3
  for (int g = 0; g < POINTS; ++g)
  {
    const V weight = HERMITE.weight[g] * length;
    V r[3], t[3], rate[3], velocity[3], acceleration[3], f[3];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
    {
      r[k] = at(HERMITE.N[g], q, k);
      t[k] = inverse_length * slopeAt(HERMITE.dN[g], q, k);
      rate[k] = inverse_length * slopeAt(HERMITE.dN[g], v, k);
      velocity[k] = at(HERMITE.N[g], v, k);
      acceleration[k] = at(HERMITE.N[g], a, k);
      f[k] = V{};
    }
    V flow_speed{};
    if (in.has_transport)
    {
      // The tether runs through the mesh, (M24).
      const V growth = constant(TRANSPORT_GROWTH);
      const V speed_a = constant(TRANSPORT_SPEED_A), rate_a = constant(TRANSPORT_RATE_A);
      flow_speed = speed_a + HERMITE.xi[g] * (constant(TRANSPORT_SPEED_B) - speed_a);
      const V flow_rate = rate_a + HERMITE.xi[g] * (constant(TRANSPORT_RATE_B) - rate_a);
      for (int k = 0; k < 3; ++k)
      {
        const V spread_slope = slopesAlone(HERMITE.N[g], q, k);
        const V turn = rate[k] + growth * (inverse_length * slopesAlone(HERMITE.dN[g], q, k) - t[k]);
        const V curvature = inverse_length * inverse_length * slopeAt(HERMITE.ddN[g], q, k);
        const V extra = 2.0 * growth * slopesAlone(HERMITE.N[g], v, k) +
                        constant(TRANSPORT_ACCELERATION) * spread_slope + flow_rate * t[k] +
                        2.0 * flow_speed * turn + flow_speed * flow_speed * curvature;
        velocity[k] += growth * spread_slope + flow_speed * t[k];
        rate[k] = turn + flow_speed * curvature;
        acceleration[k] += extra;
        f[k] = mass * extra;
      }
    }

    const Axial<V> pull = axial<W>(cable, t, rate, in.has_damping);
    const V square = dot(t, t);

    // Weight and buoyancy (M8).
    V water_velocity[3], water_acceleration[3], surface{};
    const double* table = in.water ? in.water + g * WATER_ROWS * BLOCK + first : nullptr;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
    {
      water_velocity[k] = table ? load<W>(table + (WATER_VELOCITY + k) * BLOCK) : broadcast<W>(sea.current[k]);
      water_acceleration[k] = table ? load<W>(table + (WATER_ACCELERATION + k) * BLOCK) : V{};
    }
    if (table)
      surface = load<W>(table + WATER_SURFACE * BLOCK);
    const V extent = abs(t[2]) * weight + diameter, height = r[2] - surface;
    V wet = broadcast<W>(1.0), wet_slope{};
    const bool emerges = any<W>(!(height < -0.5 * extent));
    if (emerges)
    {
      const V x = min(max(2.0 * height / extent, broadcast<W>(-1.0)), broadcast<W>(1.0));
      wet = 0.5 + 0.25 * x * (x * x - 3.0);
      wet_slope = 1.5 * (1.0 - x * x) / extent;
    }
    V shrunk = broadcast<W>(1.0), shrinking{};
    if (in.has_compression)
    {
      shrunk = r[2] < 0.0 ? max(1.0 + compression * r[2], broadcast<W>(0.1)) : broadcast<W>(1.0);
      shrinking = r[2] < 0.0 ? 2.0 * compression / shrunk : V{};
    }
    const V displaced = rho_area * shrunk * shrunk;
    f[2] += sea.gravity * (mass - displaced * wet);

    // Added mass (M10) and drag (M9).
    const V inverse_square = 1.0 / max(square, broadcast<W>(1e-24));
    const V added = displaced * added_mass * wet, moved = displaced * wet;
    V pushed[3], u[3];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
    {
      pushed[k] = added * (acceleration[k] - water_acceleration[k]) - moved * water_acceleration[k];
      u[k] = velocity[k] - water_velocity[k];
    }
    const V along = inverse_square * dot(t, pushed);
    const V drag_scale = half_rho_d * shrunk * wet;
    const Drag<V> water = drag<W>(drag_scale * drag_normal, drag_scale * drag_tangential, u, t, inverse_square);
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      f[k] += pushed[k] - along * t[k] + water.force[k];

    const bool blows = emerges && sea.has_wind;
    Drag<V> air;
    if (blows)
    {
      const V scale = 0.5 * sea.air_density * diameter * (1.0 - wet);
      V past[3];
      for (int k = 0; k < 3; ++k)
        past[k] = velocity[k] - sea.wind[k];
      air = drag<W>(scale * drag_normal, scale * drag_tangential, past, t, inverse_square);
      for (int k = 0; k < 3; ++k)
        f[k] += air.force[k];
    }

#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
    {
      const V load_f = weight * f[k], load_n = HERMITE.axial[g] * pull.N * t[k];
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i)
        R[i][k] += HERMITE.N[g][i] * load_f + HERMITE.dN[g][i] * load_n;
    }

    if constexpr (TANGENT)
    {
      PointTangent<V, TASK>& out = tangent[g];
      // df/dr: the rates carry the weights of mass and damping.
      const V alpha = weight * (in.damping * water.alpha + in.mass * added);
      const V beta = weight * (in.damping * water.beta - in.mass * added * inverse_square);
      const V gamma = weight * in.damping * water.gamma;
#pragma GCC unroll 3
      for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
        for (int column = row; column < 3; ++column)
        {
          V x = beta * t[row] * t[column] + gamma * water.across[row] * water.across[column];
          if (row == column)
            x += alpha;
          out.f_r[packedIndex3(row, column)] = x;
        }
      out.f_r[packedIndex3(2, 2)] +=
          weight * in.stiffness * sea.gravity * displaced * (wet_slope - shrinking * wet);
      if (blows)
        for (int row = 0; row < 3; ++row)
          for (int column = row; column < 3; ++column)
            out.f_r[packedIndex3(row, column)] +=
                weight * in.damping *
                (air.beta * t[row] * t[column] + air.gamma * air.across[row] * air.across[column] +
                 (row == column ? air.alpha : V{}));

      // dn/dr', over the square of the length.
      axialTangent<COMPLETE>(pull, cable, t, rate, HERMITE.axial[g] * inverse_length, in.damping, in.stiffness,
                             out.n_dr);
      if constexpr (COMPLETE)
      {
#pragma GCC unroll 3
        for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
          for (int column = 0; column < 3; ++column)
          {
            V x = turning(water, t, inverse_square, row, column);
            if (blows)
              x += turning(air, t, inverse_square, row, column);
            // The normal plane of the added mass turns with the tether.
            x -= t[row] * (inverse_square * pushed[column] - 2.0 * along * inverse_square * t[column]);
            if (row == column)
              x -= along;
            x *= in.stiffness;
            if (row == column)
              x += 2.0 * in.damping * flow_speed * mass;
            out.f_dr[3 * row + column] = HERMITE.weight[g] * x;
          }
      }
    }
  }

  // The axial energy at the nodes.
  V node_dr[2][COMPLETE ? 9 : 6];
#pragma GCC unroll 2
  for (int end = 0; end < 2; ++end)
  {
    V t[3], rate[3];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
    {
      t[k] = inverse_length * q.x[2 * end + 1][k];
      rate[k] = inverse_length * v.x[2 * end + 1][k];
      if (in.has_transport)
        rate[k] += constant(end == 0 ? TRANSPORT_SPEED_A : TRANSPORT_SPEED_B) * inverse_length * inverse_length *
                   slopeAt(HERMITE.ddN_node[end], q, k);
    }
    const Axial<V> pull = axial<W>(cable, t, rate, in.has_damping);
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      R[2 * end + 1][k] += AXIAL_AT_NODES * pull.N * t[k];
    if constexpr (TANGENT)
      axialTangent<COMPLETE>(pull, cable, t, rate, AXIAL_AT_NODES * inverse_length, in.damping, in.stiffness,
                             node_dr[end]);
  }

  V own[6], next[6];  // what the nodes a and b receive
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    own[k] = R[0][k];
    own[3 + k] = length * R[1][k];
    next[k] = R[2][k];
    next[3 + k] = length * R[3][k];
  }
  if constexpr (!TANGENT)
  {
    double rows_a[W][8], rows_b[W][8];
    scatter<W>(own, rows_a[0], 8, W);
    scatter<W>(next, rows_b[0], 8, W);
    for (int e = 0; e < count; ++e)
      for (int k = 0; k < 6; ++k)
      {
        in.element_residual[12 * (first + e) + k] = rows_a[e][k];
        in.element_residual[12 * (first + e) + 6 + k] = rows_b[e][k];
      }
    return;
  }
  else
  {
    const int last = count - 1;
    {
      double rows[W][8];
      V sum[6];
#pragma GCC unroll 6
      for (int k = 0; k < 6; ++k)
        sum[k] = own[k] + shiftIn<W>(next[k]);
      scatter<W>(sum, rows[0], 8, W);
      double* node = in.residual + 6 * first;
      for (int k = 0; k < 6; ++k)
        node[k] += rows[0][k];
      for (int e = 1; e < count; ++e)
        for (int k = 0; k < 6; ++k)
          node[6 * e + k] = rows[e][k];
      for (int k = 0; k < 6; ++k)
        node[6 * count + k] = next[k][last];
    }

    // Sums over the points; the linear terms join on the diagonals. Slopes get their length back.
    V scale[4] = {broadcast<W>(1.0), length, broadcast<W>(1.0), length};
    V K[COMPLETE ? 16 : 10][COMPLETE ? 9 : 6];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i)
#pragma GCC unroll 4
      for (int j = COMPLETE ? 0 : i; j < 4; ++j)
      {
        const V linear = in.mass * inertia * MASS_SHARE[i][j] + in.stiffness * bending * BENDING_SHARE[i][j];
        const V both = scale[i] * scale[j];
        V* const k = K[COMPLETE ? 4 * i + j : packedIndex4(i, j)];
#pragma GCC unroll 3
        for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
          for (int column = COMPLETE ? 0 : row; column < 3; ++column)
          {
            V x = row == column ? linear : V{};
            const int place = COMPLETE ? 3 * row + column : packedIndex3(row, column);
#pragma GCC unroll 3
            for (int g = 0; g < POINTS; ++g)
            {
              x += (HERMITE.N[g][i] * HERMITE.N[g][j]) * tangent[g].f_r[packedIndex3(row, column)];
              x += (HERMITE.dN[g][i] * HERMITE.dN[g][j]) * tangent[g].n_dr[place];
              if constexpr (COMPLETE)
                x += (HERMITE.N[g][i] * HERMITE.dN[g][j]) * tangent[g].f_dr[place];
            }
            if (i == j && i % 2 == 1)
              x += node_dr[i / 2][place];
            k[place] = i % 2 + j % 2 == 0 ? x : both * x;
          }
      }
    const auto entry = [&](int i, int row, int j, int column)
    {
      if constexpr (COMPLETE)
        return K[4 * i + j][3 * row + column];
      else
        return K[packedIndex4(i, j)][packedIndex3(row, column)];
    };
    const auto columnOf = [&](int node_row, int node_column, int column, V* x)
    {
#pragma GCC unroll 6
      for (int row = 0; row < 6; ++row)
        x[row] = entry(2 * node_row + row / 3, row % 3, 2 * node_column + column / 3, column % 3);
    };
#pragma GCC unroll 6
    for (int column = 0; column < 6; ++column)
    {
      const int offset = MATRIX * first + column * COLUMN;
      V x[6], y[6];
      columnOf(0, 1, column, x);
      scatter<W>(x, in.upper + offset, MATRIX, count);
      columnOf(1, 0, column, x);
      scatter<W>(x, in.lower + offset, MATRIX, count);
      columnOf(0, 0, column, x);
      columnOf(1, 1, column, y);
      double* after = in.diagonal + offset + MATRIX * count;
#pragma GCC unroll 6
      for (int row = 0; row < 6; ++row)
      {
        x[row] += shiftIn<W>(y[row]);
        after[row] = y[row][last];
      }
      after[6] = after[7] = 0.0;
      scatter<W>(x, in.diagonal + offset, MATRIX, count, true);
    }
  }
}

template <int W, Task TASK>
void allElements(const ElementBlock& in)
{
  for (int first = 0; first < in.count; first += W)
    elements<W, TASK>(in, first, in.count - first < W ? in.count - first : W);
}
}  // namespace tether_monitor::core::kernel
