#include "services/map_builder/core/map_builder.hpp"

#include <algorithm>
#include <iterator>

#include "services/map_builder/core/closure_finder.hpp"
#include "services/map_builder/core/drive_trajectory.hpp"
#include "services/map_builder/core/grid_drawing.hpp"
#include "services/map_builder/core/neighbour_refinement.hpp"
#include "services/map_builder/core/scan_tracker.hpp"
#include "services/mapping/core/sha256.hpp"

namespace tandem {
namespace {

constexpr double kTrackingShare = 0.6;  ///< of the whole work
constexpr double kRefiningShare = 0.3;
constexpr double kWorthMovingM = 0.05;  ///< A closure that moves the robot less waits for the next optimisation.
constexpr int kIterations = 20;

/// Scans become a graph whose loops are closed.
class GraphBuilding {
 public:
  explicit GraphBuilding(const MapBuilderConfig& config) : config_(config), tracker_(config), finder_(config) {}

  void add(std::size_t index, const MapScan& scan) {
    if (!tracker_.add(index, scan, graph)) return;
    const auto closure = finder_.add(graph);
    if (!closure) return;
    graph.closures.push_back(closure->edge);
    if (closure->correction.position().norm() < kWorthMovingM) return;
    settle();
    tracker_.forget_local_map();
  }

  /// All poses where chain and closures agree best; closures that do not agree are rejected.
  void settle() {
    const std::vector<Pose2> before = graph.poses;
    optimise(graph.poses, edges(), Weighting::Full, kIterations);
    optimise(graph.poses, edges(), Weighting::Robust, kIterations);
    const auto wrong = std::erase_if(graph.closures, [this](const PoseEdge& closure) {
      return deviations_off(closure, graph.poses) > config_.closure_reject;
    });
    if (wrong == 0) return;
    rejected += wrong;
    graph.poses = before;
    optimise(graph.poses, edges(), Weighting::Robust, kIterations);
  }

  MapGraph graph;
  std::size_t rejected = 0;

 private:
  [[nodiscard]] std::vector<PoseEdge> edges() const {
    std::vector<PoseEdge> all = graph.chain;
    all.insert(all.end(), graph.closures.begin(), graph.closures.end());
    return all;
  }

  MapBuilderConfig config_;
  ScanTracker tracker_;
  ClosureFinder finder_;
};

}  // namespace

BuiltMap build_map(const Drive& drive, const MapBuilderConfig& config,
                   const std::function<bool(const BuildProgress&)>& keep_going) {
  BuiltMap map;
  GraphBuilding building{config};
  for (std::size_t i = 0; i < drive.scans.size() && map.complete; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(drive.scans.size());
    map.complete = keep_going({"scans", kTrackingShare * share});
    if (map.complete) building.add(i, drive.scans[i]);
  }
  building.settle();
  MapGraph& graph = building.graph;
  if (map.complete) {
    refine_neighbours(graph, drive, config, [&](double share) {
      map.complete = keep_going({"neighbours", kTrackingShare + kRefiningShare * share});
      return map.complete;
    });
  }
  const std::vector<Pose2> poses = scan_poses(graph);
  const std::span<const MapScan> used{drive.scans.data(), poses.size()};
  // What is there is drawn whole even after a stop: it takes a moment.
  map.grid = drawn_grid(used, poses, config, [&](double share) {
    (void)keep_going({"drawing", kTrackingShare + kRefiningShare + (1.0 - kTrackingShare - kRefiningShare) * share});
    return true;
  });
  for (std::size_t i = 0; i < poses.size(); ++i) map.scan_poses.push_back({used[i].stamp, poses[i]});
  map.trajectory = trajectory_of(drive, poses);
  for (const PoseEdge& edge : graph.closures) {
    const auto timed = [&](std::size_t node) {
      return TimedPose{used[graph.nodes[node].scan].stamp, graph.poses[node]};
    };
    map.closures.push_back({timed(edge.from), timed(edge.to)});
  }
  map.rejected = building.rejected;
  map.nodes = graph.nodes.size();
  return map;
}

std::string hash_of(const MapBuilderConfig& config) {
  return sha256_hex(write_config(config)).substr(0, 16);
}

}  // namespace tandem
