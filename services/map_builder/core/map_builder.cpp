#include "services/map_builder/core/map_builder.hpp"

#include <iterator>
#include <span>
#include <utility>

#include "services/map_builder/core/drive_trajectory.hpp"
#include "services/map_builder/core/grid_drawing.hpp"
#include "services/mapping/core/sha256.hpp"

namespace tandem {
namespace {

constexpr double kTrackingShare = 0.6;  ///< of the whole work
constexpr double kRefiningShare = 0.3;
constexpr double kWorthMovingM = 0.05;  ///< A closure that moves the robot less waits for the next optimisation.
constexpr int kIterations = 20;

std::vector<PoseEdge> edges_of(const MapGraph& graph) {
  std::vector<PoseEdge> edges = graph.chain;
  edges.insert(edges.end(), graph.closures.begin(), graph.closures.end());
  return edges;
}

}  // namespace

MapBuild::MapBuild(const Drive& drive, const MapBuilderConfig& config, BuildState state)
    : drive_(drive),
      config_(config),
      state_(std::move(state)),
      tracker_(config),
      finder_(config, state_.closure_memory) {}

void MapBuild::advance() {
  switch (state_.stage) {
    case BuildStage::Scans:
      if (state_.is_unsettled) {
        settle();
        tracker_.forget_local_map();
        state_.is_unsettled = false;
      } else if (state_.graph.places.size() < drive_.scans.size()) {
        take_in_next_scan();
      } else {
        state_.stage = BuildStage::Settling;
      }
      break;
    case BuildStage::Settling:
      settle();
      state_.stage = BuildStage::Neighbours;
      break;
    case BuildStage::Neighbours:
      if (is_refined(state_.refinement, config_)) {
        state_.stage = BuildStage::Drawing;
      } else {
        refine_neighbours(state_.refinement, state_.graph, drive_, config_);
      }
      break;
    case BuildStage::Drawing:
      break;
  }
}

void MapBuild::take_in_next_scan() {
  const std::size_t index = state_.graph.places.size();
  if (!tracker_.add(index, drive_.scans[index], state_.graph)) return;
  const auto closure = finder_.add(state_.graph);
  state_.closure_memory = finder_.memory();
  if (!closure) return;
  state_.graph.closures.push_back(closure->edge);
  state_.is_unsettled = closure->correction.position().norm() >= kWorthMovingM;
}

/// All poses where chain and closures agree best; closures that do not agree are rejected.
void MapBuild::settle() {
  MapGraph& graph = state_.graph;
  const std::vector<Pose2> before = graph.poses;
  optimise(graph.poses, edges_of(graph), Weighting::Full, kIterations);
  optimise(graph.poses, edges_of(graph), Weighting::Robust, kIterations);
  const auto wrong = std::erase_if(graph.closures, [&](const PoseEdge& closure) {
    return deviations_off(closure, graph.poses) > config_.closure_reject;
  });
  if (wrong == 0) return;
  state_.rejected += wrong;
  graph.poses = before;
  optimise(graph.poses, edges_of(graph), Weighting::Robust, kIterations);
}

BuildProgress MapBuild::progress() const {
  if (drive_.scans.empty()) return {"scans", 0.0};
  switch (state_.stage) {
    case BuildStage::Scans:
    case BuildStage::Settling:
      return {"scans", kTrackingShare * static_cast<double>(state_.graph.places.size()) /
                           static_cast<double>(drive_.scans.size())};
    case BuildStage::Neighbours:
      return {"neighbours", kTrackingShare + kRefiningShare * refined_share(state_.refinement, state_.graph, config_)};
    case BuildStage::Drawing:
      break;
  }
  return {"drawing", kTrackingShare + kRefiningShare};
}

std::optional<BuiltMap> MapBuild::drawn(const std::function<bool(const BuildProgress&)>& keep_going) const {
  const MapGraph& graph = state_.graph;
  const std::vector<Pose2> poses = scan_poses(graph);
  const std::span<const MapScan> used{drive_.scans.data(), poses.size()};
  bool is_whole = true;
  BuiltMap map;
  map.grid = drawn_grid(used, poses, config_, [&](double share) {
    const double before = kTrackingShare + kRefiningShare;
    is_whole = keep_going({"drawing", before + (1.0 - before) * share});
    return is_whole;
  });
  if (!is_whole) return std::nullopt;
  for (std::size_t i = 0; i < poses.size(); ++i) map.scan_poses.push_back({used[i].stamp, poses[i]});
  map.trajectory = trajectory_of(drive_, poses);
  for (const PoseEdge& edge : graph.closures) {
    const auto timed = [&](std::size_t node) {
      return TimedPose{used[graph.nodes[node].scan].stamp, graph.poses[node]};
    };
    map.closures.push_back({timed(edge.from), timed(edge.to)});
  }
  map.rejected = state_.rejected;
  map.nodes = graph.nodes.size();
  return map;
}

BuiltMap build_map(const Drive& drive, const MapBuilderConfig& config) {
  MapBuild build{drive, config};
  while (!build.is_done()) build.advance();
  return *build.drawn([](const BuildProgress&) { return true; });
}

std::string hash_of(const MapBuilderConfig& config) {
  return sha256_hex(write_config(config)).substr(0, 16);
}

}  // namespace tandem
