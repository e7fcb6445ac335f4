#pragma once

#include <map>
#include <optional>
#include <vector>

#include "services/planner/core/motion/local_search.hpp"

namespace tandem {

/// The ways between places: each is joined to the lookouts nearest to it, further ones are reached over those in
/// between. So nothing here grows with the square of the map.
///
/// Places 0 .. lookouts - 1 are lookouts, others are added and forgotten again. Ways are found when first asked for and
/// kept.
class RoadGraph {
 public:
  /// A place near another one.
  struct Road {
    int to = -1;
    double cost_m = 0.0;     ///< clearance counted
    std::vector<int> nodes;  ///< of the motion map, from the one to the other
  };

  /// `motion` must outlive it. `lookouts`: their nodes, all different. Each place is joined to its `nearest` lookouts.
  RoadGraph(const MotionMap& motion, std::vector<int> lookouts, int nearest);

  /// Adds a place at a node.
  int add_place(int node);
  /// Forgets what add_place() added.
  void forget_added_places();

  /// The lookouts nearest to `place` and the ways there, itself not among them, the nearest first.
  [[nodiscard]] const std::vector<Road>& roads(int place);
  /// The cost of the way from one place to another [m], infinite if there is none.
  [[nodiscard]] double cost_m(int from, int to);
  /// The nodes on that way; empty if there is none.
  [[nodiscard]] std::vector<int> nodes(int from, int to);

  [[nodiscard]] int lookouts() const { return lookouts_; }
  [[nodiscard]] int node(int place) const { return nodes_[static_cast<std::size_t>(place)]; }

 private:
  /// The cheapest ways from one place over lookouts.
  struct Row {
    std::vector<float> cost_m;  ///< per lookout
    std::vector<int> previous;  ///< per lookout the one before, -1: from the place itself
  };
  [[nodiscard]] const Row& row(int from);
  [[nodiscard]] const Road* road_between(int from, int to);
  [[nodiscard]] const ShortestPaths& all_paths(int from);
  /// The lookout over which an added place is reached best, and that way's cost.
  [[nodiscard]] std::pair<const Road*, double> last_road(int from, int to);
  [[nodiscard]] std::vector<int> nodes_to_lookout(int from, int lookout);

  const MotionMap& motion_;
  int lookouts_ = 0;
  std::size_t nearest_ = 0;
  std::vector<int> nodes_;              ///< per place
  std::vector<std::int32_t> place_at_;  ///< per node its place, -1 none
  std::vector<std::vector<Road>> roads_;
  std::vector<bool> roads_known_;
  std::map<int, Row> rows_;
  std::map<int, ShortestPaths> all_paths_;  ///< where lookouts nearby do not lead everywhere
  LocalSearch search_;
};

}  // namespace tandem
