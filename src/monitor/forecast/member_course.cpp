#include "tether_monitor/monitor/forecast/member_course.h"

#include <cmath>

#include "tether_monitor/monitor/ensemble/ensemble_members.h"
#include "tether_monitor/monitor/forecast/random_vectors.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr std::uint64_t SEED = 11, SEED_STEP = 1000003;

core::EndMotion endOf(const core::NodeCoords& q, const core::NodeCoords& v)
{
  return {q.head<3>(), v.head<3>()};
}

// The winch gets to a rate; at the end of the tether it stops.
core::PayoutTrajectory payOut(const core::CableModel& model, const core::CableState& state, double rate, double t)
{
  core::PayoutState from{model.length(state.deployment), 0.0, 0.0};
  if (state.deployment.payout)
    from.rate = state.deployment.payout->rate;
  core::PayoutState to{from.length + 0.5 * (t - state.time) * (from.rate + rate), rate, 0.0};
  if (!model.canRepresentLength(to.length))
    to = {from.length, 0.0, 0.0};
  return core::PayoutTrajectory::between(state.time, from, t, to);
}

double wantedRate(const ForecastStart& start, const ForecastActions& actions, double t, double deployed,
                  double usual)
{
  if (actions.payout_rate)
    return *actions.payout_rate;
  return start.payout_plan ? start.payout_plan->rateAt(t, deployed, usual) : usual;
}
}  // namespace

MemberCourse::MemberCourse(const ForecastStart& start, const ForecastActions& actions, const EndSamplers& samplers,
                           const core::RigidBody& body, const ForecastMember& member, const core::Vector3& pull,
                           int index)
  : start_(start),
    actions_(actions),
    samplers_(samplers),
    body_(body),
    random_(SEED + SEED_STEP * static_cast<std::uint64_t>(index)),
    vessel_(samplers.vessel.begin(random_)),
    vessel_end_(endOf(member.state.q.front(), member.state.v.front())),
    vehicle_end_(endOf(member.state.q.back(), member.state.v.back())),
    winch_(start.winch, start.payout_rate, WinchReaction::away(member.state, vessel_end_.velocity))
{
  if (samplers.vehicle)
    vehicle_ = samplers.vehicle->begin(random_);
  slow_force_ = member.slow_force + squareRoot(start.slow_force_covariance) * normals<3>(random_);
  fast_force_ = member.fast_force;
  if (start.reaction && !actions.thrust)
    reaction_.emplace(*start.reaction, pull, member.state.vehicle.orientation * start.thrust.force,
                      start.max_thrust, random_);
}

core::EndTrajectory MemberCourse::follow(const EndMotionSampler& sampler, EndMotionSampler::Course& course,
                                         core::EndMotion& at, double from, double t)
{
  core::EndMotion next = sampler.advance(course, random_);
  next.position -= start_.model->environment().origin();
  const core::EndTrajectory way = core::EndTrajectory::between(from, at, t, next);
  at = next;
  return way;
}

core::Vector3 MemberCourse::unknownForce()
{
  const double decay = std::exp(-STEP / start_.unknown_force.fast_memory);
  fast_force_ = decay * fast_force_ +
                start_.unknown_force.fast_stddev * std::sqrt(1.0 - decay * decay) * normals<3>(random_);
  return slow_force_ + fast_force_;
}

core::BoundaryConditions MemberCourse::next(double t, const core::CableState& state, const core::Vector3& pull)
{
  const core::CableModel& model = *start_.model;
  core::BoundaryConditions ends;
  ends.vessel = follow(samplers_.vessel, vessel_, vessel_end_, state.time, t);
  if (samplers_.vehicle)
    ends.vehicle = follow(*samplers_.vehicle, vehicle_, vehicle_end_, state.time, t);
  ends.clamps = state.clamps;
  ends.vehicle_thrust = actions_.thrust.value_or(start_.thrust);
  ends.vehicle_force = unknownForce();
  if (reaction_)
    ends.vehicle_force += reaction_->advance(STEP, pull);
  if (start_.attitude)
    ends.vehicle_thrust.torque += torqueTowards(body_, *start_.attitude, state.vehicle);
  const double slow = wantedRate(start_, actions_, state.time, model.length(state.deployment), winch_.usualRate());
  const double rate = winch_.advance(STEP, slow, WinchReaction::away(state, vessel_end_.velocity));
  if (rate != 0.0 || (state.deployment.payout && state.deployment.payout->rate != 0.0))
    ends.payout = payOut(model, state, rate, t);
  return ends;
}

}  // namespace tether_monitor::monitor
