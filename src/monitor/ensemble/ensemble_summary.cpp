#include "tether_monitor/monitor/ensemble/ensemble_summary.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double NORMAL_P95 = 1.6448536;
constexpr double LARGER = 2.0, MORE = 0.3;  // of the squared distance from the medians: too far to stay

double stddevAbout(double median, const Eigen::RowVectorXd& values, double own)
{
  return std::sqrt(std::pow(values.mean() - median, 2) + varianceOf(values) + own * own);
}
}  // namespace

Distribution distributionOf(Eigen::RowVectorXd& values, double own)
{
  Distribution d;
  std::sort(values.data(), values.data() + values.size());
  d.median = quantile(values, 0.5);
  d.stddev = stddevAbout(d.median, values, own);
  const double wider = NORMAL_P95 * own;
  d.p05 = std::max(d.median - std::hypot(d.median - quantile(values, 0.05), wider), 0.0);
  d.p95 = d.median + std::hypot(quantile(values, 0.95) - d.median, wider);
  return d;
}

void EnsembleSummary::prepare(int elements, int members)
{
  profiles_.assign(members, core::StationProfile(elements));
  values_ = Eigen::RowVectorXd::Zero(members);
  tension_.assign(2 * elements + 1, 0.0);
  tension_stddev_ = tension_;
  position_stddev_.assign(2 * elements + 1, core::Vector3::Zero());
  representative_ = NONE;
}

void EnsembleSummary::update(const EnsembleMembers& members, const MemberVectors& position, const Own& own)
{
  const int n = members.size();
  for (int i = 0; i < n; ++i)
    core::computeStations(members.cable(i), members.state(i), profiles_[i]);
  values_ = (members.motion().vessel_tension + own.vessel_correction).cwiseMax(0.0);
  vessel_ = distributionOf(values_, own.vessel);
  values_ = (members.motion().vehicle_tension + own.vehicle_correction).cwiseMax(0.0);
  vehicle_ = distributionOf(values_, own.vehicle);
  const std::size_t stations = tension_.size();
  const auto shareOf = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(stations - 1); };
  for (int i = 0; i < n; ++i)
    for (std::size_t k = 0; k < stations; ++k)
      profiles_[i].tension[k] +=
          (1.0 - shareOf(k)) * own.vessel_correction[i] + shareOf(k) * own.vehicle_correction[i];
  for (int i = 0; i < n; ++i)
    values_[i] = *std::max_element(profiles_[i].tension.begin(), profiles_[i].tension.end());
  largest_ = distributionOf(values_, std::max(own.vessel, own.vehicle));
  for (std::size_t k = 0; k < stations; ++k)
  {
    const double share = shareOf(k);
    for (int i = 0; i < n; ++i)
      values_[i] = profiles_[i].tension[k];
    std::nth_element(values_.data(), values_.data() + n / 2, values_.data() + n);
    tension_[k] = values_[n / 2];
    tension_stddev_[k] = stddevAbout(tension_[k], values_, (1.0 - share) * own.vessel + share * own.vehicle);
    core::Vector3 sum = core::Vector3::Zero(), square = core::Vector3::Zero();
    for (int i = 0; i < n; ++i)
      sum += profiles_[i].position[k];
    for (int i = 0; i < n; ++i)
      square += (profiles_[i].position[k] - sum / n).cwiseAbs2();
    position_stddev_[k] = (square / (n - 1)).cwiseSqrt();
  }
  countContacts(members);
  chooseRepresentative(members, position);
}

void EnsembleSummary::countContacts(const EnsembleMembers& members)
{
  const std::size_t obstacles = members.state(0).obstacles.size();
  contact_.obstacles.resize(obstacles);
  contact_probability_.assign(obstacles, 0.0);
  for (int i = 0; obstacles > 0 && i < members.size(); ++i)
  {
    core::summarizeContact(members.cable(i), members.state(i), contact_);
    for (std::size_t k = 0; k < obstacles; ++k)
      contact_probability_[k] += contact_.obstacles[k].total > 0.0 ? 1.0 / members.size() : 0.0;
  }
}

// Stays with a member that is hardly farther off than the nearest.
void EnsembleSummary::chooseRepresentative(const EnsembleMembers& members, const MemberVectors& position)
{
  const MemberMotion& motion = members.motion();
  const core::Vector3 place = position.rowwise().mean();
  double variance = 1e-6;
  for (int i = 0; i < members.size(); ++i)
    variance += (motion.position.col(i) - place).squaredNorm() / members.size();
  const auto distance = [&](int i)
  {
    return std::pow((motion.vessel_tension[i] - vessel_.median) / (vessel_.stddev + 1e-9), 2) +
           std::pow((motion.vehicle_tension[i] - vehicle_.median) / (vehicle_.stddev + 1e-9), 2) +
           (motion.position.col(i) - place).squaredNorm() / variance;
  };
  int nearest = 0;
  for (int i = 1; i < members.size(); ++i)
    if (distance(i) < distance(nearest))
      nearest = i;
  if (representative_ == NONE || distance(representative_) > LARGER * distance(nearest) + MORE)
    representative_ = nearest;
}

}  // namespace tether_monitor::monitor
