#include "services/localization/core/scan_check.hpp"

#include <algorithm>
#include <span>

namespace tandem {
namespace {

constexpr double kStuckM = 0.3;              ///< A laser cannot see the very same over this way.
constexpr int kScansOfAnotherLaser = 10;     ///< So many in a row are no mistake.
constexpr std::size_t kFewestAllAlike = 20;  ///< Fewer returns may be alike by chance.

bool are_all_alike(const LaserScan& scan) {
  std::optional<float> first;
  std::size_t count = 0;
  for (const float range : scan.ranges_m) {
    if (!(range > 0.0F && static_cast<double>(range) < scan.range_max_m)) continue;  // NaN is neither
    if (!first) first = range;
    if (range != *first) return false;
    ++count;
  }
  return count >= kFewestAllAlike;
}

}  // namespace

std::optional<InputFault> ScanCheck::fault_of(const LaserScan& scan, const Pose2& odom_from_base) {
  if (is_of_another_laser(scan)) return InputFault::ScanGeometryChanged;
  if (are_all_alike(scan)) return InputFault::ScanAllAlike;
  if (is_stuck(scan, odom_from_base)) return InputFault::ScanStuck;
  return std::nullopt;
}

bool ScanCheck::is_of_another_laser(const LaserScan& scan) {
  const Geometry geometry{scan.ranges_m.size(), scan.angle_min_rad, scan.angle_increment_rad, scan.base_from_laser};
  if (!geometry_) geometry_ = geometry;
  if (geometry == *geometry_) {
    others_ = 0;
    return false;
  }
  others_ = geometry == other_ ? others_ + 1 : 1;
  other_ = geometry;
  if (others_ < kScansOfAnotherLaser) return true;
  geometry_ = geometry;
  others_ = 0;
  return false;
}

bool ScanCheck::is_stuck(const LaserScan& scan, const Pose2& odom_from_base) {
  // Bytes, not numbers: NaN is not equal to itself.
  const auto now = std::as_bytes(std::span{scan.ranges_m});
  const auto before = std::as_bytes(std::span{seen_ranges_m_});
  if (!std::equal(now.begin(), now.end(), before.begin(), before.end())) {
    seen_ranges_m_ = scan.ranges_m;
    seen_at_ = odom_from_base;
    return false;
  }
  return (odom_from_base.position() - seen_at_.position()).norm() > kStuckM;
}

}  // namespace tandem
