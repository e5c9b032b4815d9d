#include "tether_monitor/core/analysis/natural_modes.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/element/element_coordinates.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"

namespace tether_monitor::core
{
namespace
{
using Sparse = Eigen::SparseMatrix<double>;

constexpr int EXTRA_VECTORS = 8;
constexpr int MAX_SWEEPS = 200;
constexpr double EIGENVALUE_TOLERANCE = 1e-10;

// Column of every free coordinate, -1 where the node is held.
std::vector<int> freeCoordinates(const DeployedCable& cable)
{
  const PrescribedEnds held = prescribedEnds(cable.bodies());
  std::vector<int> column(6 * cable.nodes(), 0);
  int count = 0;
  for (int i = 0; i < 6 * cable.nodes(); ++i)
  {
    const bool fixed = (held.vessel && i < 3) || (held.vehicle && i >= 6 * cable.elements() && i % 6 < 3);
    column[i] = fixed ? -1 : count++;
  }
  return column;
}

// Symmetric part of an iteration matrix over the free coordinates.
Sparse symmetric(const DeployedCable& cable, const CableState& state, const TangentWeights& weights,
                 const std::vector<int>& column, int size)
{
  NodeField residual(cable.nodes(), NodeCoords::Zero());
  BlockTridiagonal matrix(cable.nodes());
  cable.assemble(state, weights, residual, matrix);
  const auto addBody = [&](const RigidBody& body, int node)
  {
    const RigidBodyMotion motion = rigidBodyMotion(state, node, node == 0 ? state.vessel : state.vehicle);
    matrix.diagonal(node).topLeftCorner<3, 3>() +=
        rigidBodyResidual(body, cable.environment(), motion, Wrench(), weights).force_n;
  };
  if (cable.bodies().vessel)
    addBody(*cable.bodies().vessel, 0);
  if (cable.bodies().vehicle)
    addBody(*cable.bodies().vehicle, cable.elements());

  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int row_node, int column_node, const NodeMatrix& block)
  {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
      {
        const int row = column[6 * row_node + i], col = column[6 * column_node + j];
        if (row < 0 || col < 0)
          continue;
        entries.emplace_back(row, col, 0.5 * block(i, j));
        entries.emplace_back(col, row, 0.5 * block(i, j));
      }
  };
  for (int i = 0; i < cable.nodes(); ++i)
  {
    add(i, i, matrix.diagonal(i));
    if (i + 1 == cable.nodes())
      break;
    add(i, i + 1, matrix.upper(i));
    add(i + 1, i, matrix.lower(i));
  }
  Sparse sum(size, size);
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

// Share of the kinetic energy that runs along the tether.
double axialShare(const DeployedCable& cable, const CableState& state, const NodeField& shape)
{
  double along = 0.0, all = 0.0;
  for (int i = 0; i < cable.elements(); ++i)
    for (const QuadraturePoint& point : QUADRATURE)
    {
      const double l = cable.element(i).length;
      const Vector3 x =
          interpolate(shapeFunctions(point.xi, l), elementRates(cable.element(i), state.q, shape, i));
      const Vector3 t =
          interpolate(shapeSlopes(point.xi, l), elementCoords(cable.element(i), state.q, i)).normalized();
      const double weight = point.weight * l * cable.element(i).mass;
      along += weight * x.dot(t) * x.dot(t);
      all += weight * x.squaredNorm();
    }
  return all > 0.0 ? along / all : 0.0;
}

NodeField spread(const Eigen::VectorXd& x, const std::vector<int>& column, int nodes)
{
  NodeField field(nodes, NodeCoords::Zero());
  for (int i = 0; i < 6 * nodes; ++i)
    if (column[i] >= 0)
      field[i / 6][i % 6] = x[column[i]];
  return field;
}

double largestDisplacement(const DeployedCable& cable, const NodeField& shape)
{
  double largest = 0.0;
  for (int i = 0; i < cable.elements(); ++i)
    for (const double xi : {0.0, 0.5, 1.0})
      largest = std::max(largest,
                         interpolate(shapeFunctions(xi, cable.element(i).length), elementCoords(shape, i)).norm());
  return largest;
}
}  // namespace

std::vector<Mode> naturalModes(const CableModel& given, const CableState& state, int count)
{
  const DeployedCable cable(given.withEnvironment(given.environment().withoutWaves()), state.deployment);
  CableState still = state;
  for (NodeField* rate : {&still.a, &still.algorithmic_acceleration})
    for (NodeCoords& x : *rate)
      x.setZero();
  const std::vector<int> column = freeCoordinates(cable);
  const int size = *std::max_element(column.begin(), column.end()) + 1;
  const Sparse K = symmetric(cable, still, TangentWeights{0.0, 0.0, 1.0}, column, size);
  const Sparse M = symmetric(cable, still, TangentWeights{1.0, 0.0, 0.0}, column, size);
  count = std::min(count, size);
  const int vectors = std::min(size, 2 * count + EXTRA_VECTORS);

  // A small shift keeps a free motion from making the matrix singular.
  const double shift = 1e-9 * K.diagonal().cwiseAbs().maxCoeff() / M.diagonal().cwiseAbs().maxCoeff();
  Eigen::SimplicialLDLT<Sparse> factor(K + shift * M);
  if (factor.info() != Eigen::Success)
    return {};
  // Start from waves of all lengths, the same every time.
  Eigen::MatrixXd X(size, vectors);
  for (int j = 0; j < vectors; ++j)
    for (int i = 0; i < size; ++i)
      X(i, j) = std::sin(1.0 + 0.7 * i * (j + 1) + 0.3 * (i % 7) * (j % 5));
  Eigen::VectorXd values = Eigen::VectorXd::Zero(vectors);
  for (int sweep = 0; sweep < MAX_SWEEPS; ++sweep)
  {
    const Eigen::MatrixXd Y = factor.solve(M * X);
    const Eigen::MatrixXd K_small = Y.transpose() * (K * Y), M_small = Y.transpose() * (M * Y);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(0.5 * (K_small + K_small.transpose()),
                                                                         0.5 * (M_small + M_small.transpose()));
    if (ritz.info() != Eigen::Success)
      return {};
    X = Y * ritz.eigenvectors();
    const Eigen::VectorXd change = ritz.eigenvalues() - values;
    values = ritz.eigenvalues();
    const int watched = std::min(vectors, count);
    if (change.head(watched).cwiseAbs().maxCoeff() < EIGENVALUE_TOLERANCE * std::abs(values[watched - 1]))
      break;
  }

  std::vector<Mode> modes;
  for (int j = 0; j < vectors && static_cast<int>(modes.size()) < count; ++j)
  {
    if (!(values[j] > 0.0))
      continue;
    Mode mode;
    mode.frequency = std::sqrt(values[j]) / (2.0 * M_PI);
    mode.shape = spread(X.col(j), column, cable.nodes());
    const double largest = largestDisplacement(cable, mode.shape);
    for (NodeCoords& node : mode.shape)
      node /= largest;
    mode.kind = axialShare(cable, still, mode.shape) > 0.5 ? ModeKind::AXIAL : ModeKind::TRANSVERSE;
    modes.push_back(mode);
  }
  return modes;
}

}  // namespace tether_monitor::core
