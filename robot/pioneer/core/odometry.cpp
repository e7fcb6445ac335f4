#include "robot/pioneer/core/odometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tandem::pioneer {
namespace {

constexpr int kCounterRange = 0x8000;  ///< of x and y
constexpr double kSlack = 1.5;         ///< over the top speed
constexpr double kSlack_m = 0.02;
constexpr double kSlack_rad = 0.1;
constexpr double kShortestCycle_s = 0.1;  ///< packets that waited in a buffer arrive together

/// `difference` of two counters that wrap at `range`, the short way round.
int unwrapped(int difference, int range) {
  const int wrapped = ((difference % range) + range) % range;
  return wrapped >= range / 2 ? wrapped - range : wrapped;
}

}  // namespace

void Odometry::restart(const RobotParameters& parameters) {
  parameters_ = parameters;
  if (opened_before_) ++state_.epoch;
  opened_before_ = true;
  reference_.reset();
  gyro_.restart();
  state_.covariance.setZero();
  state_.velocity = {};
  state_.jumped = false;
}

const OdometryState& Odometry::take(const Sip& sip, Time stamp) {
  const Reference current{sip.x & (kCounterRange - 1), sip.y & (kCounterRange - 1), sip.heading, stamp};
  const double left_mps = wheels_.left_wheel_scale * sip.left_velocity * parameters_.mps_per_count;
  const double right_mps = wheels_.right_wheel_scale * sip.right_velocity * parameters_.mps_per_count;
  state_.velocity.forward_mps = 0.5 * (left_mps + right_mps);
  state_.velocity.turn_rate_radps =
      sip.turn_rate_x10 ? from_degrees(0.1 * *sip.turn_rate_x10)
                        : 0.5 * (right_mps - left_mps) * parameters_.half_track_per_m / wheels_.track_scale;
  state_.jumped = false;
  const std::optional<double> gyro_turn = gyro_.take_turn();
  if (reference_) {
    const auto counts_per_turn = static_cast<int>(std::lround(2.0 * std::numbers::pi / parameters_.radians_per_count));
    const double dx = unwrapped(current.x - reference_->x, kCounterRange) * parameters_.metres_per_count;
    const double dy = unwrapped(current.y - reference_->y, kCounterRange) * parameters_.metres_per_count;
    const double turn =
        unwrapped(current.heading - reference_->heading, counts_per_turn) * parameters_.radians_per_count;
    const double elapsed_s = std::max(kShortestCycle_s, to_seconds(stamp - reference_->stamp));
    if (std::hypot(dx, dy) > kSlack * parameters_.max_speed_mps * elapsed_s + kSlack_m ||
        std::abs(turn) > kSlack * parameters_.max_turn_rate_radps * elapsed_s + kSlack_rad) {
      state_.jumped = true;
      ++jumps_;
    } else {
      const Pose2 controller_from_last{0.0, 0.0, reference_->heading * parameters_.radians_per_count};
      const Eigen::Vector2d step = inverse(controller_from_last) * Eigen::Vector2d{dx, dy};
      Pose2 motion = corrected(Pose2{step.x(), step.y(), turn}, 1.0 / parameters_.half_track_per_m, wheels_);
      if (gyro_turn) motion.heading = *gyro_turn;
      move(motion, gyro_turn ? TurnFrom::Gyro : TurnFrom::Wheels);
    }
  }
  reference_ = current;
  return state_;
}

void Odometry::take(const std::vector<GyroReading>& readings) {
  gyro_.take(readings, state_.velocity == Twist2{});
}

void Odometry::move(const Pose2& step, TurnFrom turn_from) {
  const double heading = state_.odom_from_base.heading;
  const Pose2 next = state_.odom_from_base * step;
  const double dx = next.x - state_.odom_from_base.x;
  const double dy = next.y - state_.odom_from_base.y;
  Eigen::Matrix3d next_from_pose = Eigen::Matrix3d::Identity();
  next_from_pose(0, 2) = -dy;
  next_from_pose(1, 2) = dx;

  const double way = std::hypot(step.x, step.y);
  const double turn = std::abs(step.heading);
  const bool slips = parameters_.skid_steer && turn_from == TurnFrom::Wheels;
  const double factor = slips ? noise_.skid_steer_factor : 1.0;
  const double distance_variance = noise_.distance_per_root_m * noise_.distance_per_root_m * way;
  const double turn_deviation = factor * noise_.turn_per_root_rad;
  const double drift_deviation = factor * noise_.turn_per_root_m;
  Eigen::Matrix3d odom_from_step = Eigen::Matrix3d::Identity();
  odom_from_step.topLeftCorner<2, 2>() = Eigen::Rotation2Dd{heading + 0.5 * step.heading}.toRotationMatrix();
  const Eigen::Vector3d step_variance{distance_variance, 0.25 * distance_variance,
                                      turn_deviation * turn_deviation * turn + drift_deviation * drift_deviation * way};
  state_.covariance = next_from_pose * state_.covariance * next_from_pose.transpose() +
                      odom_from_step * step_variance.asDiagonal() * odom_from_step.transpose();
  state_.odom_from_base = next;
}

}  // namespace tandem::pioneer
