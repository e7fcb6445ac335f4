#pragma once

#include <optional>

#include "services/map_builder/core/local_map.hpp"
#include "services/map_builder/core/map_graph.hpp"

namespace tandem {

/// Follows the robot scan by scan: each is laid onto what the last nodes saw, and some become nodes themselves.
///
/// The wheels' prediction is the start; where it fits badly, or the robot moved far, the surroundings are searched.
class ScanTracker {
 public:
  explicit ScanTracker(const MapBuilderConfig& config) : config_(config) {}

  /// Takes the next scan of the drive, whose index is `index`; true if it became a node.
  bool add(std::size_t index, const MapScan& scan, MapGraph& graph);
  /// The poses of the graph have changed.
  void forget_local_map() { local_.reset(); }

 private:
  [[nodiscard]] Registration laid(const MapScan& scan, const Surface& surface, const Pose2& predicted,
                                  const MapGraph& graph);
  void refresh(const MapGraph& graph);

  MapBuilderConfig config_;
  std::optional<LocalMap> local_;  ///< around the last nodes; follows from the graph alone
};

}  // namespace tandem
