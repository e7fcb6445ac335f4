#include "bench/calibration/simulated_recording.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "services/common/random.hpp"

namespace tandem::bench {
namespace {

constexpr double kStepS = 0.02;
constexpr int kStepsPerSample = 5;
constexpr double kHalfTrackM = 0.2;
constexpr double kSlipM = 0.3;
constexpr double kFreeRadiusM = 2.5;  ///< The robot stays within; the furniture stays out.

struct Wall {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

void add_box(std::vector<Wall>& walls, const Pose2& room_from_box, double length_m, double width_m) {
  const std::array<Eigen::Vector2d, 4> corners{room_from_box * Eigen::Vector2d{-length_m / 2.0, -width_m / 2.0},
                                               room_from_box * Eigen::Vector2d{length_m / 2.0, -width_m / 2.0},
                                               room_from_box * Eigen::Vector2d{length_m / 2.0, width_m / 2.0},
                                               room_from_box * Eigen::Vector2d{-length_m / 2.0, width_m / 2.0}};
  for (std::size_t i = 0; i < corners.size(); ++i) walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
}

std::vector<Wall> room(Rng& rng) {
  std::vector<Wall> walls;
  add_box(walls, {0.0, 0.0, rng.uniform(-3.0, 3.0)}, rng.uniform(10.0, 14.0), rng.uniform(8.0, 10.0));
  for (int i = 0; i < 7; ++i) {
    const double bearing = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const double distance_m = rng.uniform(3.6, 4.5);
    add_box(walls, {distance_m * std::cos(bearing), distance_m * std::sin(bearing), rng.uniform(-3.0, 3.0)},
            rng.uniform(0.4, 1.2), rng.uniform(0.3, 0.8));
  }
  return walls;
}

double range_m(const std::vector<Wall>& walls, const Eigen::Vector2d& origin, double heading) {
  const Eigen::Vector2d direction{std::cos(heading), std::sin(heading)};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d along = wall.to - wall.from;
    const Eigen::Vector2d away = wall.from - origin;
    const double across = direction.x() * along.y() - direction.y() * along.x();
    if (std::abs(across) < 1e-12) continue;
    const double distance = (away.x() * along.y() - away.y() * along.x()) / across;
    const double share = (away.x() * direction.y() - away.y() * direction.x()) / across;
    if (distance > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, distance);
  }
  return nearest;
}

LaserScan scan_of(const std::vector<Wall>& walls, const Pose2& world_from_laser, double range_deviation_m, Rng& rng) {
  LaserScan scan{.angle_min_rad = from_degrees(-135.0),
                 .angle_increment_rad = from_degrees(0.75),
                 .range_min_m = 0.05,
                 .range_max_m = 30.0};
  for (int i = 0; i <= 360; ++i) {
    const double heading = world_from_laser.heading + scan.angle_min_rad + i * scan.angle_increment_rad;
    const double range = range_m(walls, world_from_laser.position(), heading) + rng.normal(0.0, range_deviation_m);
    scan.ranges_m.push_back(static_cast<float>(range));
  }
  return scan;
}

/// Drives from one chance place to the next: turns there, then goes, on a slight bend.
class Driver {
 public:
  Driver(const RecordingOptions& options, Rng rng) : options_(options), rng_(rng) {}

  /// Speed ahead [m/s] and turn rate [rad/s] at `pose`, with the robot's accelerations.
  Arc<double> velocity_at(const Pose2& pose) {
    const Eigen::Vector2d way = inverse(pose) * goal_;
    if (way.norm() < 0.2 || (!turning_ && way.x() < 0.0)) choose(pose);
    const double bearing = bearing_to_goal(pose);
    if (turning_ && std::abs(bearing) < 0.1) turning_ = !options_.drives;
    if (turning_ && !options_.drives && std::abs(bearing) < 0.1) choose(pose);
    const double wanted_mps = turning_ ? 0.0 : speed_mps_;
    const double wanted_radps = turning_ ? std::copysign(0.6, bearing) : std::clamp(0.8 * bearing, -0.3, 0.3);
    velocity_.forward_m += std::clamp(wanted_mps - velocity_.forward_m, -0.5 * kStepS, 0.5 * kStepS);
    velocity_.turn_rad += std::clamp(wanted_radps - velocity_.turn_rad, -1.5 * kStepS, 1.5 * kStepS);
    return velocity_;
  }
  [[nodiscard]] bool slips() const { return slips_ && !turning_; }

 private:
  void choose(const Pose2& pose) {
    const double bearing = rng_.uniform(-std::numbers::pi, std::numbers::pi);
    const double distance_m = kFreeRadiusM * std::sqrt(rng_.uniform());
    goal_ = {distance_m * std::cos(bearing), distance_m * std::sin(bearing)};
    if (!options_.drives) goal_ = pose.position() + 1.0 * Eigen::Vector2d{std::cos(bearing), std::sin(bearing)};
    turning_ = true;
    speed_mps_ = rng_.uniform(0.25, 0.5);
    slips_ = rng_.uniform() < options_.slip_share;
  }
  /// The long way round, where it turns to one side only.
  [[nodiscard]] double bearing_to_goal(const Pose2& pose) const {
    const Eigen::Vector2d way = inverse(pose) * goal_;
    const double bearing = std::atan2(way.y(), way.x());
    if (turning_ && !options_.turns_left && bearing > 0.1) return bearing - 2.0 * std::numbers::pi;
    if (turning_ && !options_.turns_right && bearing < -0.1) return bearing + 2.0 * std::numbers::pi;
    return bearing;
  }

