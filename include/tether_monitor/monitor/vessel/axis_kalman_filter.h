#pragma once

#include <Eigen/Core>

namespace tether_monitor::monitor
{
/**
 * Kalman filter of one coordinate of a vessel in a seaway: (E10)-(E12) of doc/theory/estimation.md.
 *
 * Seven states: the track of the vessel (position, velocity, a fading acceleration) and the motion in the waves on
 * top, two oscillators in a chain whose frequency and height are those of the motion that the filter has seen in
 * the last minute. Plain data: copy it to save it.
 */
class AxisKalmanFilter
{
 public:
  static constexpr int STATES = 7;
  using Vector = Eigen::Matrix<double, STATES, 1>;
  using Matrix = Eigen::Matrix<double, STATES, STATES>;

  /// What is known at one time, with standard deviations.
  struct Motion
  {
    double position = 0.0, velocity = 0.0;                                           ///< [m, m/s]
    double position_stddev = 0.0, velocity_stddev = 0.0, acceleration_stddev = 0.0;  ///< [m, m/s, m/s^2]
  };

  /// @param acceleration_stddev  standard deviation of the acceleration of the vessel's own way [m/s^2], > 0.
  explicit AxisKalmanFilter(double acceleration_stddev = 0.02) : acceleration_stddev_(acceleration_stddev) {}

  void start(double t, double position, double position_stddev, double velocity, double velocity_stddev);
  bool isStarted() const { return started_; }
  double time() const { return time_; }
  /// Goes on to time t [s]; not before time().
  void predict(double t);
  void correctPosition(double position, double stddev);
  void correctVelocity(double velocity, double stddev);
  /// Accepts recordInnovation of an innovation, over its standard deviation: those that go on to be too large make
  /// the filter follow faster until it has learnt why.
  void recordInnovation(double normalizedInnovation);
  /// How much larger than expected its innovations are, squared [-]; 1 or less is as expected.
  double innovationVarianceRatio() const { return innovation_variance_ratio_; }
  /// Innovation of a position or of a velocity over its standard deviation [-].
  double normalizedInnovation(double position, double stddev) const;
  double normalizedVelocityInnovation(double velocity, double stddev) const;
  /// Accepts it from others what the waves are like: their frequency [rad/s] and standard deviation [m].
  void setWaveModel(double rate, double height);
  /// False for what no measurements can have made.
  bool isValid() const;
  /// At time t [s], not before time(); the filter stays where it is.
  Motion at(double t) const;
  /// Frequency [rad/s] and standard deviation [m] of the motion in the waves.
  double waveFrequency() const { return wave_frequency_; }
  double waveStddev() const { return wave_stddev_; }
  /// Belief at time(): position, velocity and acceleration of the track, and the two oscillators, a position and a
  /// velocity each; the motion in the waves is the second one.
  const Vector& mean() const { return mean_; }
  const Matrix& covariance() const { return covariance_; }
  /// How the belief goes on over a short time dt [s], and the covariance of what comes on top.
  Matrix transition(double dt) const;
  Matrix noise(double dt) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(acceleration_stddev_, started_, time_, mean_, covariance_, wave_frequency_, wave_stddev_, velocity_mean_,
      velocity_square_, wave_displacement_, wave_displacement_mean_, wave_displacement_square_, since_start_,
      innovation_variance_ratio_, damping_);
  }

 private:
  Eigen::Matrix<double, 1, STATES> accelerationRow() const;
  void adaptWaveModel(double dt);
  double normalized(const Eigen::Matrix<double, 1, STATES>& H, double value, double stddev) const;
  void correct(const Eigen::Matrix<double, 1, STATES>& H, double value, double stddev);

  bool started_ = false;
  double time_ = 0.0;
  Vector mean_ = Vector::Zero();
  Matrix covariance_ = Matrix::Identity();
  double acceleration_stddev_;
  double wave_frequency_ = 0.0, wave_stddev_ = 0.0;
  double velocity_mean_ = 0.0, velocity_square_ = 0.0, wave_displacement_ = 0.0, wave_displacement_mean_ = 0.0,
         wave_displacement_square_ = 0.0;   // running means
  double since_start_ = 0.0;                // [s]
  double innovation_variance_ratio_ = 1.0;  // running mean of squared surprises
  double damping_ = 0.05;                   // of the oscillators [-]
};

}  // namespace tether_monitor::monitor
