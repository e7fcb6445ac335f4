#include "services/map_builder/core/build_checkpoint.hpp"

#include <algorithm>
#include <utility>

#include "services/common/config.hpp"
#include "services/map_builder/core/state_bytes.hpp"
#include "services/mapping/core/sha256.hpp"

namespace tandem {
namespace {

constexpr std::string_view kFormat = "tandem map build checkpoint 1";
constexpr std::string_view kNoLine = "";

// The fields of a state, each named once for NumberWriter and NumberReader.

void visit_pose(auto& bytes, auto& pose) {
  bytes.number(pose.x);
  bytes.number(pose.y);
  bytes.number(pose.heading);
}

void visit_poses(auto& bytes, auto& poses) {
  bytes.size(poses);
  for (auto& pose : poses) visit_pose(bytes, pose);
}

void visit_edges(auto& bytes, auto& edges) {
  bytes.size(edges);
  for (auto& edge : edges) {
    bytes.number(edge.from);
    bytes.number(edge.to);
    visit_pose(bytes, edge.from_pose_to_pose);
    for (Eigen::Index i = 0; i < edge.root_information.size(); ++i) bytes.number(edge.root_information.data()[i]);
    bytes.number(edge.kind);
    bytes.number(edge.loss);
  }
}

void visit_graph(auto& bytes, auto& graph) {
  visit_poses(bytes, graph.poses);
  visit_edges(bytes, graph.chain);
  visit_edges(bytes, graph.closures);
  bytes.size(graph.places);
  for (auto& place : graph.places) {
    bytes.number(place.node);
    visit_pose(bytes, place.node_from_base);
  }
  bytes.number(graph.way_m);
}

void visit_memory(auto& bytes, auto& memory, auto& has_correction, auto& correction) {
  bytes.number(memory.looked_at_m);
  bytes.number(memory.closed_at_m);
  bytes.number(memory.doubted);
  bytes.number(has_correction);
  visit_pose(bytes, correction);
}

void visit_rest(auto& bytes, auto& state) {
  bytes.number(state.stage);
  bytes.number(state.is_unsettled);
  bytes.number(state.rejected);
  bytes.number(state.refinement.round);
  bytes.number(state.refinement.node);
  visit_edges(bytes, state.refinement.pairs);
}

std::string bytes_of(const BuildState& state) {
  NumberWriter bytes;
  bytes.size(state.graph.nodes);
  for (const MapNode& node : state.graph.nodes) {
    bytes.number(node.scan);
    bytes.number(node.way_m);
  }
  visit_graph(bytes, state.graph);
  const auto& correction = state.closure_memory.unconfirmed_correction;
  const bool has_correction = correction.has_value();
  const Pose2 value = correction.value_or(Pose2{});
  visit_memory(bytes, state.closure_memory, has_correction, value);
  visit_rest(bytes, state);
  return bytes.take();
}

/// Do all indices point at something?
bool is_sound(const BuildState& state, const Drive& drive) {
  const MapGraph& graph = state.graph;
  const auto joins_nodes = [&](const PoseEdge& edge) {
    return edge.from < graph.nodes.size() && edge.to < graph.nodes.size();
  };
  return graph.places.size() <= drive.scans.size() && graph.poses.size() == graph.nodes.size() &&
         graph.chain.size() + 1 == std::max<std::size_t>(graph.nodes.size(), 1) &&
         std::ranges::all_of(graph.chain, joins_nodes) && std::ranges::all_of(graph.closures, joins_nodes) &&
         std::ranges::all_of(state.refinement.pairs, joins_nodes) &&
         std::ranges::all_of(graph.places, [&](const ScanPlace& place) { return place.node < graph.nodes.size(); });
}

std::optional<BuildState> state_of(std::string_view body, const Drive& drive, const MapBuilderConfig& config) {
  NumberReader bytes{body};
  BuildState state;
  for (std::size_t left = bytes.count(); left > 0; --left) {
    std::size_t scan = 0;
    double way_m = 0.0;
    bytes.number(scan);
    bytes.number(way_m);
    if (scan >= drive.scans.size()) return std::nullopt;
    state.graph.nodes.push_back({scan, way_m, SurfaceIndex{surface_of(drive.scans[scan], config)}});
  }
  visit_graph(bytes, state.graph);
  bool has_correction = false;
  Pose2 correction;
  visit_memory(bytes, state.closure_memory, has_correction, correction);
  if (has_correction) state.closure_memory.unconfirmed_correction = correction;
  visit_rest(bytes, state);
  if (!bytes.is_whole() || !is_sound(state, drive)) return std::nullopt;
  return state;
}

/// Takes the next line off `text`, without its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::exchange(text, kNoLine);
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

std::string hash_of_scan(const MapScan& scan) {
  NumberWriter bytes;
  bytes.number(to_stamp_ns(scan.time));
  bytes.number(to_stamp_ns(scan.stamp));
  bytes.number(scan.odometry_index.has_value());
  bytes.number(scan.odometry_index.value_or(0));
  bytes.number(scan.motion.has_value());
  visit_pose(bytes, scan.motion ? *scan.motion : Pose2{});
  bytes.number(scan.laser_in_base.x());
  bytes.number(scan.laser_in_base.y());
  for (const Eigen::Vector2d& endpoint : scan.endpoints_in_base) {
    bytes.number(endpoint.x());
    bytes.number(endpoint.y());
  }
  return sha256_hex(bytes.take());
}

std::string hash_of_odometry(const OdometryTrack& odometry) {
  NumberWriter bytes;
  for (std::size_t i = 0; i < odometry.samples().size(); ++i) {
    const OdometrySample& sample = odometry.samples()[i];
    bytes.number(to_stamp_ns(odometry.stamps()[i]));
    bytes.number(to_stamp_ns(sample.time));
    visit_pose(bytes, sample.odom_from_base);
    bytes.number(sample.velocity.forward_mps);
    bytes.number(sample.velocity.turn_rate_radps);
    bytes.number(sample.epoch);
  }
  return sha256_hex(bytes.take());
}

}  // namespace

BuildKey key_of(const Drive& drive, const MapBuilderConfig& config, const std::string& program) {
  std::string hashes = hash_of_odometry(drive.odometry);
  for (const MapScan& scan : drive.scans) hashes += hash_of_scan(scan);
  return {program, sha256_hex(hashes), sha256_hex(write_config(config))};
}

std::string checkpoint_of(const BuildState& state, const BuildKey& key) {
  const std::string body = bytes_of(state);
  std::string text{kFormat};
  for (const std::string& line : {key.program, key.drive, key.parameters, sha256_hex(body)}) text += '\n' + line;
  return text + '\n' + body;
}

CheckpointReading read_checkpoint(std::string_view bytes, const BuildKey& key, const Drive& drive,
                                  const MapBuilderConfig& config) {
  const std::string_view format = take_line(bytes);
  const std::string_view program = take_line(bytes);
  const std::string_view recording = take_line(bytes);
  const std::string_view parameters = take_line(bytes);
  const std::string_view checksum = take_line(bytes);
  if (format != kFormat) return {std::nullopt, "is none that this version of the program can read"};
  if (checksum != sha256_hex(bytes)) return {std::nullopt, "is damaged"};
  if (recording != key.drive) return {std::nullopt, "is of another recording"};
  if (parameters != key.parameters) return {std::nullopt, "is of a build with other parameters"};
  if (program != key.program) return {std::nullopt, "is of another version of the program"};
  auto state = state_of(bytes, drive, config);
  if (!state) return {std::nullopt, "is damaged"};
  return {std::move(state), {}};
}

}  // namespace tandem
