#include "services/map_builder/core/scan_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kSearchReachM = 18.0;   ///< Points further away do not help a search.
constexpr double kFarMotionM = 0.0;      ///< After a motion this far ...
constexpr double kFarMotionRad = 0.12;   ///< ... or this wide the wheels are not trusted to start from.
constexpr double kClearlyBetter = 0.05;  ///< A search that matches so much more of the scan is believed.

/// Information as good as none, to keep what the scan does not tell near the guess.
Eigen::Matrix3d weak_information() {
  return Eigen::Vector3d{25.0, 25.0, 100.0}.asDiagonal();
}

}  // namespace

bool ScanTracker::add(std::size_t index, const MapScan& scan, MapGraph& graph) {
  Surface surface = surface_of(scan, config_);
  if (graph.nodes.empty()) {
    graph.nodes.push_back({.scan = index, .way_m = 0.0, .surface = SurfaceIndex{std::move(surface)}});
    graph.poses.emplace_back();
    graph.places.push_back({});
    return true;
  }
  const ScanPlace& before = graph.places.back();
  const Pose2 map_from_last = graph.poses[before.node] * before.node_from_base;
  const Pose2 predicted = map_from_last * scan.motion.value_or(Pose2{});
  const Registration found = laid(scan, surface, predicted, graph);
  const Pose2 moved = inverse(map_from_last) * found.reference_from_scan;
  graph.way_m += moved.position().norm();

  const std::size_t last_node = graph.nodes.size() - 1;
  const Pose2 node_from_base = inverse(graph.poses[last_node]) * found.reference_from_scan;
  if (node_from_base.position().norm() < config_.node_spacing_m &&
      std::abs(node_from_base.heading) < config_.node_spacing_rad) {
    graph.places.push_back({last_node, node_from_base});
    return false;
  }
  const Eigen::Matrix3d information =
      found.information + (scan.motion ? information_of_wheels(node_from_base, config_) : weak_information());
  graph.chain.push_back({.from = last_node,
                         .to = last_node + 1,
                         .from_pose_to_pose = node_from_base,
                         .root_information = root_information_in_a(node_from_base, information)});
  graph.poses.push_back(found.reference_from_scan);
  graph.nodes.push_back({.scan = index, .way_m = graph.way_m, .surface = SurfaceIndex{std::move(surface)}});
  graph.places.push_back({last_node + 1, {}});
  local_.reset();
  return true;
}

Registration ScanTracker::laid(const MapScan& scan, const Surface& surface, const Pose2& predicted,
                               const MapGraph& graph) {
  if (!local_) refresh(graph);
  RegistrationOptions options = registration_options(config_);
  options.prior = scan.motion ? information_of_wheels(*scan.motion, config_) : weak_information();
  const Pose2 motion = scan.motion.value_or(Pose2{});
  const double way_m = motion.position().norm();
  const double turn_rad = std::abs(motion.heading);

  Pose2 guess = predicted;
  if (scan.motion && (way_m > kFarMotionM || turn_rad > kFarMotionRad)) {
    guess = local_->best_pose(surface, predicted,
                              {.half_side_m = 0.35 + 0.3 * way_m,
                               .half_turn_rad = 0.1 + 0.25 * turn_rad,
                               .step_m = 0.1,
                               .step_rad = 0.02,
                               .prior_weight = 0.1});
  }
  Registration found = registered(local_->index(), surface, guess, options);
  if (scan.motion && found.matched_share >= config_.search_below) return found;

  guess = local_->best_pose(surface, predicted,
                            {.half_side_m = config_.search_window_m,
                             .half_turn_rad = config_.search_window_rad,
                             .step_m = 0.1,
                             .step_rad = 0.02,
                             .prior_weight = 0.1});
  options.prior = weak_information();
  const Registration searched = registered(local_->index(), surface, guess, options);
  if (searched.matched_share > found.matched_share + kClearlyBetter) found = searched;
  return found;
}

void ScanTracker::refresh(const MapGraph& graph) {
  SurfaceUnion all{config_.local_cell_m};
  for (std::size_t i = graph.nodes.size(); i-- > 0;) {  // the newest is the least drifted
    if (graph.nodes.back().way_m - graph.nodes[i].way_m > config_.local_way_m) break;
    all.add(graph.poses[i], graph.nodes[i].surface.surface());
  }
  local_.emplace(all.take(), graph.poses.back().position(), kSearchReachM);
}

}  // namespace tandem
