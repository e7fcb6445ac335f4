#include "services/map_builder/core/drive_log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

constexpr std::size_t kMinReturns = 20;                         ///< Fewer beams do not tell one place from another.
constexpr double kStuckM = 0.3;                                 ///< A laser cannot see the very same over this way.
constexpr Duration kLongestStepBack = std::chrono::seconds{2};  ///< More is a clock that was set.
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

}  // namespace

void DriveLog::add_odometry(const OdometrySample& sample) {
  const Pose2& pose = sample.odom_from_base;
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.heading)) return;
  if (!samples_.empty() && samples_.back().time - sample.time > kLongestStepBack) {
    drive_.faults.add(InputFault::OdometryOutOfOrder);
    return;
  }
  const bool twice = !samples_.empty() && samples_.back().time == sample.time && samples_.back().odom_from_base == pose;
  if (!twice) samples_.push_back(sample);
}

void DriveLog::add_scan(const LaserScan& scan) {
  ++drive_.scans_seen;
  const bool belongs = !samples_.empty() && samples_.back().time == scan.time;
  if (!belongs && scan.time <= last_scan_) {
    drive_.faults.add(InputFault::ScanOutOfOrder);
    return;
  }
  last_scan_ = scan.time;
  const Twist2 velocity = samples_.empty() ? Twist2{} : samples_.back().velocity;
  std::vector<Eigen::Vector2d> endpoints = selected_endpoints(scan, kAll, config_.range_limit_m, velocity);
  if (endpoints.size() < kMinReturns) {
    drive_.faults.add(InputFault::ScanWithTooFewReturns);
    return;
  }
  if (is_stuck(scan)) {
    drive_.faults.add(InputFault::ScanStuck);
    return;
  }
  if (!is_worth_keeping(scan.time)) return;
  if (!samples_.empty()) kept_at_ = samples_.back();
  drive_.scans.push_back({.time = scan.time,
                          .stamp = scan.time,
                          .odometry_index = belongs ? std::optional{samples_.size() - 1} : std::nullopt,
                          .motion = {},
                          .laser_in_base = scan.base_from_laser.position(),
                          .endpoints_in_base = std::move(endpoints)});
}

bool DriveLog::is_stuck(const LaserScan& scan) {
  if (samples_.empty()) return false;
  // Bytes, not numbers: NaN is not equal to itself.
  const auto bytes = [](const std::vector<float>& ranges) { return std::as_bytes(std::span{ranges}); };
  if (!std::ranges::equal(bytes(scan.ranges_m), bytes(seen_ranges_m_))) {
    seen_ranges_m_ = scan.ranges_m;
    seen_at_ = samples_.back().odom_from_base;
    return false;
  }
  return (samples_.back().odom_from_base.position() - seen_at_.position()).norm() > kStuckM;
}

bool DriveLog::is_worth_keeping(Time time) const {
  if (!kept_at_ || drive_.scans.empty() || samples_.empty() || samples_.back().epoch != kept_at_->epoch) return true;
  const Pose2 motion = inverse(kept_at_->odom_from_base) * samples_.back().odom_from_base;
  // The time counts too: wheels that slip say that the robot stands still.
  return motion.position().norm() >= config_.keep_motion_m || std::abs(motion.heading) >= config_.keep_turn_rad ||
         time - drive_.scans.back().time >= from_seconds(config_.keep_after_s);
}

Drive DriveLog::take() {
  drive_.odometry = OdometryTrack{std::exchange(samples_, {})};
  for (std::size_t i = 0; i < drive_.odometry.jumps(); ++i) drive_.faults.add(InputFault::OdometryJump);
  std::vector<MapScan> scans;
  std::optional<OdometrySample> last;
  for (MapScan& scan : drive_.scans) {
    const auto odometry = scan.odometry_index ? std::optional{drive_.odometry.samples()[*scan.odometry_index]}
                                              : drive_.odometry.at(scan.time, from_seconds(config_.odometry_max_age_s));
    if (!odometry) {
      drive_.faults.add(InputFault::ScanWithoutOdometry);
      continue;
    }
    scan.time = odometry->time;
    if (!scans.empty() && scan.time <= scans.back().time) {
      drive_.faults.add(InputFault::ScanOutOfOrder);
      continue;
    }
    if (last && last->epoch == odometry->epoch) scan.motion = inverse(last->odom_from_base) * odometry->odom_from_base;
    last = odometry;
    scans.push_back(std::move(scan));
  }
  drive_.scans = std::move(scans);
  return std::exchange(drive_, {});
}

}  // namespace tandem
