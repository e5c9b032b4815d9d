#include "tether_monitor/files/cubic_spline.h"

namespace tether_monitor::files
{
std::vector<core::Vector3> splineVelocities(const std::vector<double>& t, const std::vector<core::Vector3>& x)
{
  using core::Vector3;
  const std::size_t n = t.size();
  std::vector<Vector3> velocity(n, Vector3::Zero());
  if (n < 2)
    return velocity;
  std::vector<double> h(n - 1);
  std::vector<Vector3> chord(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i)
  {
    h[i] = t[i + 1] - t[i];
    chord[i] = (x[i + 1] - x[i]) / h[i];
  }

  // Second derivatives M at the knots: h M- + 2 (h + h+) M + h+ M+ = 6 (chord+ - chord).
  std::vector<Vector3> M(n, Vector3::Zero());
  if (n == 3)
  {
    M.assign(3, 2.0 * (chord[1] - chord[0]) / (h[0] + h[1]));
  }
  else if (n > 3)
  {
    std::vector<double> diagonal(n), upper(n);
    std::vector<Vector3> right(n);
    const double first = h[0] / h[1];
    const double last = h[n - 2] / h[n - 3];
    for (std::size_t i = 1; i + 1 < n; ++i)
    {
      double lower = h[i - 1];
      diagonal[i] = 2.0 * (h[i - 1] + h[i]);
      upper[i] = h[i];
      right[i] = 6.0 * (chord[i] - chord[i - 1]);
      if (i == 1)  // M0 = (1 + first) M1 - first M2
      {
        diagonal[i] += lower * (1.0 + first);
        upper[i] -= lower * first;
      }
      if (i + 2 == n)
      {
        diagonal[i] += h[i] * (1.0 + last);
        lower -= h[i] * last;
      }
      if (i > 1)
      {
        const double factor = lower / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
      }
    }
    M[n - 2] = right[n - 2] / diagonal[n - 2];
    for (std::size_t i = n - 2; i-- > 1;)
      M[i] = (right[i] - upper[i] * M[i + 1]) / diagonal[i];
    M[0] = (1.0 + first) * M[1] - first * M[2];
    M[n - 1] = (1.0 + last) * M[n - 2] - last * M[n - 3];
  }
  for (std::size_t i = 0; i + 1 < n; ++i)
    velocity[i] = chord[i] - h[i] / 6.0 * (2.0 * M[i] + M[i + 1]);
  velocity[n - 1] = chord[n - 2] + h[n - 2] / 6.0 * (M[n - 2] + 2.0 * M[n - 1]);
  return velocity;
}

}  // namespace tether_monitor::files
