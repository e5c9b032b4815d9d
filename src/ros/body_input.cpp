#include "tether_monitor/ros/body_input.h"

namespace tether_monitor
{
namespace
{
using Result = BodyInput::Result;

template <typename Measurement>
void specify(const BodyInput::Source& source, Measurement& measured)
{
  if (source.stddev)
    measured = measured.withDefaultStddev(*source.stddev);
}
}  // namespace

BodyInput::BodyInput(monitor::TetherEstimator& estimator, const HeaderCheck& headers, const SensorMounts& mounts,
                     const TimeOrigin& time, RecentFixes& fixes)
  : estimator_(estimator), headers_(headers), mounts_(mounts), time_(time), fixes_(fixes)
{
}

const monitor::MotionBuffer& BodyInput::track(Body body) const
{
  return body == Body::VESSEL ? estimator_.vessel().track() : estimator_.vehicle().track();
}

const monitor::BodyConfig& BodyInput::config(Body body) const
{
  return body == Body::VESSEL ? estimator_.config().vessel : estimator_.config().vehicle;
}

double BodyInput::timeOf(const ros::Time& stamp, const Source& source) const
{
  return time_.seconds(stamp) - source.latency;
}

Result BodyInput::give(Body body, const monitor::PoseMeasurement& pose, const Source& source)
{
  monitor::PoseMeasurement own = pose;
  specify(source, own.position);
  const Result error = errorOf(body == Body::VESSEL ? estimator_.addVessel(own) : estimator_.addVehicle(own));
  note(body, own, error);
  return error;
}

void BodyInput::note(Body body, const monitor::PoseMeasurement& pose, const Result& error)
{
  if (body == Body::VEHICLE && !error)
    fixes_.add(pose);
}

Result BodyInput::give(Body body, const monitor::TwistMeasurement& rates, const Source& source)
{
  monitor::TwistMeasurement own = rates;
  specify(source, own.velocity);
  return errorOf(body == Body::VESSEL ? estimator_.addVessel(own) : estimator_.addVehicle(own));
}

Result BodyInput::give(Body body, const monitor::PoseMeasurement& pose, const monitor::TwistMeasurement& rates,
                       const Source& source)
{
  monitor::PoseMeasurement own = pose;
  specify(source, own.position);
  const Result error =
      errorOf(body == Body::VESSEL ? estimator_.addVessel(own, rates) : estimator_.addVehicle(own, rates));
  note(body, own, error);
  return error;
}

// From the reference point of a body to a sensor on it, world axes [m].
Result BodyInput::lever(Body body, const std::string& frame, double t, core::Vector3& from_reference) const
{
  Eigen::Isometry3d mount;
  from_reference.setZero();
  if (const Result error = mounts_.find(config(body), frame, mount))
    return error;
  if (mount.translation().isZero(0.0))
    return std::nullopt;
  if (!track(body).hasOrientation())
    return "its sensor '" + frame + "' is away from the reference point, and no attitude has come";
  from_reference = track(body).orientationAt(t) * mount.translation();
  return std::nullopt;
}

}  // namespace tether_monitor
