#include "tether_monitor/monitor/ensemble/ensemble_summary.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double NORMAL_P95 = 1.6448536;
constexpr double LEAST_VARIANCE = 1e-6;  // [m^2]
constexpr double LEAST_STDDEV = 1e-9;    // of what members agree in

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
  mean_position_ = position_variance_ = position_stddev_;
  distance_ = values_;
  representative_.prepare(elements);
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
  }
  for (int i = 0; i < n; ++i)
    values_[i] = profiles_[i].max_element_rotation;
  rotation_ = distributionOf(values_, 0.0);
  countContacts(members);
  spreadPositions();
  findDistances(members, position, own);
  showRepresentative(members);
  describePositions();
}

void EnsembleSummary::spreadPositions()
{
  const double n = static_cast<double>(profiles_.size());
  for (std::size_t k = 0; k < mean_position_.size(); ++k)
  {
    core::Vector3 sum = core::Vector3::Zero(), square = core::Vector3::Zero();
    for (const core::StationProfile& profile : profiles_)
      sum += profile.position[k];
    mean_position_[k] = sum / n;
    for (const core::StationProfile& profile : profiles_)
      square += (profile.position[k] - mean_position_[k]).cwiseAbs2();
    position_variance_[k] = square / (n - 1.0);
  }
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

// Squared distances from the medians of tensions and sharpest turn, the mean place of the vehicle and the mean
// shape, each in its own standard deviations.
void EnsembleSummary::findDistances(const EnsembleMembers& members, const MemberVectors& position, const Own& own)
{
  const MemberMotion& motion = members.motion();
  const core::Vector3 place = position.rowwise().mean();
  const double variance = (motion.position.colwise() - place).squaredNorm() / members.size() + LEAST_VARIANCE;
  const auto squared = [](double value, const Distribution& d)
  { return std::pow((value - d.median) / (d.stddev + LEAST_STDDEV), 2); };
  const std::size_t stations = mean_position_.size();
  for (int i = 0; i < members.size(); ++i)
  {
    double of_shape = 0.0;
    for (std::size_t k = 0; k < stations; ++k)
      of_shape += (profiles_[i].position[k] - mean_position_[k]).squaredNorm() /
                  (position_variance_[k].sum() + LEAST_VARIANCE);
    distance_[i] = squared(std::max(motion.vessel_tension[i] + own.vessel_correction[i], 0.0), vessel_) +
                   squared(std::max(motion.vehicle_tension[i] + own.vehicle_correction[i], 0.0), vehicle_) +
                   squared(profiles_[i].max_element_rotation, rotation_) +
                   (motion.position.col(i) - place).squaredNorm() / variance + of_shape / stations;
  }
}

// Beside obstacles nothing fades: between a tether on the one side and one on the other there is the obstacle.
void EnsembleSummary::showRepresentative(const EnsembleMembers& members)
{
  const bool is_another = representative_.choose(distance_) || members.replaced() != replaced_;
  replaced_ = members.replaced();
  const core::CableState& state = members.state(representative_.index());
  representative_.show(state.time, profiles_[representative_.index()], state.vehicle.orientation, is_another,
                       state.obstacles.empty());
}

void EnsembleSummary::describePositions()
{
  const core::StationProfile& shown = profiles_[representative_.index()];
  for (std::size_t k = 0; k < position_stddev_.size(); ++k)
  {
    const core::Vector3 aside = shown.position[k] - mean_position_[k];
    position_stddev_[k] = (position_variance_[k] + aside.cwiseAbs2()).cwiseSqrt();
  }
}

}  // namespace tether_monitor::monitor
