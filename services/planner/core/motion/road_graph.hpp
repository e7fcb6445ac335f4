#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "services/planner/core/motion/local_search.hpp"

namespace tandem {

/// The ways between places: each is joined to the lookouts nearest to it, further ones are reached over those in
/// between. So nothing here grows with the square of the map. Added places are joined to more lookouts, and to each
/// other.
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
  /// Where they lead, packed for those who ask often.
  [[nodiscard]] const std::vector<std::int32_t>& ends(int place);
  /// The cost of the way from one place to another [m], infinite if there is none.
  [[nodiscard]] double cost_m(int from, int to);
  /// Reaches lookouts from `from` over roads in the order of their cost, and calls `reached` with each, `from` itself
  /// not among them; stops when it gives false. `reached` must not ask for ways itself. Looks no further than that,
  /// whatever the size of the map.
  void explore(int from, const std::function<bool(int lookout, double cost_m)>& reached);
  /// The places that way leads over, `to` the last, each near to the one before; only {to} where lookouts nearby do
  /// not lead there; empty if there is no way.
  [[nodiscard]] const std::vector<int>& stops(int from, int to);
  /// The nodes of the direct way from one place to another; empty if there is none.
  [[nodiscard]] std::vector<int> nodes(int from, int to);

  [[nodiscard]] int lookouts() const { return lookouts_; }
  [[nodiscard]] int node(int place) const { return nodes_[static_cast<std::size_t>(place)]; }

 private:
  [[nodiscard]] std::vector<int> found_stops(int from, int to);
  /// Per lookout the cost of the cheapest way there over roads [m].
  [[nodiscard]] const std::vector<float>& row(int from);
  [[nodiscard]] const Road* road_between(int from, int to);
  [[nodiscard]] const ShortestPaths& all_paths(int from);
  /// The straight road between two added places.
  [[nodiscard]] const Road& road_between_added(int from, int to);
  /// The lookout over which an added place is reached best, and that way's cost.
  [[nodiscard]] std::pair<const Road*, double> last_road(int from, int to);

  const MotionMap& motion_;
  int lookouts_ = 0;
  std::size_t nearest_ = 0;
  std::vector<int> nodes_;              ///< per place
  std::vector<std::int32_t> place_at_;  ///< per node its place, -1 none
  std::vector<std::vector<Road>> roads_;
  std::vector<std::vector<std::int32_t>> ends_;  ///< of the roads
  std::vector<bool> roads_known_;
  std::map<int, std::vector<float>> rows_;
  std::map<std::pair<int, int>, Road> added_roads_;
  std::unordered_map<std::uint64_t, std::vector<int>> stops_;        ///< by both lookouts
  std::unordered_map<std::uint64_t, std::vector<int>> added_stops_;  ///< where one of them was added
  std::map<int, ShortestPaths> all_paths_;                           ///< where lookouts nearby do not lead everywhere
  LocalSearch search_;
  // Of the last exploration.
  struct Open {
    float cost_m;
    std::int32_t lookout;
  };
  std::uint32_t exploration_ = 0;
  std::vector<std::uint32_t> reached_in_;  ///< per lookout, the last exploration that reached it
  std::vector<float> reached_m_;
  std::vector<std::int32_t> reached_from_;  ///< the lookout before, -1: from the beginning
  std::vector<Open> open_;                  ///< a heap
};

}  // namespace tandem
