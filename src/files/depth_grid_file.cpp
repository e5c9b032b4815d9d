#include "tether_monitor/files/depth_grid_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tether_monitor/files/csv_table.h"

namespace tether_monitor::files
{
namespace
{
struct Axis
{
  double first, spacing;
  Eigen::Index nodes;

  // Index of a coordinate on the axis, or -1.
  Eigen::Index find(double x) const
  {
    const double place = (x - first) / spacing;
    const double nearest = std::round(place);
    return std::abs(place - nearest) < 1e-3 && nearest >= 0 && nearest < nodes ? static_cast<Eigen::Index>(nearest)
                                                                               : -1;
  }
};

Axis axisOf(const CsvTable& table, std::size_t column)
{
  std::vector<double> values;
  for (const auto& row : table.rows)
    values.push_back(row[column]);
  std::sort(values.begin(), values.end());
  const double span = values.back() - values.front();
  const auto same = [span](double a, double b) { return std::abs(a - b) <= 1e-9 * span; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  if (values.size() < 2)
    throw std::runtime_error(table.path + ": column " + table.columns[column] +
                             " has fewer than two different values");
  return {values.front(), span / static_cast<double>(values.size() - 1), static_cast<Eigen::Index>(values.size())};
}
}  // namespace

core::DepthGrid readDepthGrid(const std::string& path)
{
  const auto isGrid = [](std::vector<std::string> columns)
  {
    std::sort(columns.begin(), columns.end());
    return columns == std::vector<std::string>{"depth", "x", "y"};
  };
  CsvTable table;
  try
  {
    table = readCsv(path, nullptr, isGrid);
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(std::string(error.what()) + " (a depth grid has the columns x, y and depth)");
  }
  const auto x = table.find("x"), y = table.find("y"), depth = table.find("depth");
  if (table.rows.empty())
    throw std::runtime_error(path + " has a header but no rows");
  const Axis ax = axisOf(table, *x), ay = axisOf(table, *y);
  core::DepthGrid grid;
  grid.x0 = ax.first;
  grid.y0 = ay.first;
  grid.dx = ax.spacing;
  grid.dy = ay.spacing;
  grid.depth = Eigen::MatrixXd::Constant(ax.nodes, ay.nodes, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < table.rows.size(); ++i)
  {
    const Eigen::Index ix = ax.find(table.rows[i][*x]), iy = ay.find(table.rows[i][*y]);
    const std::string line = path + ", line " + std::to_string(table.lines[i]) + ": ";
    if (ix < 0 || iy < 0)
      throw std::runtime_error(line + "the node is not on an evenly spaced grid");
    if (!std::isnan(grid.depth(ix, iy)))
      throw std::runtime_error(line + "the node is there twice");
    grid.depth(ix, iy) = table.rows[i][*depth];
  }
  if (grid.depth.hasNaN())
    throw std::runtime_error(path + ": " + std::to_string(ax.nodes) + " by " + std::to_string(ay.nodes) +
                             " nodes are expected, some are missing");
  return grid;
}

std::string fileBeside(const std::string& folder, const std::string& name)
{
  const std::filesystem::path path(name);
  return path.is_absolute() || folder.empty() ? name : (std::filesystem::path(folder) / path).string();
}

}  // namespace tether_monitor::files
