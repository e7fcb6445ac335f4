#include "services/planner/core/srs/world_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

using nlohmann::json;

const std::vector<std::string> kAgents{"robot", "person"};

/// One of everything.
constexpr const char* kWorld = R"({
  "areas": {"kitchen": [[0, 0], [4, 0], [4, 3]]},
  "sources": [
    {"id": "search", "kind": "environment", "meaning": "look here", "boundary": {"shape": "area", "area": "kitchen"},
     "inside": {"strength": "very"}, "pool": 6},
    {"id": "wet_floor", "boundary": {"shape": "corridor", "points": [[0, 0], [1, 0], [1, 1]], "half_width_m": 0.5},
     "inside": {"strength": "a bit", "appeal": "avoid"},
     "outside": {"shape": "exponential", "per_s": -1, "far_per_s": 0, "reach_m": 0.5, "towards_rad": 1.5}},
    {"id": "behind", "kind": "interaction",
     "boundary": {"shape": "attached", "agent": "person",
                  "shape_in_agent": {"shape": "half_plane", "point": [-1, 0], "outward": [1, 0]}},
     "inside": {"shape": "ramp", "per_s": 1, "far_per_s": 0, "reach_m": 2}, "targets": ["robot"]},
    {"id": "talk", "kind": "interaction",
     "boundary": {"shape": "between", "from": {"agent": "person"}, "to": {"point": [5, 5]}, "half_width_m": 0.3},
     "inside": {"per_s": -2}},
    {"id": "haste", "kind": "action", "boundary": {"shape": "speed", "min_mps": 1.5}, "inside": {"per_s": -1}},
    {"id": "stroll", "kind": "action", "boundary": {"shape": "speed", "min_mps": 0, "max_mps": 1},
     "inside": {"per_s": 0.1}, "tempers": {"person": {"pace": 2, "worth": 3}}},
    {"id": "ball", "boundary": {"shape": "sphere", "centre": [1, 2, 3], "radius_m": 1}, "inside": {"per_s": 1}},
    {"id": "crate", "boundary": {"shape": "box", "low": [0, 0, 0], "high": [1, 1, 1]}, "inside": {"per_s": 1}},
    {"id": "cell", "boundary": {"shape": "disc", "centre": [1, 2], "radius_m": 3}, "flow": "proportional",
     "inside": {"per_s": 0.2}, "pool": 0.25},
    {"id": "spot", "boundary": {"shape": "polygon", "corners": [[0, 0], [1, 0], [0, 1]]},
     "inside": {"per_s": 2}, "consumption_s": 3},
    {"id": "found", "boundary": {"shape": "nowhere"}, "pool": 1}
  ],
  "relations": [
    {"kind": "strict", "from": "search", "to": "spot", "trigger": {"kind": "fraction", "value": 0.5}},
    {"kind": "soft", "from": "search", "to": "found", "agents": ["robot"]},
    {"kind": "soft", "from": "behind", "to": "stroll", "trigger": {"kind": "entry"}},
    {"kind": "codependent", "from": "search", "to": "spot", "coupling": 0.4}
  ],
  "groups": [{"id": "things", "members": ["ball", "crate"], "pool": 4}],
  "knowledge": {"person": {"unaware_of": ["spot"]}},
  "message_cost": 0.5
})";

std::string complaint_about(const std::string& text) {
  try {
    (void)parse_reward_world(text, "world.json", kAgents);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

std::string complaint_about_source(const std::string& source) {
  return complaint_about(R"({"sources": [)" + source + "]}");
}

TEST(WorldFile, ReadsOneOfEverything) {
  const RewardWorld world = parse_reward_world(kWorld, "world.json", kAgents);

  ASSERT_EQ(world.sources.size(), 11u);
  EXPECT_EQ(std::get<NamedArea>(world.sources[0].boundary).outline.corners.size(), 3u);
  EXPECT_DOUBLE_EQ(world.sources[0].inside.boundary_per_s, 3.0);
  EXPECT_DOUBLE_EQ(world.sources[1].inside.boundary_per_s, -1.0 / 3.0);
  EXPECT_DOUBLE_EQ(world.sources[9].pool, 6.0);  // 2 per s for 3 s
  EXPECT_EQ(world.relations[2].trigger.kind, Trigger::Kind::Entry);
  EXPECT_EQ(world.groups[0].members.size(), 2u);
  EXPECT_EQ(world.unawareness[0].sources, std::vector<std::string>{"spot"});
  EXPECT_DOUBLE_EQ(world.message_cost, 0.5);
}

TEST(WorldFile, WhatIsWrittenIsReadBack) {
  const RewardWorld world = parse_reward_world(kWorld, "world.json", kAgents);
  EXPECT_EQ(parse_reward_world(json_of(world).dump(), "written.json", kAgents), world);
}

TEST(WorldFile, AreasOfTheMapHaveNamesToo) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "areas.json", R"({"hall": [[0, 0], [9, 0], [9, 9]],
                        "stairs": {"corners": [[0, 0], [1, 0], [1, 1]], "rule": "keep_out"}})");
  const NamedAreas areas = load_areas_beside(folder / "map.yaml");
  EXPECT_TRUE(areas.contains("stairs"));
  const std::string text =
      R"({"sources": [{"id": "a", "boundary": {"shape": "area", "area": "hall"}, "inside": {"per_s": 1}}]})";
  EXPECT_EQ(std::get<NamedArea>(parse_reward_world(text, "world.json", kAgents, areas).sources[0].boundary).outline,
            areas.at("hall"));
  EXPECT_NE(complaint_about(text).find("no area is called \"hall\""), std::string::npos);
  EXPECT_TRUE(load_areas_beside("/nowhere/map.yaml").empty());
}

