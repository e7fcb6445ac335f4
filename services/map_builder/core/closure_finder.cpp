#include "services/map_builder/core/closure_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "services/localization/core/beams.hpp"
#include "services/localization/core/global_search.hpp"
#include "services/map_builder/core/local_map.hpp"

namespace tandem {
namespace {

constexpr double kOldCellM = 0.05;
constexpr double kViewCellM = 0.1;
constexpr double kFieldCellM = 0.1;
constexpr double kNearNodeM = 5.0;  ///< An older node this near to the window makes a search worth while.
constexpr std::size_t kSearchedPoints = 200;
constexpr std::size_t kLaidPoints = 500;
constexpr std::size_t kFewestPoints = 60;

/// What is searched: the last metres, seen from the newest node.
Surface recent_view(const MapGraph& graph, double way_m) {
  SurfaceUnion view{kViewCellM};
  const Pose2 base_from_map = inverse(graph.poses.back());
  for (std::size_t i = graph.nodes.size(); i-- > 0;) {
    if (graph.nodes.back().way_m - graph.nodes[i].way_m > way_m) break;
    view.add(base_from_map * graph.poses[i], graph.nodes[i].surface.surface());
  }
  return view.take();
}

struct OldPlaces {
  Surface surface_in_map;
  double nearest_m = std::numeric_limits<double>::infinity();  ///< of its nodes to the newest
};

/// All that nodes until `way_m` saw around the newest.
OldPlaces old_places(const MapGraph& graph, double way_m, double reach_m) {
  OldPlaces old;
  SurfaceUnion all{kOldCellM};
  for (std::size_t i = 0; i < graph.nodes.size() && graph.nodes[i].way_m <= way_m; ++i) {
    const double distance_m = (graph.poses[i].position() - graph.poses.back().position()).norm();
    if (distance_m > reach_m) continue;
    old.nearest_m = std::min(old.nearest_m, distance_m);
    all.add(graph.poses[i], graph.nodes[i].surface.surface());
  }
  old.surface_in_map = all.take();
  return old;
}

/// The older node that a closure at `map_from_newest` is tied to.
std::size_t nearest_old_node(const MapGraph& graph, double way_m, const Pose2& map_from_newest) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < graph.nodes.size() && graph.nodes[i].way_m <= way_m; ++i) {
    const double distance2 = (graph.poses[i].position() - map_from_newest.position()).squaredNorm();
    if (distance2 >= least) continue;
    least = distance2;
    nearest = i;
  }
  return nearest;
}

}  // namespace

std::optional<Closure> ClosureFinder::add(const MapGraph& graph) {
  const double way_m = graph.nodes.back().way_m;
  if (way_m - memory_.looked_at_m < config_.closure_every_m) return std::nullopt;
  memory_.looked_at_m = way_m;
  auto closure = found(graph);
  if (!closure) return std::nullopt;
  if (!is_confirmed(*closure)) {
    ++memory_.doubted;
    return std::nullopt;
  }
  memory_.closed_at_m = way_m;
  return closure;
}

bool ClosureFinder::is_confirmed(const Closure& closure) {
  const bool far = closure.correction.position().norm() > config_.closure_far_m;
  const auto before = std::exchange(memory_.unconfirmed_correction, closure.correction);
  if (!far) {
    memory_.unconfirmed_correction.reset();
    return true;
  }
  if (!before) return false;
  // Nothing was closed in between: both corrections are about the same drift.
  const Pose2 apart = inverse(*before) * closure.correction;
  const bool agree =
      apart.position().norm() < config_.closure_agreement_m && std::abs(apart.heading) < config_.closure_agreement_rad;
  if (agree) memory_.unconfirmed_correction.reset();
  return agree;
}

std::optional<Closure> ClosureFinder::found(const MapGraph& graph) const {
  const double way_m = graph.nodes.back().way_m;
  const double old_until_m = way_m - config_.closure_way_m - config_.closure_min_way_m;
  const double since_m = way_m - memory_.closed_at_m;
  const PoseArea area{
      graph.poses.back(),
      std::min(config_.closure_window_max_m, config_.closure_window_m + config_.closure_window_per_m * since_m),
      std::min(config_.closure_window_max_rad,
               config_.closure_window_rad + config_.closure_window_rad_per_m * since_m)};
  const double reach_m = area.half_side_m + GlobalSearch::kReachM;
  const OldPlaces old = old_places(graph, old_until_m, reach_m);
  if (old.nearest_m > area.half_side_m + kNearNodeM || old.surface_in_map.size() < kFewestPoints) return std::nullopt;

  const Surface view = recent_view(graph, config_.closure_way_m);
  const LocalMap map{old.surface_in_map, area.centre_in_map.position(), reach_m};
  const OccupancyGrid grid = map.grid(kFieldCellM);
  const GlobalSearch search{grid, LocalMap::field_of(grid)};
  GlobalSearchOptions options;
  options.count = 2;
  options.margin = config_.closure_margin;
  options.within = area;
  const auto candidates = search.candidates(points_of(view, kSearchedPoints, GlobalSearch::kReachM), options);
  if (candidates.empty() || candidates.front().score < config_.closure_score) return std::nullopt;
  if (candidates.size() > 1) return std::nullopt;  // two places alike

  const Surface few = evenly(std::span<const SurfacePoint>{view}, kLaidPoints);
  const Registration laid =
      registered(map.index(), few, candidates.front().map_from_base, registration_options(config_));
  if (laid.matched_share < config_.closure_matched) return std::nullopt;

  Closure closure{
      .edge = {}, .map_from_newest = laid.reference_from_scan, .correction = {}, .matched_share = laid.matched_share};
  closure.correction = inverse(graph.poses.back()) * laid.reference_from_scan;
  closure.edge.from = nearest_old_node(graph, old_until_m, laid.reference_from_scan);
  closure.edge.to = graph.nodes.size() - 1;
  closure.edge.from_pose_to_pose = inverse(graph.poses[closure.edge.from]) * laid.reference_from_scan;
  closure.edge.root_information = root_information_in_a(closure.edge.from_pose_to_pose, laid.information);
  closure.edge.kind = EdgeKind::Closure;
  closure.edge.loss = config_.closure_loss;
  return closure;
}

}  // namespace tandem
