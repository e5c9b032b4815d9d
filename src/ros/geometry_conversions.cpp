#include "tether_monitor/ros/geometry_conversions.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor
{
namespace
{
constexpr double LARGEST_VARIANCE = 1e12;
}

Eigen::Vector3d vector(const geometry_msgs::Point& p)
{
  return {p.x, p.y, p.z};
}

Eigen::Vector3d vector(const geometry_msgs::Vector3& v)
{
  return {v.x, v.y, v.z};
}

Eigen::Quaterniond quaternion(const geometry_msgs::Quaternion& q)
{
  return {q.w, q.x, q.y, q.z};
}

Eigen::Isometry3d isometry(const geometry_msgs::Transform& transform)
{
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = vector(transform.translation);
  result.linear() = quaternion(transform.rotation).normalized().toRotationMatrix();
  return result;
}

geometry_msgs::Point pointMessage(const Eigen::Vector3d& v)
{
  geometry_msgs::Point point;
  point.x = v.x();
  point.y = v.y();
  point.z = v.z();
  return point;
}

geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

geometry_msgs::Quaternion quaternionMessage(const Eigen::Quaterniond& q)
{
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

core::Matrix3 block(const boost::array<double, 9>& covariance)
{
  core::Matrix3 block;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      block(row, column) = std::clamp(covariance[3 * row + column], -LARGEST_VARIANCE, LARGEST_VARIANCE);
  return 0.5 * (block + block.transpose());
}

core::Matrix3 block(const boost::array<double, 36>& covariance, int first)
{
  core::Matrix3 block;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      block(row, column) =
          std::clamp(covariance[6 * (first + row) + first + column], -LARGEST_VARIANCE, LARGEST_VARIANCE);
  return 0.5 * (block + block.transpose());
}

void setBlock(const core::Matrix3& block, int first, boost::array<double, 36>& covariance)
{
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      covariance[6 * (first + row) + first + column] = block(row, column);
}

monitor::MeasuredVector measuredVector(const core::Vector3& value, const core::Matrix3& told,
                                       const Eigen::Isometry3d& to_world, double not_measured)
{
  core::Matrix3 covariance = told;
  for (int j = 0; j < 3; ++j)
    if (told.row(j).hasNaN())
    {
      covariance.row(j).setZero();
      covariance.col(j).setZero();
    }
  constexpr double MIXED = 1e-6;  // share of an axis in another that counts
  const core::Matrix3 R = to_world.rotation();
  monitor::MeasuredVector measured(to_world * value, R * covariance * R.transpose());
  for (int i = 0; i < 3; ++i)
  {
    bool is_specified = true, is_measured = true;
    for (int j = 0; j < 3; ++j)
      if (std::abs(R(i, j)) > MIXED)
      {
        is_specified = is_specified && covariance(j, j) > 0.0;
        is_measured = is_measured && !(covariance(j, j) >= not_measured * not_measured);
      }
    if (!is_measured)
      measured.setNotMeasured(i);
    else if (!is_specified)
      measured.setUnspecified(i);
  }
  return measured;
}

}  // namespace tether_monitor
