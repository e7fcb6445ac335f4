#pragma once

#include <optional>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"
#include "services/planner/core/motion/motion_map.hpp"
#include "services/planner/core/search/observability.hpp"
#include "services/planner/core/search/search_area.hpp"
#include "services/planner/core/search/searcher.hpp"

namespace tandem::experiment {

/// The searched place as a person knows it who goes by their own head: a map, ways on it, what can be seen from where.
///
/// Nothing of the team's belief. Views are found when first asked for and kept, so asking changes the object: one per
/// thread; what it answers does not depend on what was asked before.
class PersonWorld {
 public:
  /// `person` looks to all sides. Throws std::invalid_argument where there is no floor around the start.
  PersonWorld(OccupancyGrid map, const Searcher& person, const SearchAreaOptions& options);
  PersonWorld(const PersonWorld&) = delete;  // its parts point at each other
  PersonWorld& operator=(const PersonWorld&) = delete;

  [[nodiscard]] const SearchArea& area() const { return area_; }
  [[nodiscard]] double view_range_m() const { return view_range_m_; }
  /// The cells that the person sees from the middle of `cell`.
  [[nodiscard]] const View& view_from(int cell) { return sight_.in_sight_of(cell); }
  /// The cells that the person sees from there; none from outside the area.
  [[nodiscard]] const View& view_at(const Eigen::Vector2d& point_in_map);

  /// Ways from a point to everywhere else. None where a person cannot stand near the point.
  [[nodiscard]] std::optional<ShortestPaths> ways_from(const Eigen::Vector2d& point_in_map) const;
  /// How far it is to `cell`, clearance counted [m]; infinite where no way leads.
  [[nodiscard]] double distance_m(const ShortestPaths& ways, int cell) const;
  /// The way to `cell`, from start to end [m]; empty where none leads.
  [[nodiscard]] std::vector<Eigen::Vector2d> way(const ShortestPaths& ways, int cell) const;

 private:
  OccupancyGrid map_;
  SearchArea area_;
  double view_range_m_;
  Observability sight_;
  MotionMap motion_;
  std::vector<std::optional<int>> node_of_cell_;
};

/// Which cells a person has looked at, by themselves.
class OwnMemory {
 public:
  explicit OwnMemory(const PersonWorld& world) : seen_(static_cast<std::size_t>(world.area().size()), false) {}

  /// Looks around.
  void look(PersonWorld& world, const Eigen::Vector2d& point_in_map);
  [[nodiscard]] bool has_seen(int cell) const { return seen_[static_cast<std::size_t>(cell)]; }
  /// The floor that would be seen from `cell` for the first time [m2].
  [[nodiscard]] double news_m2(PersonWorld& world, int cell) const;

 private:
  std::vector<bool> seen_;
};

}  // namespace tandem::experiment
