#include "tether_monitor/core/analysis/natural_modes.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/assembly/prescribed_ends.h"
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
std::vector<int> freeCoordinates(const CableModel& model)
{
  const PrescribedEnds held = prescribedEnds(model);
  std::vector<int> column(6 * model.nodes(), 0);
  int count = 0;
  for (int i = 0; i < 6 * model.nodes(); ++i)
  {
    const bool fixed = (held.vessel && i < 3) || (held.vehicle && i >= 6 * model.elements() && i % 6 < 3);
    column[i] = fixed ? -1 : count++;
  }
  return column;
}

// Symmetric part of an iteration matrix over the free coordinates.
Sparse symmetric(const CableModel& model, const CableState& state, const TangentWeights& weights,
                 const std::vector<int>& column, int size)
{
  NodeField residual(model.nodes(), NodeCoords::Zero());
  BlockTridiagonal matrix(model.nodes());
  model.assemble(state, weights, residual, matrix);
  const auto addBody = [&](const RigidBody& body, int node)
  {
    const AttachmentMotion at = attachmentMotion(state, node);
    matrix.diagonal(node).topLeftCorner<3, 3>() +=
        rigidBodyResidual(body, model.sea(), state.time, at, node == 0 ? state.vessel : state.vehicle, Wrench(),
                          weights)
            .force_n;
  };
  if (model.bodies().vessel)
    addBody(*model.bodies().vessel, 0);
  if (model.bodies().vehicle)
    addBody(*model.bodies().vehicle, model.elements());

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
  for (int i = 0; i < model.nodes(); ++i)
  {
    add(i, i, matrix.diagonal(i));
    if (i + 1 == model.nodes())
      break;
    add(i, i + 1, matrix.upper(i));
    add(i + 1, i, matrix.lower(i));
  }
  Sparse sum(size, size);
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

// Share of the kinetic energy that runs along the tether.
double axialShare(const CableModel& model, const CableState& state, const NodeField& shape)
{
  double along = 0.0, all = 0.0;
  for (int i = 0; i < model.elements(); ++i)
    for (const QuadraturePoint& point : QUADRATURE)
    {
      const double l = model.element(i).length;
      const Vector3 x = interpolate(shapeFunctions(point.xi, l), elementCoords(shape, i));
      const Vector3 t = interpolate(shapeSlopes(point.xi, l), elementCoords(state.q, i)).normalized();
      const double weight = point.weight * l * model.element(i).mass;
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

double largestDisplacement(const CableModel& model, const NodeField& shape)
{
  double largest = 0.0;
  for (int i = 0; i < model.elements(); ++i)
    for (const double xi : {0.0, 0.5, 1.0})
      largest = std::max(largest,
                         interpolate(shapeFunctions(xi, model.element(i).length), elementCoords(shape, i)).norm());
  return largest;
}
}  // namespace

std::vector<Mode> naturalModes(const CableModel& given, const CableState& state, int count)
{
  CableModel model = given;
  model.sea().withoutWaves();
  CableState still = state;
  for (NodeField* rate : {&still.a, &still.algorithmic_acceleration})
    for (NodeCoords& x : *rate)
      x.setZero();
  const std::vector<int> column = freeCoordinates(model);
  const int size = *std::max_element(column.begin(), column.end()) + 1;
  const Sparse K = symmetric(model, still, TangentWeights{0.0, 0.0, 1.0}, column, size);
  const Sparse M = symmetric(model, still, TangentWeights{1.0, 0.0, 0.0}, column, size);
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
    mode.shape = spread(X.col(j), column, model.nodes());
    const double largest = largestDisplacement(model, mode.shape);
    for (NodeCoords& node : mode.shape)
      node /= largest;
    mode.kind = axialShare(model, still, mode.shape) > 0.5 ? ModeKind::AXIAL : ModeKind::TRANSVERSE;
    modes.push_back(mode);
  }
  return modes;
}

}  // namespace tether_monitor::core
