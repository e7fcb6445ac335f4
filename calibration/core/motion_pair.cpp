#include "calibration/core/motion_pair.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "services/map_builder/core/scan_registration.hpp"
#include "services/map_builder/core/surface.hpp"

namespace tandem {
namespace {

constexpr double kUnknown = 1.0;  ///< Deviation [m, rad] of what two scans do not tell.

Surface surface_of(const MapScan& scan, const PairOptions& options) {
  return tandem::surface_of(scan.endpoints_in_base, scan.laser_in_base, options.points);
}

/// No prior: the wheels must have no say in what they are judged by.
std::optional<Registration> laid(const SurfaceIndex& from, const Surface& to, const Pose2& by_wheels) {
  RegistrationOptions options;
  options.first_reach_m = 0.5;
  options.last_reach_m = 0.1;
  options.loss_m = 0.03;
  options.most_steps = 30;
  const Registration found = registered(from, to, by_wheels, options);
  const Pose2 off = inverse(by_wheels) * found.reference_from_scan;
  if (off.position().norm() > options.first_reach_m || std::abs(off.heading) > 0.5) return std::nullopt;
  return found;
}

}  // namespace

std::vector<MotionPair> motion_pairs(const Drive& drive, const PairOptions& options,
                                     const std::function<bool(double)>& keep_going) {
  std::vector<MotionPair> pairs;
  std::optional<SurfaceIndex> from;
  std::size_t first = 0;
  Pose2 motion;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    if (!keep_going(static_cast<double>(i) / static_cast<double>(drive.scans.size()))) return pairs;
    const MapScan& scan = drive.scans[i];
    const bool unbroken = from && scan.motion && to_seconds(scan.time - drive.scans[first].time) <= options.longest_s;
    if (unbroken) {
      motion = motion * *scan.motion;
      if (motion.position().norm() < options.way_m && std::abs(motion.heading) < options.turn_rad) continue;
      const Surface to = surface_of(scan, options);
      const auto found = laid(*from, to, motion);
      if (found && found->matched_share >= options.least_share) {
        const Eigen::Matrix3d some = Eigen::Matrix3d::Identity() / (kUnknown * kUnknown);
        pairs.push_back({.from = drive.scans[first].time,
                         .to = scan.time,
                         .motion = found->reference_from_scan,
                         .covariance = (found->information + some).inverse(),
                         .matched_share = found->matched_share});
      }
    }
    from.emplace(surface_of(scan, options));
    first = i;
    motion = {};
  }
  return pairs;
}

}  // namespace tandem
