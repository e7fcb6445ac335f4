#include "services/map_builder/core/neighbour_refinement.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr std::size_t kOnTheWay = 3;      ///< Each node is laid onto so many before it.
constexpr double kApartOnWayM = 1.0;      ///< Two neighbours in place are this far apart on the way.
constexpr double kMetresPerRadian = 1.5;  ///< A neighbour that looks another way is as good as one further away.
constexpr double kLaterReachM = 0.2;      ///< of the first pairs, after the first round
constexpr double kWheelsLoss = 1.0;       ///< Wheels slip.
constexpr int kIterations = 30;

/// Earlier nodes near to node `at` in place, the best first, each of another pass.
std::vector<std::size_t> neighbours_of(std::size_t at, const MapGraph& graph, const MapBuilderConfig& config) {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i + kOnTheWay < at; ++i) {
    const double distance_m = (graph.poses[i].position() - graph.poses[at].position()).norm();
    if (distance_m > config.refine_reach_m) continue;
    const double turn_rad = std::abs(turn_between(graph.poses[i].heading, graph.poses[at].heading));
    near.emplace_back(distance_m + kMetresPerRadian * turn_rad, i);
  }
  std::sort(near.begin(), near.end());
  std::vector<std::size_t> chosen;
  for (const auto& [distance_m, i] : near) {
    if (chosen.size() == static_cast<std::size_t>(config.refine_neighbours)) break;
    const bool new_pass = std::none_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return std::abs(graph.nodes[other].way_m - graph.nodes[i].way_m) < kApartOnWayM;
    });
    if (new_pass) chosen.push_back(i);
  }
  for (std::size_t i = at > kOnTheWay ? at - kOnTheWay : 0; i < at; ++i) chosen.push_back(i);
  return chosen;
}

/// The wheels from each node to the next, where they are known all the way.
std::vector<PoseEdge> wheel_edges(const MapGraph& graph, const Drive& drive, const MapBuilderConfig& config) {
  std::vector<PoseEdge> edges;
  for (std::size_t i = 1; i < graph.nodes.size(); ++i) {
    Pose2 motion;
    bool known = true;
    for (std::size_t scan = graph.nodes[i - 1].scan + 1; scan <= graph.nodes[i].scan; ++scan) {
      known = known && drive.scans[scan].motion.has_value();
      if (known) motion = motion * *drive.scans[scan].motion;
    }
    if (!known) continue;
    edges.push_back({.from = i - 1,
                     .to = i,
                     .from_pose_to_pose = motion,
                     .root_information = root_information_in_a(motion, information_of_wheels(motion, config)),
                     .kind = EdgeKind::Odometry,
                     .loss = kWheelsLoss});
  }
  return edges;
}

void find_pairs_of_next(RefinementState& state, const MapGraph& graph, const MapBuilderConfig& config) {
  RegistrationOptions options = registration_options(config);
  if (state.round > 0) options.first_reach_m = std::min(options.first_reach_m, kLaterReachM);
  const std::size_t at = state.node++;
  for (const std::size_t other : neighbours_of(at, graph, config)) {
    const Registration laid = registered(graph.nodes[other].surface, graph.nodes[at].surface.surface(),
                                         inverse(graph.poses[other]) * graph.poses[at], options);
    if (laid.matched_share < config.refine_matched) continue;
    state.pairs.push_back({.from = other,
                           .to = at,
                           .from_pose_to_pose = laid.reference_from_scan,
                           .root_information = root_information_in_a(laid.reference_from_scan, laid.information),
                           .loss = config.refine_loss});
  }
}

}  // namespace

void refine_neighbours(RefinementState& state, MapGraph& graph, const Drive& drive, const MapBuilderConfig& config) {
  if (state.node < graph.nodes.size()) return find_pairs_of_next(state, graph, config);
  std::vector<PoseEdge> edges = wheel_edges(graph, drive, config);
  edges.insert(edges.end(), graph.closures.begin(), graph.closures.end());
  edges.insert(edges.end(), state.pairs.begin(), state.pairs.end());
  optimise(graph.poses, edges, Weighting::Robust, kIterations);
  state = {.round = state.round + 1, .node = 1, .pairs = {}};
}

bool is_refined(const RefinementState& state, const MapBuilderConfig& config) {
  return state.round >= static_cast<std::size_t>(config.refine_rounds);
}

double refined_share(const RefinementState& state, const MapGraph& graph, const MapBuilderConfig& config) {
  if (is_refined(state, config)) return 1.0;
  const double of_round = static_cast<double>(state.node) / static_cast<double>(graph.nodes.size() + 1);
  return (static_cast<double>(state.round) + of_round) / static_cast<double>(config.refine_rounds);
}

}  // namespace tandem
