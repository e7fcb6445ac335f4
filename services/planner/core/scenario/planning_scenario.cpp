#include "services/planner/core/scenario/planning_scenario.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "services/common/file_io.hpp"
#include "services/common/strict_json.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/planner/core/srs/world_file.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr Range kLength_m{0.0, 10000.0};
constexpr Range kSize_m{0.01, 10000.0};
constexpr Range kSpeed_mps{0.01, 20.0};
constexpr Range kTime_s{0.0, 100000.0};

std::vector<Vector2d> points(const std::vector<std::vector<double>>& rows) {
  std::vector<Vector2d> all;
  for (const auto& row : rows) all.emplace_back(row[0], row[1]);
  return all;
}

Vector2d point(const std::vector<double>& two) {
  return {two[0], two[1]};
}

DrawnRoom room_of(StrictObject object) {
  DrawnRoom room;
  room.width_m = object.number("width_m", {0.5, 2000.0});
  room.height_m = object.number("height_m", {0.5, 2000.0});
  room.resolution_m = object.number_or("resolution_m", room.resolution_m, {0.02, 1.0});
  for (auto& one : object.objects("walls")) {
    RoomWall wall;
    wall.points_in_map = points(one.rows("points", 2));
    if (wall.points_in_map.size() < 2) one.fail("points", "needs two points or more");
    wall.thickness_m = one.number_or("thickness_m", wall.thickness_m, {0.02, 100.0});
    if (one.has("height_m")) wall.height_m = one.number("height_m", kSize_m);
    one.refuse_unknown_keys();
    room.walls.push_back(std::move(wall));
  }
  for (auto& one : object.objects("boxes")) {
    RoomBox box;
    box.min_in_map = point(one.numbers("min", 2));
    box.max_in_map = point(one.numbers("max", 2));
    if ((box.max_in_map.array() <= box.min_in_map.array()).any()) one.fail("max", "must be greater than min");
    if (one.has("height_m")) box.height_m = one.number("height_m", kSize_m);
    one.refuse_unknown_keys();
    room.boxes.push_back(box);
  }
  object.refuse_unknown_keys();
  return room;
}

/// What an agent of this kind is like if the file does not say otherwise.
ScenarioAgent usual_agent(const std::string& kind) {
  ScenarioAgent agent;
  if (kind == "robot") {
    agent.searcher.speed_mps = 0.5;
    agent.searcher.radius_m = 0.45;
    agent.searcher.preferred_clearance_m = 0.8;
    agent.searcher.view_min_m = 0.6;
    agent.searcher.view_max_m = 4.0;
    agent.searcher.field_of_view_rad = from_degrees(60.0);
    agent.searcher.detection_rate_per_s = 1.0;
  } else if (kind == "person") {
    agent.kind = ScenarioAgentKind::Person;
    agent.searcher.speed_mps = 0.75;
    agent.searcher.radius_m = 0.25;
  } else {
    agent.kind = ScenarioAgentKind::Drone;
    agent.searcher.speed_mps = 2.0;
    agent.searcher.radius_m = 0.3;
    agent.searcher.view_max_m = 6.0;
    agent.searcher.detection_rate_per_s = 0.25;
    agent.altitude_m = 3.0;
    agent.searcher.endurance_s = 600.0;
  }
  return agent;
}

ScenarioAgent agent_of(StrictObject& object) {
  ScenarioAgent agent = usual_agent(object.text_or("kind", "robot", {"robot", "person", "drone"}));
  Searcher& searcher = agent.searcher;
  searcher.id = object.text("id");
  const auto start = object.numbers("start", 3);
  agent.start = {start[0], start[1], wrap_to_pi(start[2])};
  searcher.speed_mps = object.number_or("speed_mps", searcher.speed_mps, kSpeed_mps);
  searcher.turn_rate_radps = object.number_or("turn_rate_radps", searcher.turn_rate_radps, {0.01, 20.0});
  searcher.radius_m = object.number_or("radius_m", searcher.radius_m, {0.01, 10.0});
  searcher.preferred_clearance_m =
      object.number_or("preferred_clearance_m", std::max(searcher.radius_m, searcher.preferred_clearance_m), kLength_m);
  searcher.view_min_m = object.number_or("view_min_m", searcher.view_min_m, kLength_m);
  searcher.view_max_m = object.number_or("view_max_m", searcher.view_max_m, kSize_m);
  searcher.field_of_view_rad = from_degrees(
      object.number_or("field_of_view_deg", searcher.field_of_view_rad * 180.0 / std::numbers::pi, {1.0, 360.0}));
  searcher.detection_rate_per_s =
      object.number_or("detection_rate_per_s", searcher.detection_rate_per_s, {0.0, 1000.0});
  agent.altitude_m = object.number_or("altitude_m", agent.altitude_m, {0.0, 1000.0});
  if (object.has("battery_s")) searcher.endurance_s = object.number("battery_s", kTime_s);
  agent.latency_s = object.number_or("latency_s", agent.latency_s, {0.0, 600.0});
  if (object.has("goal")) agent.goal_in_map = point(object.numbers("goal", 2));
  object.refuse_unknown_keys();
  return agent;
}

