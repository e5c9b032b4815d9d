#include "tether_monitor/monitor/vessel/axis_kalman_filter.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double ACCELERATION_TIME_CONSTANT = 20.0;  // [s] over which it fades
// Damping of the oscillators [-]: how wide the spectrum of the waves is, from a swell to a short-crested sea or a
// turn.
constexpr double MIN_DAMPING = 0.05, MAX_DAMPING = 1.0;
constexpr double DAMPING_GAIN = 0.01, LARGE_NIS = 9.0;  // its relative change for a squared innovation beyond one
constexpr double MEMORY = 60.0;                         // [s] of what the waves are like
constexpr double MIN_WAVE_FREQUENCY = 0.25, MAX_WAVE_FREQUENCY = 2.0;  // [rad/s]
constexpr double MIN_WAVE_STDDEV = 0.01, MAX_WAVE_STDDEV = 10.0;       // standard deviation of the wave motion [m]
constexpr double FASTEST_WAVE = 20.0;                                  // velocity in the waves that can be [m/s]
constexpr double LEAK = 8.0;                                           // [s] of the integral of the velocity
constexpr double MEAN_MEMORY = 30.0;                                   // [s] of means that are taken off
constexpr double LEARNING_START = 10.0;                 // [s] before it learns what the waves are like
constexpr double USUAL_RATE = 0.8, USUAL_HEIGHT = 0.3;  // [rad/s, m] before anything is known
constexpr double SMOOTHING_FACTOR = 0.05,
                 MAX_NIS = 36.0;  // share of a normalizedInnovation in the running mean, largest square
constexpr double LONGEST = 0.1;   // [s] in one step

using Row = Eigen::Matrix<double, 1, AxisKalmanFilter::STATES>;

Row positionRow()
{
  Row h = Row::Zero();
  h[0] = h[5] = 1.0;
  return h;
}
Row velocityRow()
{
  Row h = Row::Zero();
  h[1] = h[6] = 1.0;
  return h;
}
}  // namespace

Row AxisKalmanFilter::accelerationRow() const
{
  Row a = Row::Zero();
  a[2] = 1.0;
  a[3] = wave_frequency_ * wave_frequency_;
  a[5] = -a[3];
  a[6] = -2.0 * damping_ * wave_frequency_;
  return a;
}

void AxisKalmanFilter::start(double t, double position, double position_stddev, double velocity,
                             double velocity_stddev)
{
  if (!started_)
  {
    since_start_ = 0.0;
    wave_frequency_ = USUAL_RATE;
    wave_stddev_ = USUAL_HEIGHT;
    damping_ = MIN_DAMPING;
    velocity_mean_ = velocity;
    velocity_square_ = wave_stddev_ * wave_stddev_ * wave_frequency_ * wave_frequency_;
    wave_displacement_square_ = wave_stddev_ * wave_stddev_;
  }
  started_ = true;
  time_ = t;
  mean_.setZero();
  mean_[0] = position;
  mean_[1] = velocity;
  covariance_.setZero();
  const double wave = wave_stddev_ * wave_stddev_;
  covariance_(0, 0) = position_stddev * position_stddev + wave;
  covariance_(1, 1) = velocity_stddev * velocity_stddev + wave * wave_frequency_ * wave_frequency_;
  covariance_(2, 2) = acceleration_stddev_ * acceleration_stddev_;
  for (int i : {3, 5})
  {
    covariance_(i, i) = wave;
    covariance_(i + 1, i + 1) = wave * wave_frequency_ * wave_frequency_;
  }
}

AxisKalmanFilter::Matrix AxisKalmanFilter::transition(double dt) const
{
  Matrix A = Matrix::Zero();
  A(0, 1) = A(1, 2) = A(3, 4) = A(5, 6) = 1.0;
  A(2, 2) = -1.0 / ACCELERATION_TIME_CONSTANT;
  const double w = wave_frequency_;
  A(4, 3) = A(6, 5) = -w * w;
  A(4, 4) = A(6, 6) = -2.0 * damping_ * w;
  A(6, 3) = w * w;
  const Matrix X = dt * A;
  const Matrix X2 = X * X;
  return Matrix::Identity() + X + 0.5 * X2 + X2 * (X / 6.0 + X2 / 24.0);
}

// White noise on the fading acceleration and on the first oscillator, over a short time.
AxisKalmanFilter::Matrix AxisKalmanFilter::noise(double dt) const
{
  Matrix Q = Matrix::Zero();
  const double jerk = 2.0 * acceleration_stddev_ * acceleration_stddev_ / ACCELERATION_TIME_CONSTANT;
  Q(2, 2) = jerk * dt;
  Q(1, 2) = Q(2, 1) = 0.5 * jerk * dt * dt;
  Q(1, 1) = jerk * dt * dt * dt / 3.0;
  const double wave = 32.0 * std::pow(damping_ * wave_frequency_, 3) * wave_stddev_ * wave_stddev_;
  Q(4, 4) = wave * dt;
  Q(3, 4) = Q(4, 3) = 0.5 * wave * dt * dt;
  Q(3, 3) = wave * dt * dt * dt / 3.0;
  return std::pow(std::max(innovation_variance_ratio_, 1.0), 2) * Q;
}

