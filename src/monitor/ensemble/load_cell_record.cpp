#include "tether_monitor/monitor/ensemble/load_cell_record.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double MEMORY = 30.0, LONGEST_AGE = 60.0;  // [s]
constexpr double LEAST_RATIO = 0.5, LARGEST_RATIO = 2.0;
}  // namespace

void LoadCellRecord::add(double t, double tension, double noise_variance, const Eigen::RowVectorXd& nominal)
{
  t_ = t;
  tension_ = tension;
  noise_variance_ = noise_variance;
  nominal_ = nominal;
  if (!memory_.isContinuedAt(t))
    memory_ = FadingMemory();
  const double share = memory_.shareOfNow(memory_.advance(t), MEMORY);
  mean_tension_ += share * (tension - mean_tension_);
  mean_nominal_ += share * (nominal - mean_nominal_);
}

double LoadCellRecord::ratio(int member, double bias, double bias_stddev, double t) const
{
  if (!memory_.isReady() || t - t_ > LONGEST_AGE)
    return 1.0;
  const double nominal = mean_nominal_[member], doubt = bias_stddev * bias_stddev;
  const double square = nominal * nominal + doubt;
  const double ratio = square > 0.0 ? ((mean_tension_ - bias) * nominal + doubt) / square : 1.0;
  return std::clamp(ratio, LEAST_RATIO, LARGEST_RATIO);
}

bool LoadCellRecord::isValid(int members) const
{
  return nominal_.size() == members && mean_nominal_.size() == members && memory_.isValid() &&
         mean_nominal_.allFinite() && std::isfinite(mean_tension_);
}

}  // namespace tether_monitor::monitor