ScenarioSearch search_of(StrictObject object) {
  ScenarioSearch search;
  search.objects = static_cast<int>(object.whole_number_or("objects", 1, {1, 20}));
  search.cell_size_m = object.number_or("cell_size_m", search.cell_size_m, {0.05, 10.0});
  if (object.has("prior")) {
    StrictObject prior = object.object("prior");
    search.excluded_radius_m = prior.number_or("excluded_radius_m", 0.0, kLength_m);
    if (prior.has("gaussians")) {
      for (const auto& row : prior.rows("gaussians", 4)) {
        if (row[2] <= 0.0 || row[3] < 0.0) prior.fail("gaussians", "needs sigma > 0 and weight >= 0");
        search.peaks.push_back({{row[0], row[1]}, row[2], row[3]});
      }
    }
    for (auto& one : prior.objects("areas")) {
      PriorArea area;
      area.corners_in_map = points(one.rows("corners", 2));
      if (area.corners_in_map.size() < 3) one.fail("corners", "needs three corners or more");
      area.weight = one.number("weight", {0.0, 1e6});
      one.refuse_unknown_keys();
      search.areas.push_back(std::move(area));
    }
    prior.refuse_unknown_keys();
  }
  object.refuse_unknown_keys();
  return search;
}

/// Where the maps of a scenario lie: the folder that holds scenarios/, or the file's own.
std::filesystem::path folder_of_maps(const std::filesystem::path& file) {
  for (auto folder = file.parent_path(); !folder.empty() && folder != folder.parent_path();
       folder = folder.parent_path()) {
    if (folder.filename() == "scenarios") return folder.parent_path();
  }
  return file.parent_path();
}

/// One layer for each altitude that somebody moves at, the floor first.
void add_layers(PlanningScenario& scenario) {
  std::set<double> altitudes{0.0};
  for (const auto& agent : scenario.agents) altitudes.insert(agent.altitude_m);
  scenario.altitudes_m.assign(altitudes.begin(), altitudes.end());
  for (auto& agent : scenario.agents) {
    agent.searcher.layer = static_cast<int>(std::distance(altitudes.begin(), altitudes.find(agent.altitude_m)));
  }
}

}  // namespace

PlanningScenario parse_planning_scenario(std::string_view json, const std::filesystem::path& file) {
  const nlohmann::json document = parse_json(json, file.string());
  StrictObject root{document, file.string()};
  PlanningScenario scenario;
  scenario.name = root.has("name") ? root.text("name") : file.stem().string();
  scenario.description = root.has("description") ? root.text("description") : "";
  if (root.has("room") == root.has("map")) throw ConfigError(file.string() + ": give either map or room");
  if (root.has("room")) {
    scenario.place = room_of(root.object("room"));
  } else {
    const std::filesystem::path map = root.text("map");
    scenario.place = map.is_absolute() ? map : folder_of_maps(file) / map;
  }
  std::vector<std::string> ids;
  for (auto& one : root.objects("agents")) {
    scenario.agents.push_back(agent_of(one));
    const std::string& id = scenario.agents.back().searcher.id;
    if (std::ranges::find(ids, id) != ids.end()) one.fail("id", "two agents are called " + id);
    ids.push_back(id);
  }
  if (scenario.agents.empty() || scenario.agents.size() > 8) root.fail("agents", "must be 1 to 8 agents");
  add_layers(scenario);
  const auto* map_file = std::get_if<std::filesystem::path>(&scenario.place);
  const NamedAreas map_areas = map_file != nullptr ? load_areas_beside(*map_file) : NamedAreas{};
  scenario.world = reward_world_from(root, ids, map_areas);
  if (root.has("search")) scenario.search = search_of(root.object("search"));
  scenario.horizon_s = root.number_or("horizon_s", scenario.horizon_s, {0.0, 36000.0});
  root.refuse_unknown_keys();
  return scenario;
}

PlanningScenario load_planning_scenario(const std::filesystem::path& file) {
  return parse_planning_scenario(read_file(file), file);
}

std::vector<OccupancyGrid> layers_of(const PlanningScenario& scenario) {
  std::vector<OccupancyGrid> layers;
  if (const auto* room = std::get_if<DrawnRoom>(&scenario.place)) {
    for (const double altitude_m : scenario.altitudes_m) layers.push_back(draw_layer(*room, altitude_m));
  } else {
    layers.assign(scenario.altitudes_m.size(), load_map(std::get<std::filesystem::path>(scenario.place)));
  }
  return layers;
}

}  // namespace tandem
