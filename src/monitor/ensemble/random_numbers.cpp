#include "tether_monitor/monitor/ensemble/random_numbers.h"

#include <cmath>

namespace tether_monitor::monitor
{
// In (0, 1).
double RandomNumbers::uniform()
{
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  z ^= z >> 31;
  return (static_cast<double>(z >> 11) + 0.5) * 0x1.0p-53;
}

double RandomNumbers::normal()
{
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return radius * std::cos(2.0 * M_PI * uniform());
}

// Rows are made orthogonal to the ones before, and to a row of ones (modified Gram and Schmidt).
void RandomNumbers::fillUncorrelated(Eigen::Ref<Eigen::MatrixXd> sample)
{
  const Eigen::Index n = sample.cols();
  for (Eigen::Index row = 0; row < sample.rows(); ++row)
  {
    for (Eigen::Index i = 0; i < n; ++i)
      sample(row, i) = normal();
    for (int pass = 0; pass < 2; ++pass)
    {
      sample.row(row).array() -= sample.row(row).mean();
      for (Eigen::Index other = 0; other < row; ++other)
      {
        const double share = sample.row(row).dot(sample.row(other)) / static_cast<double>(n - 1);
        for (Eigen::Index i = 0; i < n; ++i)
          sample(row, i) -= share * sample(other, i);
      }
    }
    sample.row(row) *= std::sqrt(static_cast<double>(n - 1)) / sample.row(row).norm();
  }
}

}  // namespace tether_monitor::monitor
