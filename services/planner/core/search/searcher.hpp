#pragma once

#include <numbers>
#include <string>

namespace tandem {

/// How an agent moves and what it sees. It detects an object that it sees at a constant rate (digest G3).
struct Searcher {
  std::string id;
  double speed_mps = 0.5;
  double turn_rate_radps = 0.8;
  double radius_m = 0.3;  ///< Its body's clearance from walls.
  double preferred_clearance_m = 0.6;
  double view_min_m = 0.0;  ///< Nearer than this it sees nothing.
  double view_max_m = 3.0;
  double field_of_view_rad = 2.0 * std::numbers::pi;  ///< Centred on its heading.
  double detection_rate_per_s = 0.5;                  ///< Of an object in view.
};

}  // namespace tandem
