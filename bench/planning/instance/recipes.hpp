#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "bench/planning/instance/families.hpp"

namespace tandem::bench {

/// How the floor is built.
enum class Layout { WallsAndColumns, WallsAndColumnsLow, SmallRooms, Office, OfficeLow, Plaza, Campus, Brl };
/// Where the object may lie.
enum class PriorKind { Uniform, Excluded10m, Hills, FarRoom, Deceptive };

/// How the instances of a family are made.
struct Recipe {
  FamilySpec spec;
  Layout layout = Layout::WallsAndColumns;
  int robots = 1;
  int persons = 1;
  int drones = 0;
  double range_m = 2.0;
  double rate_per_s = std::numeric_limits<double>::infinity();
  PriorKind prior = PriorKind::Uniform;
  double horizon_s = 900.0;  ///< about six sweeps of the area
  double cell_size_m = 0.5;
  double replan_period_s = 10.0;
  std::string_view human = {};  ///< policy of the first person
  bool dynamic = false;         ///< the world changes
};

/// All families, in the order they are listed to users.
[[nodiscard]] const std::vector<Recipe>& recipes();

}  // namespace tandem::bench
