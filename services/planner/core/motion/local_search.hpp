#pragma once

#include <functional>
#include <vector>

#include "services/planner/core/motion/motion_map.hpp"

namespace tandem {

/// Cheapest ways from one node to its surroundings: looks only as far as it must, whatever the size of the map, and
/// keeps its memory from search to search.
class LocalSearch {
 public:
  /// `motion` must outlive it.
  explicit LocalSearch(const MotionMap& motion);

  /// Reaches nodes of `motion` from `from` in the order of their cost, and calls `reached` with each; stops when it
  /// gives false.
  void run(int from, const std::function<bool(int node, double cost_m)>& reached);
  /// The nodes from the start of the last search to `node`, which it has reached.
  [[nodiscard]] std::vector<int> nodes_to(int node) const;

 private:
  struct Entry {
    float cost_m;
    std::int32_t node;
  };
  const MotionMap& motion_;
  std::uint32_t search_ = 0;
  std::vector<std::uint32_t> seen_in_;  ///< per node, the last search that saw it
  std::vector<float> cost_m_;
  std::vector<std::int32_t> previous_;
  std::vector<Entry> open_;  ///< a heap
};

}  // namespace tandem
