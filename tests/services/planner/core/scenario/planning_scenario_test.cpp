#include "services/planner/core/scenario/planning_scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "services/common/config.hpp"

namespace tandem {
namespace {

const std::filesystem::path kScenarios = std::filesystem::path{TANDEM_SOURCE_DIR} / "config" / "scenarios";

constexpr const char* kOffice = R"({
  "$schema": "planning.schema.json",
  "name": "office",
  "room": {"width_m": 8, "height_m": 6, "walls": [{"points": [[4, 0], [4, 4]], "height_m": 2}]},
  "agents": [
    {"id": "robot", "start": [1, 1, 0]},
    {"id": "person", "kind": "person", "start": [1, 3, 1.5], "latency_s": 5, "goal": [7, 5]},
    {"id": "drone", "kind": "drone", "start": [2, 2, 0], "altitude_m": 2.5, "battery_s": 90}
  ],
  "areas": {"desk": [[6, 4], [8, 4], [8, 6], [6, 6]]},
  "sources": [
    {"id": "paper", "boundary": {"shape": "area", "area": "desk"}, "inside": {"strength": "quite"}, "pool": 3,
     "targets": ["robot"]},
    {"id": "bin", "boundary": {"shape": "disc", "centre": [1, 5], "radius_m": 0.5}, "inside": {"per_s": 2}, "pool": 4}
  ],
  "relations": [{"kind": "strict", "from": "paper", "to": "bin"}],
  "knowledge": {"person": {"unaware_of": ["paper"]}},
  "message_cost": 0.5,
  "search": {"objects": 2, "prior": {"excluded_radius_m": 3, "gaussians": [[6, 4, 1, 2]]}},
  "horizon_s": 40
})";

PlanningScenario office() {
  return parse_planning_scenario(kOffice, "/etc/tandem/scenarios/tasks/office.json");
}

