#pragma once

#include <cstddef>
#include <cstdint>

#include "services/map_builder/core/closure_finder.hpp"
#include "services/map_builder/core/map_graph.hpp"
#include "services/map_builder/core/neighbour_refinement.hpp"

namespace tandem {

/// What a build is at.
enum class BuildStage : std::uint8_t { Scans, Settling, Neighbours, Drawing };

/// Where a build stands between two pieces of work: with the drive and the configuration, all that decides how it goes
/// on.
struct BuildState {
  BuildStage stage = BuildStage::Scans;
  MapGraph graph;
  ClosureMemory closure_memory;
  bool is_unsettled = false;  ///< a new closure moves the poses before the next scan is taken in
  std::size_t rejected = 0;   ///< closures that did not agree with the rest
  RefinementState refinement;
};

}  // namespace tandem