TEST(WorldFile, SaysFileAndKeyOfWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> faults{
      {R"({"sorces": []})", "world.json: sorces: unknown key"},
      {R"({"areas": {"hall": [[0, 0], [1, 1]]}})", "world.json: areas: hall: "},
      {R"({"areas": {"bow": [[0, 0], [2, 2], [2, 0], [0, 2]]}})", "world.json: areas: bow: "},
      {R"({"relations": [{"kind": "strict", "from": "a", "to": "b"}]})", "world.json: relations[0]: from: "},
      {R"({"relations": [{"from": "a", "to": "b"}]})", "world.json: relations[0]: kind: is missing"},
      {R"({"relations": [{"kind": "soft", "from": "a", "to": "b", "coupling": 1}]})",
       "world.json: relations[0]: coupling: "},
      {R"({"knowledge": {"robot": {"unaware_of": ["a"]}}})", "world.json: knowledge: robot: "},
      {R"({"knowledge": {"cat": {"unaware_of": []}}})", "world.json: knowledge: cat: "},
  };
  for (const auto& [text, start] : faults) {
    EXPECT_TRUE(complaint_about(text).starts_with(start)) << start << " / " << complaint_about(text);
  }
  const std::vector<std::pair<std::string, std::string>> source_faults{
      {R"({"boundary": {"shape": "nowhere"}})", "id: is missing"},
      {R"({"id": "a", "boundary": {"shape": "ring"}})", "boundary: shape: is \"ring\""},
      {R"({"id": "a", "boundary": {"shape": "disc", "centre": [0, 0], "radius_m": 0}})", "boundary: radius_m must be"},
      {R"({"id": "a", "boundary": {"shape": "disc", "centre": [0, 0], "radius": 1}})",
       "boundary: radius_m: is missing"},
      {R"({"id": "a", "boundary": {"shape": "nowhere"}, "inside": {"strength": "so-so"}})", "inside: strength: is "},
      {R"({"id": "a", "boundary": {"shape": "nowhere"}, "inside": {"strength": "very", "per_s": 1}})",
       "inside: per_s: "},
      {R"({"id": "a", "boundary": {"shape": "disc", "centre": [0, 0], "radius_m": 1}, "inside": {"per_s": 1},
           "pool": -1})",
       "pool: has the wrong sign"},
      {R"({"id": "a", "boundary": {"shape": "nowhere"}, "targets": ["cat"]})", "targets: no agent is called \"cat\""},
  };
  for (const auto& [source, what] : source_faults) {
    const std::string complaint = complaint_about_source(source);
    EXPECT_TRUE(complaint.starts_with("world.json: sources[0]: " + what)) << what << " / " << complaint;
  }
}

/// The keys that the reader knows of, as it lists them when it meets one it does not know.
std::set<std::string> known_keys(const std::string& complaint) {
  std::set<std::string> keys;
  std::istringstream list{complaint.substr(complaint.find("known: ") + 7)};
  for (std::string key; std::getline(list >> std::ws, key, ',');) keys.insert(key);
  return keys;
}

std::set<std::string> schema_keys(const json& schema, const std::string& name) {
  std::set<std::string> keys;
  for (const auto& [key, value] : schema.at("$defs").at(name).at("properties").items()) {
    if (key != "comment") keys.insert(key);
  }
  return keys;
}

TEST(WorldFile, TheSchemaKnowsTheSameKeys) {
  const auto file = std::filesystem::path{TANDEM_SOURCE_DIR} / "config/scenarios/reward_world.schema.json";
  const json schema = json::parse(read_file(file));

  EXPECT_EQ(known_keys(complaint_about_source(
                R"({"id": "a", "boundary": {"shape": "nowhere"}, "tempers": {}, "consumption_s": 1, "zzz": 1})")),
            schema_keys(schema, "source"));
  EXPECT_EQ(known_keys(complaint_about_source(
                R"({"id": "a", "boundary": {"shape": "nowhere"}, "inside": {"per_s": 1, "zzz": 1}})")),
            schema_keys(schema, "ratio"));
  EXPECT_EQ(known_keys(complaint_about(R"({"relations": [{"kind": "soft", "from": "a", "to": "b", "zzz": 1}]})")),
            schema_keys(schema, "relation"));
  EXPECT_EQ(known_keys(complaint_about(R"({"groups": [{"id": "a", "members": [], "zzz": 1}]})")),
            schema_keys(schema, "group"));
  std::set<std::string> root;
  for (const auto& [key, value] : schema.at("properties").items()) root.insert(key);
  root.erase("$schema");
  root.erase("comment");
  EXPECT_EQ(known_keys(complaint_about(R"({"zzz": 1})")), root);
}

TEST(WorldFile, TheSchemaKnowsTheSameShapes) {
  const auto file = std::filesystem::path{TANDEM_SOURCE_DIR} / "config/scenarios/reward_world.schema.json";
  const json schema = json::parse(read_file(file));
  std::set<std::string> shapes;
  for (const auto& option : schema.at("$defs").at("boundary").at("oneOf")) {
    const auto& properties = option.at("properties");
    shapes.insert(properties.at("shape").at("const").get<std::string>());
  }
  const std::string complaint = complaint_about_source(R"({"id": "a", "boundary": {"shape": "ring"}})");
  std::set<std::string> known;
  std::istringstream list{complaint.substr(complaint.find("allowed: ") + 9)};
  for (std::string shape; std::getline(list >> std::ws, shape, ',');) known.insert(shape);
  EXPECT_EQ(known, shapes);
}

}  // namespace
}  // namespace tandem
