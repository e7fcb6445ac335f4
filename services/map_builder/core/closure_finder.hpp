#pragma once

#include <optional>

#include "services/map_builder/core/map_graph.hpp"

namespace tandem {

/// The newest node saw a place that an older one knew.
struct Closure {
  PoseEdge edge;          ///< from the older node to the newest
  Pose2 map_from_newest;  ///< where the newest is, by what it saw
  Pose2 correction;       ///< of the newest node, in its own frame
  double matched_share = 0.0;
};

/// What the search for closures keeps from one look to the next.
struct ClosureMemory {
  double looked_at_m = 0.0;                     ///< way at the last look
  double closed_at_m = 0.0;                     ///< way at the last closure
  std::optional<Pose2> unconfirmed_correction;  ///< of the last look, if it waits for the next to agree
  std::size_t doubted = 0;                      ///< how often a place was found but not believed
};

/// Looks for places where the robot has been before.
///
/// What it saw on the last metres, together, is searched in all that it saw longer ago around where it should be, by
/// branch and bound; the window grows with the way since the last closure. A place must fit well, be the only one that
/// does, and match when laid on point by point. One that moves the robot far must be confirmed by the next.
class ClosureFinder {
 public:
  explicit ClosureFinder(const MapBuilderConfig& config, const ClosureMemory& memory = {})
      : config_(config), memory_(memory) {}

  /// Call after each new node; looks when it is time. None, or a closure to be believed.
  [[nodiscard]] std::optional<Closure> add(const MapGraph& graph);
  /// With this another finder goes on where this one is.
  [[nodiscard]] const ClosureMemory& memory() const { return memory_; }

 private:
  [[nodiscard]] std::optional<Closure> found(const MapGraph& graph) const;
  [[nodiscard]] bool is_confirmed(const Closure& closure);

  MapBuilderConfig config_;
  ClosureMemory memory_;
};

}  // namespace tandem
