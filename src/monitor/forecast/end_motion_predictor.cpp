#include "tether_monitor/monitor/forecast/end_motion_predictor.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/forecast/random_vectors.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double POSITION_STDDEV = 0.02;           // that an observed motion is taken to have [m]
constexpr double VELOCITY_STDDEV = 0.05;           // [m/s]
constexpr double OBSERVATION_STEP = 0.1;           // [s] between those that are used
constexpr double SLOWEST_TURN = 0.3;               // speed below which nothing turns [m/s]
constexpr double FASTEST_TURN = 0.1;               // [rad/s]
constexpr double OFFSET_BANDWIDTH = 1.0;           // with which what is wrong at the beginning fades [1/s]
constexpr double COMMAND_TIME = 4.0;               // in which a commanded speed is reached [s]
constexpr double MOST_ACCELERATION = 0.3;          // [m/s^2]
constexpr double USUAL_ACCELERATION = 0.003;       // before anything is known [m/s^2]
constexpr double USUAL_FOR = 30.0, MEMORY = 60.0;  // [s] that this counts for, and of what has been
constexpr double KEPT = 0.5;  // of the accelerations: a helmsman keeps his speed better than chance would
constexpr double FILTERS_ACCELERATION = 0.015;  // that the filters take an end to have [m/s^2]
constexpr double WAVE_MEMORY = 60.0;            // [s]
constexpr double SETTLING = 15.0;               // [s] in which the filters find track and waves
constexpr double SHORTEST_WATCH = 10.0;         // [s] before which nothing is predicted
constexpr int POSITION = 0, VELOCITY = 1, ACCELERATION = 2, WAVE = 5, WAVE_VELOCITY = 6;

void turn(double angle, double& x, double& y)
{
  const double cosine = std::cos(angle), sine = std::sin(angle), before = x;
  x = cosine * before - sine * y;
  y = sine * before + cosine * y;
}

core::EndMotion motionOf(const EndMotionSampler::Course& course)
{
  core::EndMotion end;
  for (int i = 0; i < 3; ++i)
  {
    end.position[i] = course.axes[i][POSITION] + course.axes[i][WAVE];
    end.velocity[i] = course.axes[i][VELOCITY] + course.axes[i][WAVE_VELOCITY];
  }
  return end;
}
}  // namespace

void EndMotionPredictor::observe(double t, const core::EndMotion& end)
{
  if (isStarted() && (t < time() || t - time() > VesselAxisFilters::LONGEST_GAP))
    clear();
  if (isStarted() && t - time() < OBSERVATION_STEP - 1e-6)
    return;
  if (!isStarted())
    return start(t, end);
  const double dt = t - time();
  filters_.apply({t, false, end.position, core::Vector3::Constant(POSITION_STDDEV)});
  filters_.apply({t, true, end.velocity, core::Vector3::Constant(VELOCITY_STDDEV)});
  observed_for_ = std::min(observed_for_ + dt, MEMORY);
  const double share = dt / std::min(observed_for_, WAVE_MEMORY);
  velocity_mean_ += share * (end.velocity - velocity_mean_);
  velocity_square_ += share * ((end.velocity - velocity_mean_).cwiseAbs2() - velocity_square_);
  learnAcceleration(dt);
}

void EndMotionPredictor::start(double t, const core::EndMotion& end)
{
  for (int i = 0; i < 3; ++i)
    filters_.axes[i].start(t, end.position[i], POSITION_STDDEV, end.velocity[i], VELOCITY_STDDEV);
  velocity_mean_ = end.velocity;
  horizontal_square_ = vertical_square_ = USUAL_ACCELERATION * USUAL_ACCELERATION;
}

// Along the course, for what is across it is a turn.
void EndMotionPredictor::learnAcceleration(double dt)
{
  const auto of = [&](int state)
  { return core::Vector3(axis(0).mean()[state], axis(1).mean()[state], axis(2).mean()[state]); };
  const core::Vector3 v = of(VELOCITY), a = of(ACCELERATION);
  const double speed = v.head<2>().norm();
  const double along = speed > SLOWEST_TURN ? v.head<2>().dot(a.head<2>()) / speed : a.head<2>().norm() / M_SQRT2;
  if (observed_for_ < SETTLING)
    return;
  const double share = dt / (USUAL_FOR + observed_for_);
  horizontal_square_ += share * (along * along - horizontal_square_);
  vertical_square_ += share * (a.z() * a.z() - vertical_square_);
}

double EndMotionPredictor::accelerationStddev(int axis) const
{
  if (axis == 2 && floats_)
    return 0.0;
  return std::sqrt(axis == 2 ? vertical_square_ : horizontal_square_);
}

// The filters begin with waves of a usual height, whether there are any or not.
double EndMotionPredictor::waveShare(int i) const
{
  return std::min(std::sqrt(velocity_square_[i]) / (axis(i).waveFrequency() * axis(i).waveStddev()), 1.0);
}