  RecordingOptions options_;
  Rng rng_;
  Eigen::Vector2d goal_ = Eigen::Vector2d::Zero();
  Arc<double> velocity_{};
  double speed_mps_ = 0.4;
  bool turning_ = true;
  bool slips_ = false;
};

/// What the controller reports of a true step.
Pose2 reported(const Arc<double>& step, const WheelCorrection& wheels, double noise_m, Rng& rng) {
  const double half_track_m = kHalfTrackM * wheels.track_scale;
  const auto counted = [&](double way_m, double scale) {
    return way_m / scale + rng.normal(0.0, noise_m * std::sqrt(std::abs(way_m)));
  };
  const double left_m = counted(step.forward_m - half_track_m * step.turn_rad, wheels.left_wheel_scale);
  const double right_m = counted(step.forward_m + half_track_m * step.turn_rad, wheels.right_wheel_scale);
  const Arc<double> end =
      chord_of(Arc<double>{0.5 * (left_m + right_m), 0.0, (right_m - left_m) / (2.0 * kHalfTrackM)});
  return {end.forward_m, end.left_m, end.turn_rad};
}

Pose2 chance_pose(double reach_m, double reach_deg, Rng& rng) {
  return {rng.uniform(-reach_m, reach_m), rng.uniform(-reach_m, reach_m),
          from_degrees(rng.uniform(-reach_deg, reach_deg))};
}

}  // namespace

SimulatedRecording simulated_recording(std::uint64_t seed, const RecordingOptions& options) {
  Rng rng{seed};
  SimulatedRecording recording{
      .wheels = {rng.uniform(0.95, 1.05), rng.uniform(0.95, 1.05), rng.uniform(0.95, 1.05)},
      .base_from_laser = {rng.uniform(0.0, 0.3), rng.uniform(-0.1, 0.1), from_degrees(rng.uniform(-10.0, 10.0))},
      .laser_clock_s = rng.uniform(-0.05, 0.05)};
  recording.start.base_from_laser = recording.base_from_laser * chance_pose(0.03, 2.0, rng);
  recording.start.half_track_m = kHalfTrackM;
  const std::vector<Wall> walls = room(rng);
  Driver driver{options, rng.fork()};
  DriveLog log{{}};
  Pose2 world_from_base{0.0, 0.0, rng.uniform(-3.0, 3.0)};
  Pose2 odom_from_base;
  double slip_left_m = 0.0;
  bool slipped = false;
  const auto count = static_cast<int>(options.duration_s / kStepS);
  for (int i = 0; i < count; ++i) {
    const Time now{from_seconds(1000.0 + i * kStepS)};
    const Arc<double> velocity = driver.velocity_at(world_from_base);
    if (i % kStepsPerSample == 0) {
      recording.events.emplace_back(
          OdometrySample{now, odom_from_base, {velocity.forward_m, 0.0, velocity.turn_rad}, 0});
      log.add_odometry(std::get<OdometrySample>(recording.events.back()));
    } else if (i % kStepsPerSample == 2) {
      const Pose2 world_from_laser = world_from_base * recording.base_from_laser;
      LaserScan scan = scan_of(walls, world_from_laser, options.range_deviation_m, rng);
      scan.time = now - from_seconds(recording.laser_clock_s);
      scan.base_from_laser = recording.start.base_from_laser;
      recording.world_from_laser.emplace_back(scan.time, world_from_laser);
      log.add_scan(scan);
      recording.events.emplace_back(std::move(scan));
    }
    const Arc<double> step{kStepS * velocity.forward_m, 0.0, kStepS * velocity.turn_rad};
    const Arc<double> end = chord_of(step);
    world_from_base = world_from_base * Pose2{end.forward_m, end.left_m, end.turn_rad};
    if (driver.slips() && !slipped) slip_left_m = kSlipM;
    slipped = driver.slips();
    if (slip_left_m > 0.0) {
      slip_left_m -= step.forward_m;
    } else {
      odom_from_base = odom_from_base * reported(step, recording.wheels, options.wheel_noise_m, rng);
    }
  }
  recording.drive = log.take();
  return recording;
}

CalibrationErrors errors_of(const JointCalibration& estimate, const SimulatedRecording& truth) {
  Eigen::Matrix<double, kCalibrationParameters, 1> off;
  off << estimate.wheels.left_wheel_scale - truth.wheels.left_wheel_scale,
      estimate.wheels.right_wheel_scale - truth.wheels.right_wheel_scale,
      estimate.wheels.track_scale - truth.wheels.track_scale, estimate.base_from_laser.x - truth.base_from_laser.x,
      estimate.base_from_laser.y - truth.base_from_laser.y,
      turn_between(truth.base_from_laser.heading, estimate.base_from_laser.heading),
      estimate.laser_clock_s - truth.laser_clock_s;
  return {.wheels_share = std::max({std::abs(off(0)) / truth.wheels.left_wheel_scale,
                                    std::abs(off(1)) / truth.wheels.right_wheel_scale,
                                    std::abs(off(2)) / truth.wheels.track_scale}),
          .laser_m = off.segment<2>(3).norm(),
          .laser_deg = to_degrees(std::abs(off(5))),
          .clock_s = std::abs(off(6)),
          .nees = off.dot(estimate.covariance.inverse() * off) / kCalibrationParameters};
}

}  // namespace tandem::bench
