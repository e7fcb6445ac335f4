#pragma once

#include <cstddef>
#include <vector>

#include "services/map_builder/core/map_graph.hpp"

namespace tandem {

/// How far a refinement is.
struct RefinementState {
  std::size_t round = 0;        ///< rounds that are whole
  std::size_t node = 1;         ///< the next whose neighbours are looked for in this round
  std::vector<PoseEdge> pairs;  ///< found in this round
};

/// Lays every node's scan onto those of its neighbours, on the way and in place, and moves all poses to where the pairs
/// and the wheels agree best; `refine_rounds` times, as pairs are found better from better poses.
///
/// Each call finds the pairs of one node; after the last of them the next call moves the poses and ends the round.
void refine_neighbours(RefinementState& state, MapGraph& graph, const Drive& drive, const MapBuilderConfig& config);

/// Are all rounds whole?
[[nodiscard]] bool is_refined(const RefinementState& state, const MapBuilderConfig& config);
/// How much of the work is done, [0, 1].
[[nodiscard]] double refined_share(const RefinementState& state, const MapGraph& graph, const MapBuilderConfig& config);

}  // namespace tandem
