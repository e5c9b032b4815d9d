#pragma once

#include <vector>

#include "tether_monitor/core/assembly/contact_summary.h"
#include "tether_monitor/core/assembly/station_profile.h"
#include "tether_monitor/monitor/ensemble/ensemble_members.h"
#include "tether_monitor/monitor/ensemble/representative_member.h"

namespace tether_monitor::monitor
{
/// How a quantity is distributed over the members of an ensemble.
struct Distribution
{
  double median = 0.0, p05 = 0.0, p95 = 0.0, stddev = 0.0;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(median, p05, p95, stddev);
  }
};

/**
 * Median, quantiles and standard deviation about the median of the members' values, and of what every member is
 * unsure of itself: both halves of the distribution grow with it in quadrature, the lower one down to zero: a
 * tether does not push. Allocates nothing.
 *
 * @param values  in and out: their order is lost.
 * @param own     standard deviation of every member's value.
 */
Distribution distributionOf(Eigen::RowVectorXd& values, double own);

/// What an ensemble tells along the tether and at its ends.
class EnsembleSummary
{
 public:
  explicit EnsembleSummary(int members)
    : values_(Eigen::RowVectorXd::Zero(members)), distance_(Eigen::RowVectorXd::Zero(members))
  {
  }

  /// Own standard deviations of the members' tensions at the ends [N].
  struct Own
  {
    double vessel = 0.0, vehicle = 0.0;
    Eigen::RowVectorXd vessel_correction, vehicle_correction;  ///< to be added to the members' tensions [N].
  };
  /// Takes memory for tethers of so many elements.
  void prepare(int elements, int members);
  void update(const EnsembleMembers& members, const MemberVectors& position, const Own& own);

  const RepresentativeMember& representative() const { return representative_; }
  const Distribution& vessel() const { return vessel_; }
  const Distribution& vehicle() const { return vehicle_; }
  const Distribution& largest() const { return largest_; }
  /// Along the stations.
  const std::vector<double>& tension() const { return tension_; }
  const std::vector<double>& tensionStddev() const { return tension_stddev_; }
  /// About the representative member and what it is blended with.
  const std::vector<core::Vector3>& positionStddev() const { return position_stddev_; }
  double maxElementRotation() const { return rotation_.median; }  ///< [rad]
  /// Of every obstacle: share of the members that touch it.
  const std::vector<double>& contactProbability() const { return contact_probability_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(representative_, vessel_, vehicle_, largest_, tension_, tension_stddev_, position_stddev_, rotation_,
      replaced_, contact_probability_);
  }

 private:
  void countContacts(const EnsembleMembers& members);
  void findDistances(const EnsembleMembers& members, const MemberVectors& position, const Own& own);
  void showRepresentative(const EnsembleMembers& members);
  void spreadPositions();
  void describePositions();

  Eigen::RowVectorXd values_;
  std::vector<core::StationProfile> profiles_;
  Eigen::RowVectorXd distance_;  // squared, of the members from their middle.
  RepresentativeMember representative_;
  long replaced_ = 0;  // members, until the last update.
  Distribution vessel_, vehicle_, largest_, rotation_;
  std::vector<double> tension_, tension_stddev_;
  std::vector<core::Vector3> mean_position_, position_variance_;  // of the members.
  std::vector<core::Vector3> position_stddev_;
  core::ContactSummary contact_;
  std::vector<double> contact_probability_;
};

}  // namespace tether_monitor::monitor
