#pragma once

#include <functional>

#include "services/map_builder/core/map_graph.hpp"

namespace tandem {

/// Lays every node's scan onto those of its neighbours, on the way and in place, and moves all poses to where the pairs
/// and the wheels agree best; `rounds` times, as pairs are found better from better poses.
///
/// `keep_going` hears the share done, and ends the work with false: the poses are then those of the last whole round.
void refine_neighbours(MapGraph& graph, const Drive& drive, const MapBuilderConfig& config,
                       const std::function<bool(double)>& keep_going);

}  // namespace tandem
