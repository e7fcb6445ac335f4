#pragma once

#include <limits>
#include <numbers>
#include <string>

namespace tandem {

/// How an agent moves and what it sees. It detects an object that it sees at a constant rate (digest G3).
///
/// Searchers that differ in nothing but their id have the same capability and share what is computed for it.
struct Searcher {
  std::string id;
  double speed_mps = 0.5;
  double turn_rate_radps = 0.8;
  double radius_m = 0.3;  ///< Its body's clearance from walls.
  double preferred_clearance_m = 0.6;
  double view_min_m = 0.0;  ///< Nearer than this it sees nothing.
  double view_max_m = 3.0;
  double field_of_view_rad = 2.0 * std::numbers::pi;  ///< Centred on its heading.
  double detection_rate_per_s = 0.5;                  ///< Of an object in view; infinite: seen is found.
  int layer = 0;  ///< The map it moves and looks in: 0 the ground, others above low walls.
  double endurance_s = std::numeric_limits<double>::infinity();  ///< With a full battery.

  [[nodiscard]] bool sees_all_around() const { return field_of_view_rad >= 2.0 * std::numbers::pi; }
};

/// Whether two searchers move and see alike.
[[nodiscard]] inline bool same_capability(const Searcher& a, const Searcher& b) {
  return a.speed_mps == b.speed_mps && a.turn_rate_radps == b.turn_rate_radps && a.radius_m == b.radius_m &&
         a.preferred_clearance_m == b.preferred_clearance_m && a.view_min_m == b.view_min_m &&
         a.view_max_m == b.view_max_m && a.field_of_view_rad == b.field_of_view_rad &&
         a.detection_rate_per_s == b.detection_rate_per_s && a.layer == b.layer;
}

}  // namespace tandem
