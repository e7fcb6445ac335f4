#include "robot/safety/core/scan_monitor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace tandem::safety {
namespace {

constexpr std::size_t kFewestBeams = 30;
constexpr double kSmallestView_rad = std::numbers::pi / 2.0;
constexpr int kStuckScans = 10;
constexpr double kStuckMotion_m = 0.05;

/// A scan whose geometry cannot be true is no scan at all: the laser counts as silent.
bool is_well_formed(const ScanView& scan) {
  const double view_rad = scan.angle_increment_rad * static_cast<double>(scan.ranges_m.size());
  const Pose2& pose = scan.base_from_laser;
  return scan.ranges_m.size() >= kFewestBeams && scan.ranges_m.size() <= ScanMonitor::kMostBeams &&
         scan.angle_increment_rad > 0.0 && view_rad >= kSmallestView_rad && view_rad <= 2.0 * std::numbers::pi + 0.1 &&
         std::isfinite(scan.angle_min_rad) && std::isfinite(pose.x) && std::isfinite(pose.y) &&
         std::isfinite(pose.heading) && scan.range_max_m > scan.range_min_m && scan.range_min_m >= 0.0;
}

std::uint64_t fingerprint_of(std::span<const float> ranges) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;  // FNV-1a, a word at a time
  for (const float range : ranges) hash = (hash ^ std::bit_cast<std::uint32_t>(range)) * 0x100000001B3ULL;
  return hash;
}

}  // namespace

ScanMonitor::ScanMonitor(const GateConfig& config) : config_(config) {
  points_in_base_.reserve(kMostBeams);
}

void ScanMonitor::take(const ScanView& scan, const Pose2& odom_from_base, Time now) {
  if (!is_well_formed(scan) || sequence_number_ == scan.sequence_number) return;
  sequence_number_ = scan.sequence_number;
  arrived_ = now;
  stamp_ = scan.stamp;
  bad_ = !is_usable(scan);
  if (bad_) {
    repetitions_ = 0;  // no picture at all is not one that stands still: it stops the robot in its own way
    stuck_ = false;
  } else {
    compare_with_last(scan, odom_from_base);
  }
}

bool ScanMonitor::is_usable(const ScanView& scan) {
  points_in_base_.clear();
  const double c = std::cos(scan.base_from_laser.heading);
  const double s = std::sin(scan.base_from_laser.heading);
  std::size_t invalid = 0;
  float least = std::numeric_limits<float>::infinity();
  float most = 0.0F;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const float range = scan.ranges_m[i];
    if (!std::isfinite(range) || range <= 0.0F) {
      ++invalid;
      continue;
    }
    if (range >= scan.range_max_m) continue;  // free as far as it can see
    least = std::min(least, range);
    most = std::max(most, range);
    const double angle = scan.angle_min_rad + static_cast<double>(i) * scan.angle_increment_rad;
    const double x = range * std::cos(angle);
    const double y = range * std::sin(angle);
    points_in_base_.emplace_back(scan.base_from_laser.x + c * x - s * y, scan.base_from_laser.y + s * x + c * y);
  }
  const auto beams = static_cast<double>(scan.ranges_m.size());
  const bool sees_enough = static_cast<double>(invalid) <= config_.max_invalid_share * beams;
  return sees_enough && most > least;  // nothing seen at all, or one value for all, is a fault
}

void ScanMonitor::compare_with_last(const ScanView& scan, const Pose2& odom_from_base) {
  const std::uint64_t fingerprint = fingerprint_of(scan.ranges_m);
  if (fingerprint != fingerprint_ || repetitions_ == 0) {
    fingerprint_ = fingerprint;
    repetitions_ = 1;
    odom_at_first_of_same_ = odom_from_base;
    stuck_ = false;
    return;
  }
  ++repetitions_;
  const double moved_m = (odom_from_base.position() - odom_at_first_of_same_.position()).norm();
  stuck_ = repetitions_ >= kStuckScans && moved_m > kStuckMotion_m;
}

double ScanMonitor::age_s(Time now) const {
  if (!arrived_) return std::numeric_limits<double>::infinity();
  const double since_arrival_s = to_seconds(now - *arrived_);
  const double since_stamp_s = to_seconds(now - stamp_);
  // Another process may have set its clock before a step of the wall clock: only a stamp that can be true counts.
  return since_stamp_s > since_arrival_s && since_stamp_s < 1.0 ? since_stamp_s : since_arrival_s;
}

Causes ScanMonitor::causes(Time now) const {
  Causes causes;
  causes.set(index_of(Cause::StaleScan), !arrived_ || now - *arrived_ > from_seconds(config_.scan_timeout_s));
  causes.set(index_of(Cause::BadScan), bad_);
  causes.set(index_of(Cause::StuckScan), stuck_);
  return causes;
}

}  // namespace tandem::safety