std::string message_of(const std::string& json) {
  try {
    (void)parse_planning_scenario(json, "office.json");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// kOffice with one text exchanged for another.
std::string office_with(const std::string& from, const std::string& to) {
  std::string json = kOffice;
  const auto at = json.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return json.replace(at, from.size(), to);
}

TEST(PlanningScenario, SaysWhereWhoAndWhat) {
  const PlanningScenario scenario = office();
  EXPECT_EQ(scenario.name, "office");
  EXPECT_EQ(std::get<DrawnRoom>(scenario.place).walls.size(), 1U);
  ASSERT_EQ(scenario.agents.size(), 3U);
  EXPECT_EQ(scenario.agents[0].kind, ScenarioAgentKind::Robot);
  EXPECT_EQ(scenario.agents[1].latency_s, 5.0);
  EXPECT_EQ(scenario.agents[1].goal_in_map->x(), 7.0);
  EXPECT_EQ(scenario.agents[2].searcher.endurance_s, 90.0);
  EXPECT_EQ(scenario.world.agents, (std::vector<std::string>{"robot", "person", "drone"}));
  EXPECT_EQ(scenario.world.sources.size(), 2U);
  EXPECT_EQ(scenario.world.relations.size(), 1U);
  EXPECT_EQ(scenario.world.unawareness.size(), 1U);
  EXPECT_EQ(scenario.world.message_cost, 0.5);
  EXPECT_EQ(scenario.search->objects, 2);
  EXPECT_EQ(scenario.search->peaks.size(), 1U);
  EXPECT_EQ(scenario.horizon_s, 40.0);
}

TEST(PlanningScenario, AnAgentIsAsUsualForItsKindWhereNothingElseIsSaid) {
  const PlanningScenario scenario = office();
  EXPECT_EQ(scenario.agents[0].searcher.speed_mps, 0.5);
  EXPECT_EQ(scenario.agents[1].searcher.speed_mps, 0.75);
  EXPECT_EQ(scenario.agents[2].searcher.speed_mps, 2.0);
}

TEST(PlanningScenario, WhoFliesHasALayerOfItsOwn) {
  const PlanningScenario scenario = office();
  EXPECT_EQ(scenario.altitudes_m, (std::vector<double>{0.0, 2.5}));
  EXPECT_EQ(scenario.agents[0].searcher.layer, 0);
  EXPECT_EQ(scenario.agents[2].searcher.layer, 1);
  const auto layers = layers_of(scenario);
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_TRUE(layers[0].at(Eigen::Vector2d{4.0, 1.0}) == CellState::Occupied);
  EXPECT_TRUE(layers[1].at(Eigen::Vector2d{4.0, 1.0}) == CellState::Free);
}

TEST(PlanningScenario, AMapLiesInTheFolderThatHoldsScenarios) {
  std::string json =
      office_with(R"("room": {"width_m": 8, "height_m": 6, "walls": [{"points": [[4, 0], [4, 4]], "height_m": 2}]})",
                  R"("map": "maps/brl.yaml")");
  const auto scenario = parse_planning_scenario(json, "/etc/tandem/scenarios/tasks/office.json");
  EXPECT_EQ(std::get<std::filesystem::path>(scenario.place), "/etc/tandem/maps/brl.yaml");
}

TEST(PlanningScenario, ErrorsNameFileAndKey) {
  EXPECT_NE(message_of(office_with("\"horizon_s\"", "\"horizont_s\"")).find("office.json: horizont_s"),
            std::string::npos);
  EXPECT_NE(message_of(office_with("\"latency_s\": 5", "\"latency_s\": -5")).find("agents[1]: latency_s"),
            std::string::npos);
  EXPECT_NE(message_of(office_with("\"id\": \"drone\"", "\"id\": \"robot\"")).find("two agents are called robot"),
            std::string::npos);
  EXPECT_NE(message_of(office_with("[[4, 0], [4, 4]]", "[[4, 0]]")).find("walls[0]: points"), std::string::npos);
  EXPECT_NE(message_of(office_with("\"targets\": [\"robot\"]", "\"targets\": [\"cat\"]")).find("cat"),
            std::string::npos);
  EXPECT_NE(message_of(office_with("\"name\": \"office\",", "\"map\": \"a.yaml\",")).find("either map or room"),
            std::string::npos);
}

TEST(PlanningScenario, EveryShippedTaskIsOne) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenarios / "tasks")) {
    ++count;
    const PlanningScenario scenario = load_planning_scenario(entry.path());
    EXPECT_EQ(scenario.name, entry.path().stem()) << entry.path();
    EXPECT_FALSE(scenario.description.empty()) << entry.path();
  }
  EXPECT_GE(count, 15);
}

/// All keys below "properties" anywhere in a schema.
void collect_properties(const nlohmann::json& schema, std::set<std::string>& keys) {
  if (schema.is_array()) {
    for (const auto& one : schema) collect_properties(one, keys);
  }
  if (!schema.is_object()) return;
  for (const auto& [key, value] : schema.items()) {
    if (key == "properties") {
      for (const auto& [name, property] : value.items()) keys.insert(name);
    }
    collect_properties(value, keys);
  }
}

TEST(PlanningScenario, TheSchemaKnowsEveryKeyOfTheExample) {
  std::ifstream file{kScenarios / "planning.schema.json"};
  std::set<std::string> known;
  collect_properties(nlohmann::json::parse(file), known);
  const auto example = nlohmann::json::parse(kOffice);
  for (const auto& [key, value] : example.items()) EXPECT_TRUE(known.contains(key)) << key;
  for (const char* part : {"room", "search"}) {
    for (const auto& [key, value] : example[part].items()) EXPECT_TRUE(known.contains(key)) << key;
  }
  for (const auto& agent : example["agents"]) {
    for (const auto& [key, value] : agent.items()) EXPECT_TRUE(known.contains(key)) << key;
  }
}

}  // namespace
}  // namespace tandem
