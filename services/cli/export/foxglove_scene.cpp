#include "services/cli/export/foxglove_scene.hpp"

#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/cli/export/base64.hpp"

namespace tandem::cli {
namespace {

using Json = nlohmann::ordered_json;
using Messages = std::vector<FoxgloveMessage>;

// Numbers of Foxglove's enums.
constexpr int kUint8 = 1;
constexpr int kFloat32 = 7;
constexpr int kLineStrip = 0;
constexpr int kLineLoop = 1;

constexpr double kBodyRadius_m = 0.25;
constexpr double kPersonHeight_m = 1.7;
constexpr double kRobotHeight_m = 0.4;
constexpr double kPlanThickness_m = 0.05;
constexpr double kFontSize_m = 0.3;
constexpr double kPassingLifetime_s = 1.0;  ///< what streams is gone when it no longer does
constexpr std::uint8_t kNotSearched = 255;
constexpr double kBeliefOpacity = 0.6;

struct Colour {
  double red, green, blue, alpha;
};
constexpr Colour kRobot{0.9, 0.4, 0.1, 1.0};
constexpr Colour kPerson{0.1, 0.5, 0.9, 1.0};
constexpr Colour kPasser{0.5, 0.5, 0.5, 0.8};
constexpr Colour kTruth{0.2, 0.7, 0.2, 0.5};
constexpr Colour kObject{0.1, 0.8, 0.1, 1.0};
constexpr Colour kSource{0.8, 0.2, 0.7, 0.9};

Json time_of(std::uint64_t time_ns) {
  return {{"sec", time_ns / 1'000'000'000}, {"nsec", time_ns % 1'000'000'000}};
}
Json vector_of(double x, double y, double z) {
  return {{"x", x}, {"y", y}, {"z", z}};
}
Json rotation_of(double heading) {
  return {{"x", 0.0}, {"y", 0.0}, {"z", std::sin(heading / 2.0)}, {"w", std::cos(heading / 2.0)}};
}
Json pose_of(double x, double y, double z, double heading = 0.0) {
  return {{"position", vector_of(x, y, z)}, {"orientation", rotation_of(heading)}};
}
Json json_of(const Colour& colour) {
  return {{"r", colour.red}, {"g", colour.green}, {"b", colour.blue}, {"a", colour.alpha}};
}
Json field(const char* name, int offset, int type) {
  return {{"name", name}, {"offset", offset}, {"type", type}};
}

/// One thing in the scene, which replaces the one of the same id.
Json entity(const std::string& id, std::uint64_t time_ns, double lifetime_s = 0.0) {
  Json one{{"timestamp", time_of(time_ns)},
           {"frame_id", "map"},
           {"id", id},
           {"lifetime", time_of(static_cast<std::uint64_t>(lifetime_s * 1e9))},
           {"frame_locked", false},
           {"metadata", Json::array()}};
  for (const char* kind : {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"}) {
    one[kind] = Json::array();
  }
  return one;
}

void add_body(Json& entity, double x, double y, double height_m, const Colour& colour) {
  entity["cylinders"].push_back({{"pose", pose_of(x, y, height_m / 2.0)},
                                 {"size", vector_of(2.0 * kBodyRadius_m, 2.0 * kBodyRadius_m, height_m)},
                                 {"bottom_scale", 1.0},
                                 {"top_scale", 1.0},
                                 {"color", json_of(colour)}});
}

void add_heading(Json& entity, const msg::Pose& pose, double height_m, const Colour& colour) {
  entity["arrows"].push_back({{"pose", pose_of(pose.x(), pose.y(), height_m, pose.heading())},
                              {"shaft_length", 0.4},
                              {"shaft_diameter", 0.08},
                              {"head_length", 0.15},
                              {"head_diameter", 0.16},
                              {"color", json_of(colour)}});
}

void add_name(Json& entity, const std::string& name, double x, double y, double z) {
  entity["texts"].push_back({{"pose", pose_of(x, y, z)},
                             {"billboard", true},
                             {"font_size", kFontSize_m},
                             {"scale_invariant", false},
                             {"color", json_of({0.1, 0.1, 0.1, 1.0})},
                             {"text", name}});
}

void add_line(Json& entity, int type, const Json& points, const Colour& colour) {
  entity["lines"].push_back({{"type", type},
                             {"pose", pose_of(0.0, 0.0, 0.05)},
                             {"thickness", kPlanThickness_m},
                             {"scale_invariant", false},
                             {"points", points},
                             {"color", json_of(colour)},
                             {"colors", Json::array()},
                             {"indices", Json::array()}});
}

FoxgloveMessage scene(const std::string& topic, const Json& entities) {
  const Json update{{"deletions", Json::array()}, {"entities", entities}};
  // Names come from strangers: what is not UTF-8 is replaced.
  return {topic, "foxglove.SceneUpdate", update.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

/// A Grid of `pixels`, four bytes each.
FoxgloveMessage grid(const std::string& topic, std::uint64_t time_ns, const Json& pose, std::uint32_t width,
                     double resolution_m, const std::vector<std::uint8_t>& pixels) {
  const Json message{{"timestamp", time_of(time_ns)},
                     {"frame_id", "map"},
                     {"pose", pose},
                     {"column_count", width},
                     {"cell_size", {{"x", resolution_m}, {"y", resolution_m}}},
                     {"row_stride", 4 * width},
                     {"cell_stride", 4},
                     {"fields", Json::array({field("red", 0, kUint8), field("green", 1, kUint8),
                                             field("blue", 2, kUint8), field("alpha", 3, kUint8)})},
                     {"data", base64_of(pixels)}};
  return {topic, "foxglove.Grid", message.dump()};
}

Messages shown(const msg::OccupancyGrid& map, std::uint64_t time_ns) {
  std::vector<std::uint8_t> pixels;
  for (const std::uint8_t cell : map.cells()) {
    const bool is_known = cell <= 100;
    const auto grey = static_cast<std::uint8_t>(is_known ? 255 - cell * 255 / 100 : 200);
    const std::uint8_t alpha = is_known ? 255 : 60;
    pixels.insert(pixels.end(), {grey, grey, grey, alpha});
  }
  const msg::Pose& corner = map.map_from_grid();
  const Json pose = pose_of(corner.x(), corner.y(), -0.02, corner.heading());
  return {grid("/map", time_ns, pose, map.width(), map.resolution_m(), pixels)};
}

Messages shown(const msg::SearchBelief& belief, std::uint64_t time_ns) {
  std::vector<std::uint8_t> pixels;
  for (const std::uint8_t cell : belief.cells()) {
    const auto alpha = cell == kNotSearched ? std::uint8_t{0} : static_cast<std::uint8_t>(kBeliefOpacity * cell);
    pixels.insert(pixels.end(), {230, 60, 30, alpha});
  }
  const Json pose = pose_of(belief.origin_in_map().x(), belief.origin_in_map().y(), -0.01);
  return {grid("/belief", time_ns, pose, belief.width(), belief.resolution_m(), pixels)};
}

Messages shown(const msg::RobotPose& robot, std::uint64_t time_ns) {
  const msg::Pose& pose = robot.map_from_base();
  const Json transform{{"timestamp", time_of(time_ns)},
                       {"parent_frame_id", "map"},
                       {"child_frame_id", robot.robot()},
                       {"translation", vector_of(pose.x(), pose.y(), 0.0)},
                       {"rotation", rotation_of(pose.heading())}};
  Json body = entity("robot " + robot.robot(), time_ns);
  add_body(body, pose.x(), pose.y(), kRobotHeight_m, kRobot);
  add_heading(body, pose, kRobotHeight_m, kRobot);
  add_name(body, robot.robot(), pose.x(), pose.y(), kRobotHeight_m + 0.4);
  return {{"/tf", "foxglove.FrameTransform", transform.dump(-1, ' ', false, Json::error_handler_t::replace)},
          scene("/team", Json::array({body}))};
}

Messages shown(const msg::LaserScan& scan, std::uint64_t time_ns) {
  std::vector<std::uint8_t> data;
  double angle = scan.angle_min_rad();
  for (const float range : scan.ranges_m()) {
    const auto x = static_cast<float>(range * std::cos(angle));
    const auto y = static_cast<float>(range * std::sin(angle));
    angle += scan.angle_increment_rad();
    if (!std::isfinite(range)) continue;
    for (const float value : {x, y, 0.0F}) {
      const auto bits = std::bit_cast<std::uint32_t>(value);
      for (int shift = 0; shift < 32; shift += 8) data.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
  }
  const msg::Pose& mount = scan.base_from_laser();
  const Json message{
      {"timestamp", time_of(time_ns)},
      {"frame_id", scan.robot()},
      {"pose", pose_of(mount.x(), mount.y(), kRobotHeight_m, mount.heading())},
      {"point_stride", 12},
      {"fields", Json::array({field("x", 0, kFloat32), field("y", 4, kFloat32), field("z", 8, kFloat32)})},
      {"data", base64_of(data)}};
  return {{"/scan", "foxglove.PointCloud", message.dump(-1, ' ', false, Json::error_handler_t::replace)}};
}

Messages shown(const msg::TeammateState& mate, std::uint64_t time_ns) {
  const msg::Pose& pose = mate.map_from_agent();
  Json body = entity("teammate " + mate.agent(), time_ns);
  add_body(body, pose.x(), pose.y(), kPersonHeight_m, kPerson);
  add_heading(body, pose, kPersonHeight_m, kPerson);
  add_name(body, mate.agent(), pose.x(), pose.y(), kPersonHeight_m + 0.4);
  return {scene("/team", Json::array({body}))};
}

Messages shown(const msg::TrackedPeople& people, std::uint64_t time_ns) {
  Json bodies = Json::array();
  for (const msg::TrackedPerson& person : people.people()) {
    Json body = entity("track " + std::to_string(person.track_id()), time_ns, kPassingLifetime_s);
    add_body(body, person.position_in_map().x(), person.position_in_map().y(), kPersonHeight_m, kPasser);
    bodies.push_back(body);
  }
  return {scene("/people", bodies)};
}

Messages shown(const msg::TeamPlan& plan, std::uint64_t time_ns) {
  Json paths = Json::array();
  for (const msg::PlannedPath& path : plan.paths()) {
    Json points = Json::array();
    for (const msg::TimedPoint& point : path.points()) points.push_back(vector_of(point.x_m(), point.y_m(), 0.0));
    Json one = entity("path " + path.agent(), time_ns);
    add_line(one, kLineStrip, points, path.agent() == plan.robot() ? kRobot : kPerson);
    paths.push_back(one);
  }
  return {scene("/plan", paths)};
}

Messages shown(const msg::RewardSource& source, std::uint64_t time_ns) {
  Json one = entity("source " + source.id(), time_ns);
  const auto& boundary = source.boundary_in_map();
  if (boundary.size() == 1) {
    add_body(one, boundary[0].x(), boundary[0].y(), 0.02, kSource);
    one["cylinders"][0]["size"] = vector_of(2.0 * source.radius_m(), 2.0 * source.radius_m(), 0.02);
  } else {
    Json points = Json::array();
    for (const msg::Point2& corner : boundary) points.push_back(vector_of(corner.x(), corner.y(), 0.0));
    add_line(one, kLineLoop, points, kSource);
  }
  return {scene("/sources", Json::array({one}))};
}

Messages shown(const msg::ObjectDetection& found, std::uint64_t time_ns) {
  const msg::Point2& point = found.point_in_map();
  Json one = entity("found " + found.id(), time_ns);
  add_body(one, point.x(), point.y(), 0.3, kObject);
  add_name(one, "found by " + found.detected_by(), point.x(), point.y(), 0.6);
  return {scene("/found", Json::array({one}))};
}

Messages shown(const msg::GroundTruth& truth, std::uint64_t time_ns) {
  Json bodies = Json::array();
  const auto add = [&](const msg::TrueAgent& agent, double height_m) {
    Json body = entity("true " + agent.id(), time_ns);
    add_body(body, agent.map_from_agent().x(), agent.map_from_agent().y(), height_m, kTruth);
    bodies.push_back(body);
  };
  for (const msg::TrueAgent& robot : truth.robots()) add(robot, kRobotHeight_m);
  for (const msg::TrueAgent& person : truth.people()) add(person, kPersonHeight_m);
  for (const msg::TrueObject& object : truth.objects()) {
    Json body = entity("true " + object.id(), time_ns);
    add_body(body, object.position_in_map().x(), object.position_in_map().y(), 0.2, kTruth);
    bodies.push_back(body);
  }
  return {scene("/ground_truth", bodies)};
}

using Show = std::function<Messages(const std::vector<std::uint8_t>&, std::uint64_t)>;

template <class PubSubType>
std::pair<std::string, Show> shows(const Topic<PubSubType>& topic) {
  return {std::string{topic.name}, [](const std::vector<std::uint8_t>& payload, std::uint64_t time_ns) {
            const auto message = bus::decode<PubSubType>(payload);
            return message ? shown(*message, time_ns) : Messages{};
          }};
}

const std::map<std::string, Show>& all_shows() {
  static const std::map<std::string, Show> all{
      shows(topic::kMap),         shows(topic::kBelief),   shows(topic::kRobotPose), shows(topic::kScan),
      shows(topic::kTeammates),   shows(topic::kPeople),   shows(topic::kTeamPlan),  shows(topic::kRewardSource),
      shows(topic::kGroundTruth), shows(topic::kDetection)};
  return all;
}

}  // namespace

std::vector<FoxgloveMessage> foxglove_messages(const std::string& topic, mcap::ByteView payload,
                                               std::uint64_t log_time_ns) {
  const auto show = all_shows().find(topic);
  if (show == all_shows().end()) return {};
  return show->second({payload.begin(), payload.end()}, log_time_ns);
}

}  // namespace tandem::cli
