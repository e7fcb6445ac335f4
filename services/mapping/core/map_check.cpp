#include "services/mapping/core/map_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "services/common/format.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/grid_regions.hpp"

namespace tandem {
namespace {

constexpr double kSmallestPlaceM = 2.0;
constexpr double kLargestPlaceM = 5000.0;
constexpr double kLargestCellM = 0.2;  ///< A doorway has four cells then.
constexpr double kSmallestCellM = 0.01;
constexpr double kRobotM = 0.6;  ///< diameter of a place in which a robot can stand
constexpr double kThickWallM = 0.65;
constexpr double kLeastFreeShare = 0.05;  ///< of the part in which anything is known
constexpr double kTornShare = 0.8;        ///< The largest free space should have this much of all.
constexpr double kHoleM2 = 1.0;           ///< Smaller unknown areas are specks.
constexpr std::size_t kMostListed = 5;

/// "around (3.0, 4.5), 2.0 x 1.5 m"
std::string place_of(const GridRegion& region, const OccupancyGrid& map) {
  const Eigen::Vector2d low = map.centre_in_map(region.lowest);
  const Eigen::Vector2d high = map.centre_in_map(region.highest);
  const double cell_m = map.resolution_m();
  return formatted("around (%.1f, %.1f), %.1f x %.1f m", 0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()),
                   (region.highest.column - region.lowest.column + 1) * cell_m,
                   (region.highest.row - region.lowest.row + 1) * cell_m);
}

/// Lengths of the runs of occupied cells between two free ones, along rows or columns [cells]; of each cell's two runs
/// the shorter is its wall's thickness, roughly.
double median_wall_cells(const OccupancyGrid& map) {
  std::vector<int> lengths;
  const auto scan = [&](int lines, int length, auto cell_at) {
    for (int line = 0; line < lines; ++line) {
      int start = -1;  // of a run that began behind a free cell
      for (int i = 1; i < length; ++i) {
        const CellState here = map.at(cell_at(line, i));
        const CellState before = map.at(cell_at(line, i - 1));
        if (here == CellState::Occupied && before == CellState::Free) start = i;
        if (here == CellState::Free && before == CellState::Occupied && start >= 0) lengths.push_back(i - start);
        if (here != CellState::Occupied) start = -1;
      }
    }
  };
  scan(map.height(), map.width(), [](int line, int i) { return CellIndex{i, line}; });
  scan(map.width(), map.height(), [](int line, int i) { return CellIndex{line, i}; });
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Looks at one map and keeps what it finds.
class Checking {
 public:
  explicit Checking(const OccupancyGrid& map) : map_(map), cell_m2_(map.resolution_m() * map.resolution_m()) {}

  MapCheck run() {
    measure();
    if (known_.cells == 0) {
      fault(MapFault::NothingKnown, "no cell is free or occupied", "",
            "check the thresholds in the YAML file (occupied_thresh, free_thresh, negate), and the image");
      return std::move(check_);
    }
    check_resolution();
    check_space();
    check_unknown();
    std::stable_sort(check_.findings.begin(), check_.findings.end(),
                     [](const MapFinding& a, const MapFinding& b) { return a.severity < b.severity; });
    return std::move(check_);
  }

 private:
  void fault(MapFault what, std::string text, std::string where, std::string advice) {
    check_.findings.push_back({what, Severity::Fault, std::move(text), std::move(where), std::move(advice)});
  }
  void hint(MapFault what, std::string text, std::string where, std::string advice) {
    check_.findings.push_back({what, Severity::Hint, std::move(text), std::move(where), std::move(advice)});
  }

  void measure() {
    regions_ = regions_of(map_);
    known_.lowest = {map_.width(), map_.height()};
    known_.highest = {-1, -1};
    std::size_t free = 0;
    std::size_t occupied = 0;
    for (const GridRegion& region : regions_) {
      if (region.state == CellState::Unknown) continue;
      (region.state == CellState::Free ? free : occupied) += region.cells;
      known_.cells += region.cells;
      known_.lowest = {std::min(known_.lowest.column, region.lowest.column),
                       std::min(known_.lowest.row, region.lowest.row)};
      known_.highest = {std::max(known_.highest.column, region.highest.column),
                        std::max(known_.highest.row, region.highest.row)};
      if (region.state == CellState::Free && region.cells > largest_.cells) largest_ = region;
    }
    if (known_.cells == 0) return;
    MapSummary& summary = check_.summary;
    summary.width_m = (known_.highest.column - known_.lowest.column + 1) * map_.resolution_m();
    summary.height_m = (known_.highest.row - known_.lowest.row + 1) * map_.resolution_m();
    summary.free_m2 = static_cast<double>(free) * cell_m2_;
    summary.occupied_m2 = static_cast<double>(occupied) * cell_m2_;
    summary.unknown_m2 = summary.width_m * summary.height_m - summary.free_m2 - summary.occupied_m2;
    summary.largest_free_m2 = static_cast<double>(largest_.cells) * cell_m2_;
    summary.wall_thickness_m = median_wall_cells(map_) * map_.resolution_m();
    if (free > 0) summary.widest_m = widest_m();
  }

  [[nodiscard]] double widest_m() const {
    const DistanceField distances{map_, kLargestPlaceM, Obstacles::OccupiedOrUnknown};
    float widest = 0.0F;
    for (int row = known_.lowest.row; row <= known_.highest.row; ++row) {
      for (int column = known_.lowest.column; column <= known_.highest.column; ++column) {
        if (map_.is_free({column, row})) widest = std::max(widest, distances.at({column, row}));
      }
    }
    return 2.0 * static_cast<double>(widest) - map_.resolution_m();
  }

  void check_resolution() {
    const MapSummary& s = check_.summary;
    const double longest_m = std::max(s.width_m, s.height_m);
    const double cell_m = map_.resolution_m();
    if (longest_m < kSmallestPlaceM) {
      fault(MapFault::TooSmall, formatted("the map is %.2f x %.2f m", s.width_m, s.height_m), "",
            formatted("measure a wall: resolution must be its length / its pixels (now %g m)", cell_m));
    }
    if (longest_m > kLargestPlaceM) {
      fault(MapFault::TooLarge, formatted("the map is %.0f x %.0f m", s.width_m, s.height_m), "",
            formatted("measure a wall: resolution must be its length / its pixels (now %g m)", cell_m));
    }
    if (cell_m > kLargestCellM) {
      fault(MapFault::CellsTooLarge, formatted("cells of %g m: a doorway vanishes", cell_m), "",
            "correct the resolution, or draw the map with cells of 0.05 to 0.1 m");
    }
    if (cell_m < kSmallestCellM) {
      hint(MapFault::CellsTooSmall, formatted("cells of %g m are finer than a laser sees", cell_m), "",
           "correct the resolution, or draw the map with cells of 0.05 m");
    }
    if (s.wall_thickness_m > kThickWallM && s.wall_thickness_m > 2.0 * cell_m) {
      hint(MapFault::WallsTooThick, formatted("half of the walls are %.2f m thick or more", s.wall_thickness_m), "",
           "if the building's walls are thinner, the resolution is too large or the map is smeared");
    }
  }

  void check_space() {
    const MapSummary& s = check_.summary;
    if (s.occupied_m2 == 0.0) {
      fault(MapFault::NoWalls, "no cell is occupied: a robot cannot find itself here", "",
            "check occupied_thresh and negate in the YAML file");
    }
    if (s.free_m2 == 0.0) {
      fault(MapFault::NoFreeSpace, "no cell is free: a robot cannot drive here", "",
            "check free_thresh and negate in the YAML file");
      return;
    }
    if (s.widest_m < kRobotM) {
      fault(MapFault::NarrowSpace, formatted("the widest free place is %.2f m across: no robot fits", s.widest_m),
            place_of(largest_, map_), "the resolution is too small, or walls are drawn too thick");
    }
    if (s.largest_free_m2 < kTornShare * s.free_m2) {
      hint(MapFault::TornSpace,
           formatted("the largest free space has %.0f %% of all", 100.0 * s.largest_free_m2 / s.free_m2),
           place_of(largest_, map_), "look for doors that are drawn shut; the rest cannot be reached");
    }
    if (largest_.at_border) {
      hint(MapFault::OpenBorder, "free space ends at the image's edge", place_of(largest_, map_),
           "if the place goes on there, the image was cut");
    }
  }

  void check_unknown() {
    const MapSummary& s = check_.summary;
    const double whole_m2 = s.width_m * s.height_m;
    if (s.free_m2 > 0.0 && s.free_m2 < kLeastFreeShare * whole_m2) {
      fault(MapFault::UnknownAreas,
            formatted("only %.1f %% of %.0f x %.0f m is known to be free", 100.0 * s.free_m2 / whole_m2, s.width_m,
                      s.height_m),
            "", "drive through the rest and build the map again, or cut stray points off");
    }
    std::vector<GridRegion> holes;
    for (const GridRegion& region : regions_) {
      const double area_m2 = static_cast<double>(region.cells) * cell_m2_;
      if (region.state != CellState::Unknown || region.at_border || region.free_sides == 0 || area_m2 < kHoleM2)
        continue;
      holes.push_back(region);
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [](const GridRegion& a, const GridRegion& b) { return a.cells > b.cells; });
    if (holes.size() > kMostListed) holes.resize(kMostListed);
    for (const GridRegion& hole : holes) {
      hint(MapFault::UnknownAreas,
           formatted("unknown area of %.1f m2 amid known space", static_cast<double>(hole.cells) * cell_m2_),
           place_of(hole, map_), "drive there if a robot or a person can be there; it counts as not searched");
    }
  }

  const OccupancyGrid& map_;
  double cell_m2_;
  std::vector<GridRegion> regions_;
  GridRegion known_;    ///< all that is free or occupied
  GridRegion largest_;  ///< of the free ones
  MapCheck check_;
};

}  // namespace

const char* name_of(MapFault fault) {
  constexpr std::array kNames{"nothing_known", "no_free_space",   "no_walls",        "too_small",
                              "too_large",     "cells_too_large", "cells_too_small", "walls_too_thick",
                              "narrow_space",  "torn_space",      "unknown_areas",   "open_border"};
  return kNames[static_cast<std::size_t>(fault)];
}

MapCheck check_map(const OccupancyGrid& map) {
  return Checking{map}.run();
}

bool has_faults(const MapCheck& check) {
  return std::any_of(check.findings.begin(), check.findings.end(),
                     [](const MapFinding& finding) { return finding.severity == Severity::Fault; });
}

}  // namespace tandem
