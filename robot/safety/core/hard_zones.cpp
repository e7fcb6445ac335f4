#include "robot/safety/core/hard_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/safety/core/swept_segment.hpp"

namespace tandem::safety {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kCreep_mps = 0.1;
constexpr double kStands_mps = 0.01;  ///< Slower is no motion but the end of an approach.

/// The edges of a zone as the base sees them, one at a time.
class EdgesInBase {
 public:
  EdgesInBase(const Pose2& map_from_base, const HardZone& zone)
      : base_from_map_(inverse(map_from_base)), corners_(zone.corners_in_map) {}

  template <typename Visitor>
  void visit(Visitor visitor) const {
    if (corners_.empty()) return;
    Eigen::Vector2d from = base_from_map_ * corners_.back();
    for (const auto& corner : corners_) {
      const Eigen::Vector2d to = base_from_map_ * corner;
      visitor(Segment{from, to});
      from = to;
    }
  }

 private:
  Pose2 base_from_map_;
  std::span<const Eigen::Vector2d> corners_;
};

/// Whether the base's centre lies inside: a ray to the right crosses the outline an odd number of times.
bool is_centre_inside(const EdgesInBase& edges) {
  bool inside = false;
  edges.visit([&](const Segment& edge) {
    if ((edge.from.y() > 0.0) == (edge.to.y() > 0.0)) return;
    const double share = -edge.from.y() / (edge.to.y() - edge.from.y());
    if (edge.from.x() + share * (edge.to.x() - edge.from.x()) > 0.0) inside = !inside;
  });
  return inside;
}

bool overlaps(const Hull& hull, const EdgesInBase& edges) {
  bool touches = is_centre_inside(edges);
  edges.visit([&](const Segment& edge) { touches = touches || distance_to_hull(hull, edge) == 0.0; });
  return touches;
}

double time_to_contact(const Hull& hull, double margin_m, const Motion& motion, const EdgesInBase& edges) {
  double earliest = kNever;
  edges.visit(
      [&](const Segment& edge) { earliest = std::min(earliest, time_to_contact(hull, margin_m, motion, edge)); });
  return earliest;
}

}  // namespace

bool overlaps(const Hull& hull, const Pose2& map_from_base, const HardZone& zone) {
  return overlaps(hull, EdgesInBase{map_from_base, zone});
}

PathLimit limited_by_zones(const GateConfig& config, const Hull& hull, double deceleration_mps2, const Motion& wanted,
                           std::span<const HardZone> zones, const Pose2& map_from_base, bool may_creep) {
  // Of the outermost corner: a turn in place is a motion too.
  const double speed =
      std::max(std::abs(wanted.forward_mps), std::abs(wanted.turn_rate_radps) * hull.corner_radius_m());
  if (speed == 0.0) return {wanted, false};
  double allowed = speed;
  for (const HardZone& zone : zones) {
    const EdgesInBase edges{map_from_base, zone};
    const double least = zone.is_keep_out() ? 0.0 : zone.max_speed_mps;
    if (overlaps(hull, edges)) {
      allowed = std::min(allowed, zone.is_keep_out() && may_creep ? kCreep_mps : least);
      continue;
    }
    const double contact_s = time_to_contact(hull, config.zone_margin_m, wanted, edges);
    if (contact_s == kNever) continue;
    const double stopping_mps =
        speed_that_stops_within(speed * contact_s, config.reaction_time_s, deceleration_mps2, 0.0);
    allowed = std::min(allowed, std::max(least, stopping_mps));
  }
  if (allowed < kStands_mps && allowed < speed) return {Motion{}, true};
  const double share = allowed / speed;
  return {{share * wanted.forward_mps, share * wanted.turn_rate_radps}, false};
}

}  // namespace tandem::safety