bool EndMotionPredictor::isReady() const
{
  return isStarted() && observed_for_ >= SHORTEST_WATCH;
}

bool EndMotionPredictor::isValid() const
{
  return std::isfinite(horizontal_square_ + vertical_square_ + observed_for_) && velocity_square_.allFinite() &&
         velocity_mean_.allFinite() &&
         (!isStarted() || std::all_of(filters_.axes.begin(), filters_.axes.end(),
                                      [](const AxisKalmanFilter& filter) { return filter.isValid(); }));
}

EndMotionSampler::EndMotionSampler(const EndMotionPredictor& predictor, const core::EndMotion& now, double step,
                                   const MotionCommand& command)
  : predictor_(predictor), now_(now), step_(step), command_(command)
{
  for (int i = 0; i < 3; ++i)
  {
    liveliness_[i] = std::min(KEPT * predictor.accelerationStddev(i) / FILTERS_ACCELERATION, 1.0);
    transition_[i] = predictor.axis(i).transition(step);
    const double wave_share = predictor.waveShare(i);
    Matrix noise = predictor.axis(i).noise(step);
    noise.topLeftCorner<3, 3>() *= liveliness_[i] * liveliness_[i];
    noise.bottomRightCorner<4, 4>() *= wave_share * wave_share;
    noise_[i] = squareRoot(noise);
    spread_[i] = squareRoot(predictor.axis(i).covariance());
    spread_[i].bottomRows<4>() *= wave_share;
  }
}

// The acceleration across the course is a turn, and goes on; the one along it fades.
EndMotionSampler::Course EndMotionSampler::begin(RandomNumbers& random) const
{
  Course course;
  course.t = predictor_.time();
  for (int i = 0; i < 3; ++i)
  {
    AxisKalmanFilter::Vector deviation = spread_[i] * normals<AxisKalmanFilter::STATES>(random);
    deviation[ACCELERATION] *= liveliness_[i];
    course.axes[i] = predictor_.axis(i).mean() + deviation;
  }
  if (predictor_.floats())
    course.axes[2][VELOCITY] = course.axes[2][ACCELERATION] = 0.0;
  auto &x = course.axes[0], &y = course.axes[1];
  const double square = x[VELOCITY] * x[VELOCITY] + y[VELOCITY] * y[VELOCITY];
  if (square > SLOWEST_TURN * SLOWEST_TURN)
    course.turn_rate = std::clamp((x[VELOCITY] * y[ACCELERATION] - y[VELOCITY] * x[ACCELERATION]) / square,
                                  -FASTEST_TURN, FASTEST_TURN);
  x[ACCELERATION] += course.turn_rate * y[VELOCITY];
  y[ACCELERATION] -= course.turn_rate * x[VELOCITY];
  course.commanded = command_.velocity.value_or(core::Vector3::Zero());
  if (command_.turn_rate || command_.velocity)
    course.turn_rate = command_.turn_rate.value_or(0.0);
  const core::EndMotion drawn = motionOf(course);
  course.offset = {now_.position - drawn.position, now_.velocity - drawn.velocity};
  return course;
}

// Outside of its times the vessel goes on as it does then.
bool EndMotionSampler::followPlan(Course& course) const
{
  if (!command_.plan || command_.velocity || command_.turn_rate)
    return false;
  const std::optional<core::Vector3> planned = command_.plan->velocity(course.t);
  if (!planned)
    return false;
  course.commanded = *planned;
  course.turn_rate = 0.0;
  return true;
}

void EndMotionSampler::steer(Course& course) const
{
  for (int i = 0; i < 3; ++i)
  {
    double& velocity = course.axes[i][VELOCITY];
    const double wanted = (1.0 - std::exp(-step_ / COMMAND_TIME)) * (course.commanded[i] - velocity);
    velocity += std::clamp(wanted, -MOST_ACCELERATION * step_, MOST_ACCELERATION * step_);
    course.axes[i][ACCELERATION] = 0.0;
  }
}

core::EndMotion EndMotionSampler::advance(Course& course, RandomNumbers& random) const
{
  for (int i = 0; i < 3; ++i)
    course.axes[i] =
        (transition_[i] * course.axes[i] + noise_[i] * normals<AxisKalmanFilter::STATES>(random)).eval();
  course.t += step_;
  if (followPlan(course) || command_.velocity)
    steer(course);
  const double angle = course.turn_rate * step_;
  turn(angle, course.axes[0][VELOCITY], course.axes[1][VELOCITY]);
  turn(angle, course.commanded.x(), course.commanded.y());
  course.offset.fade(OFFSET_BANDWIDTH, step_);
  core::EndMotion end = motionOf(course);
  end.position += course.offset.value;
  end.velocity += course.offset.rate;
  return end;
}

}  // namespace tether_monitor::monitor