// How fast and how high the waves are, from the velocity less its slow mean and from the integral of that.
void AxisKalmanFilter::adaptWaveModel(double dt)
{
  const double velocity = velocityRow().dot(mean_);
  since_start_ += dt;
  if (since_start_ < LEARNING_START)
  {
    // The speed of the track has to be found first.
    velocity_mean_ += (dt / since_start_) * (velocity - velocity_mean_);
    return;
  }
  // At first the memory is as long as there is something to remember.
  const double share = 1.0 - std::exp(-dt / std::min(MEMORY, since_start_));
  const double mean_share = 1.0 - std::exp(-dt / std::min(MEAN_MEMORY, since_start_));
  velocity_mean_ += mean_share * (velocity - velocity_mean_);
  const double v = std::clamp(velocity - velocity_mean_, -FASTEST_WAVE, FASTEST_WAVE);
  wave_displacement_ += dt * (v - wave_displacement_ / LEAK);
  wave_displacement_mean_ += mean_share * (wave_displacement_ - wave_displacement_mean_);
  const double displacement = wave_displacement_ - wave_displacement_mean_;
  velocity_square_ += share * (v * v - velocity_square_);
  wave_displacement_square_ += share * (displacement * displacement - wave_displacement_square_);
  wave_frequency_ = std::clamp(std::sqrt(velocity_square_ / std::max(wave_displacement_square_, 1e-12)),
                               MIN_WAVE_FREQUENCY, MAX_WAVE_FREQUENCY);
  wave_stddev_ = std::clamp(std::sqrt(wave_displacement_square_), MIN_WAVE_STDDEV, MAX_WAVE_STDDEV);
}

void AxisKalmanFilter::setWaveModel(double rate, double height)
{
  wave_frequency_ = std::clamp(rate, MIN_WAVE_FREQUENCY, MAX_WAVE_FREQUENCY);
  wave_stddev_ = std::clamp(height, MIN_WAVE_STDDEV, MAX_WAVE_STDDEV);
  wave_displacement_square_ = wave_stddev_ * wave_stddev_;
  velocity_square_ = wave_displacement_square_ * wave_frequency_ * wave_frequency_;
  since_start_ = std::max(since_start_, LEARNING_START);
}

void AxisKalmanFilter::predict(double t)
{
  while (t - time_ > 1e-9)
  {
    const double left = t - time_;
    const double dt = left / std::ceil(left / LONGEST - 1e-9);
    const Matrix F = transition(dt);
    mean_ = (F * mean_).eval();
    covariance_ = (F * covariance_ * F.transpose() + noise(dt)).eval();
    time_ = left <= dt * (1.0 + 1e-9) ? t : time_ + dt;
    adaptWaveModel(dt);
  }
}

void AxisKalmanFilter::recordInnovation(double normalizedInnovation)
{
  const double squared = std::min(normalizedInnovation * normalizedInnovation, MAX_NIS);
  innovation_variance_ratio_ += SMOOTHING_FACTOR * (squared - innovation_variance_ratio_);
  if (since_start_ > LEARNING_START)
    damping_ = std::clamp(damping_ * std::exp(DAMPING_GAIN * (std::min(squared, LARGE_NIS) - 1.0)), MIN_DAMPING,
                          MAX_DAMPING);
}

void AxisKalmanFilter::correct(const Row& H, double value, double stddev)
{
  const Vector column = covariance_ * H.transpose();
  const double S = H.dot(column) + stddev * stddev;
  recordInnovation((value - H.dot(mean_)) / std::sqrt(S));
  mean_ += column * ((value - H.dot(mean_)) / S);
  covariance_ -= column * column.transpose() / S;
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

void AxisKalmanFilter::correctPosition(double position, double stddev)
{
  correct(positionRow(), position, stddev);
}

void AxisKalmanFilter::correctVelocity(double velocity, double stddev)
{
  correct(velocityRow(), velocity, stddev);
}

double AxisKalmanFilter::normalized(const Row& H, double value, double stddev) const
{
  return (value - H.dot(mean_)) / std::sqrt(H.dot(covariance_ * H.transpose()) + stddev * stddev);
}

double AxisKalmanFilter::normalizedInnovation(double position, double stddev) const
{
  return normalized(positionRow(), position, stddev);
}

double AxisKalmanFilter::normalizedVelocityInnovation(double velocity, double stddev) const
{
  return normalized(velocityRow(), velocity, stddev);
}

bool AxisKalmanFilter::isValid() const
{
  return std::isfinite(time_) && mean_.allFinite() && covariance_.allFinite() &&
         wave_frequency_ <= MAX_WAVE_FREQUENCY && wave_stddev_ <= MAX_WAVE_STDDEV && damping_ >= MIN_DAMPING &&
         damping_ <= MAX_DAMPING && acceleration_stddev_ > 0.0 &&
         std::isfinite(velocity_mean_ + velocity_square_ + wave_displacement_) &&
         std::isfinite(wave_displacement_square_ + innovation_variance_ratio_);
}

AxisKalmanFilter::Motion AxisKalmanFilter::at(double t) const
{
  AxisKalmanFilter ahead = *this;
  ahead.predict(t);
  Motion m;
  const Row p = positionRow(), v = velocityRow();
  const Row a = accelerationRow();
  m.position = p.dot(ahead.mean_);
  m.velocity = v.dot(ahead.mean_);
  m.position_stddev = std::sqrt(std::max(p.dot(ahead.covariance_ * p.transpose()), 0.0));
  m.velocity_stddev = std::sqrt(std::max(v.dot(ahead.covariance_ * v.transpose()), 0.0));
  m.acceleration_stddev = std::sqrt(std::max(a.dot(ahead.covariance_ * a.transpose()), 0.0));
  return m;
}

}  // namespace tether_monitor::monitor
