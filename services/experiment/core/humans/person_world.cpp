#include "services/experiment/core/humans/person_world.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

namespace tandem::experiment {
namespace {

constexpr double kStandReach_m = 0.75;  ///< who is this far off the area still looks from its border
constexpr double kNodeReach_m = 0.6;    ///< from a cell to where a body can stand
constexpr double kStartReach_m = 3.0;

MotionOptions body_of(const Searcher& person) {
  MotionOptions options;
  options.radius_m = person.radius_m;
  options.preferred_clearance_m = person.preferred_clearance_m;
  return options;
}

}  // namespace

PersonWorld::PersonWorld(OccupancyGrid map, const Searcher& person, const SearchAreaOptions& options)
    : map_(std::move(map)),
      area_(map_, options),
      view_range_m_(person.view_max_m),
      sight_(map_, area_, person.view_max_m),
      motion_(map_, body_of(person)) {
  if (area_.size() == 0) throw std::invalid_argument("there is no floor to search around the start");
  node_of_cell_.reserve(static_cast<std::size_t>(area_.size()));
  for (int cell = 0; cell < area_.size(); ++cell) {
    node_of_cell_.push_back(motion_.nearest_node(area_.point(cell), kNodeReach_m));
  }
}

const View& PersonWorld::view_at(const Eigen::Vector2d& point_in_map) {
  static const View nothing;
  const auto cell = area_.nearest_cell(point_in_map, kStandReach_m);
  return cell ? view_from(*cell) : nothing;
}

std::optional<ShortestPaths> PersonWorld::ways_from(const Eigen::Vector2d& point_in_map) const {
  const auto node = motion_.nearest_node(point_in_map, kStartReach_m);
  if (!node) return std::nullopt;
  return motion_.shortest_paths(*node);
}

double PersonWorld::distance_m(const ShortestPaths& ways, int cell) const {
  const auto& node = node_of_cell_[static_cast<std::size_t>(cell)];
  return node ? ways.cost_m[static_cast<std::size_t>(*node)] : std::numeric_limits<double>::infinity();
}

std::vector<Eigen::Vector2d> PersonWorld::way(const ShortestPaths& ways, int cell) const {
  const auto& node = node_of_cell_[static_cast<std::size_t>(cell)];
  if (!node) return {};
  return motion_.way(ways, *node, motion_.point(ways.from), motion_.point(*node));
}

void OwnMemory::look(PersonWorld& world, const Eigen::Vector2d& point_in_map) {
  for (const int cell : world.view_at(point_in_map)) seen_[static_cast<std::size_t>(cell)] = true;
}

double OwnMemory::news_m2(PersonWorld& world, int cell) const {
  double news_m2 = 0.0;
  for (const int other : world.view_from(cell)) {
    if (!has_seen(other)) news_m2 += world.area().floor_m2(other);
  }
  return news_m2;
}

}  // namespace tandem::experiment
