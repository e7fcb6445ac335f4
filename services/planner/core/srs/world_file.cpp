#include "services/planner/core/srs/world_file.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "services/mapping/core/map_areas.hpp"
#include "services/planner/core/srs/boundary_file.hpp"
#include "services/planner/core/srs/world_words.hpp"

namespace tandem {
namespace {

constexpr Range kAnyNumber{-1e12, 1e12};
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

template <typename Value, std::size_t Count>
Value chosen(StrictObject& object, std::string_view key, const Words<Value, Count>& words, Value fallback) {
  std::set<std::string> allowed;
  for (const auto& [word, value] : words) allowed.emplace(word);
  const std::string choice = object.text_or(key, word_of(words, fallback), allowed);
  for (const auto& [word, value] : words) {
    if (word == choice) return value;
  }
  return fallback;
}

RewardRatio ratio_from(StrictObject object) {
  RewardRatio ratio;
  ratio.shape = chosen(object, "shape", kRatioShapeWords, ratio.shape);
  const bool has_word = object.has("strength");
  const bool avoid = object.text_or("appeal", "seek", {"seek", "avoid"}) == "avoid";
  if (has_word == object.has("per_s")) object.fail("per_s", "give either per_s or strength");
  if (has_word) {
    std::set<std::string> words;
    for (const auto& strength : kStrengthWords) words.emplace(strength.word);
    ratio.boundary_per_s = *strength_per_s(object.text_or("strength", "", words)) * (avoid ? -1.0 : 1.0);
  } else {
    if (object.has("appeal")) object.fail("appeal", "goes with strength; per_s has a sign");
    ratio.boundary_per_s = object.number("per_s", kAnyNumber);
  }
  const bool constant = ratio.shape == RatioShape::Constant;
  for (const char* key : {"far_per_s", "reach_m"}) {
    if (object.has(key) && constant) object.fail(key, "goes with the shapes exponential and ramp");
  }
  ratio.far_per_s = object.number_or("far_per_s", ratio.far_per_s, kAnyNumber);
  ratio.reach_m = object.number_or("reach_m", ratio.reach_m, kAnyNumber);
  if (object.has("towards_rad")) ratio.towards_rad = object.number("towards_rad", kAnyNumber);
  object.refuse_unknown_keys();
  return ratio;
}

RewardSource source_from(StrictObject object, const NamedAreas& areas) {
  RewardSource source;
  source.id = object.text("id");
  source.kind = chosen(object, "kind", kSourceKindWords, source.kind);
  if (object.has("meaning")) source.meaning = object.text("meaning");
  source.boundary = boundary_from(object.object("boundary"), areas);
  if (object.has("inside")) source.inside = ratio_from(object.object("inside"));
  if (object.has("outside")) source.outside = ratio_from(object.object("outside"));
  source.flow = chosen(object, "flow", kFlowWords, source.flow);
  source.pool = object.number_or("pool", kNoLimit, kAnyNumber);
  if (object.has("consumption_s")) {
    if (object.has("pool")) object.fail("consumption_s", "give either pool or consumption_s");
    source.pool = pool_of_consumption(source.inside, object.number("consumption_s", kAnyNumber));
  }
  source.targets = object.texts("targets");
  if (object.has("tempers")) {
    StrictObject tempers = object.object("tempers");
    for (const auto& agent : tempers.names()) {
      StrictObject temper = tempers.object(agent);
      source.tempers.push_back(
          {agent, temper.number_or("pace", 1.0, kAnyNumber), temper.number_or("worth", 1.0, kAnyNumber)});
      temper.refuse_unknown_keys();
    }
  }
  object.refuse_unknown_keys();
  return source;
}

Relation relation_from(StrictObject object) {
  Relation relation;
  (void)object.text("kind");  // there is no usual one
  relation.kind = chosen(object, "kind", kRelationKindWords, relation.kind);
  relation.from = object.text("from");
  relation.to = object.text("to");
  const bool codependent = relation.kind == RelationKind::Codependent;
  if (object.has("trigger")) {
    if (codependent) object.fail("trigger", "goes with strict and soft relations");
    StrictObject trigger = object.object("trigger");
    relation.trigger.kind = chosen(trigger, "kind", kTriggerWords, relation.trigger.kind);
    relation.trigger.value = trigger.number_or("value", 1.0, kAnyNumber);
    trigger.refuse_unknown_keys();
  }
  if (object.has("coupling") && !codependent) object.fail("coupling", "goes with codependent relations");
  relation.coupling = object.number_or("coupling", 1.0, kAnyNumber);
  if (object.has("agents") && relation.kind != RelationKind::Soft) object.fail("agents", "goes with soft relations");
  relation.agents = object.texts("agents");
  object.refuse_unknown_keys();
  return relation;
}

SourceGroup group_from(StrictObject object) {
  SourceGroup group;
  group.id = object.text("id");
  group.members = object.texts("members");
  group.pool = object.number_or("pool", kNoLimit, kAnyNumber);
  object.refuse_unknown_keys();
  return group;
}

NamedAreas areas_from(StrictObject object) {
  NamedAreas areas;
  for (const auto& name : object.names()) {
    Polygon outline;
    for (const auto& corner : object.rows(name, 2)) outline.corners.emplace_back(corner[0], corner[1]);
    if (const auto problem = problem_of(PlanarShape{outline})) object.fail(name, *problem);
    areas.emplace(name, std::move(outline));
  }
  return areas;
}

}  // namespace

NamedAreas load_areas_beside(const std::filesystem::path& map_yaml) {
  NamedAreas areas;
  for (auto& area : load_map_areas(map_yaml)) {
    Polygon outline{std::move(area.corners_in_map)};
    if (const auto problem = problem_of(PlanarShape{outline})) {
      throw ConfigError((map_yaml.parent_path() / "areas.json").string() + ": " + area.name + ": " + *problem);
    }
    areas.emplace(area.name, std::move(outline));
  }
  return areas;
}

RewardWorld reward_world_from(StrictObject& object, const std::vector<std::string>& agents,
                              const NamedAreas& map_areas) {
  RewardWorld world;
  world.agents = agents;
  NamedAreas areas = object.has("areas") ? areas_from(object.object("areas")) : NamedAreas{};
  areas.insert(map_areas.begin(), map_areas.end());
  for (const auto& source : object.objects("sources")) world.sources.push_back(source_from(source, areas));
  for (const auto& relation : object.objects("relations")) world.relations.push_back(relation_from(relation));
  for (const auto& group : object.objects("groups")) world.groups.push_back(group_from(group));
  if (object.has("knowledge")) {
    StrictObject knowledge = object.object("knowledge");
    for (const auto& agent : knowledge.names()) {
      StrictObject what = knowledge.object(agent);
      world.unawareness.push_back({agent, what.texts("unaware_of")});
      what.refuse_unknown_keys();
    }
  }
  world.message_cost = object.number_or("message_cost", 0.0, kAnyNumber);
  if (const auto problem = problem_of(world)) {
    throw ConfigError(object.where() + ": " + problem->where + ": " + problem->what);
  }
  return world;
}

RewardWorld parse_reward_world(std::string_view json, const std::string& file_name,
                               const std::vector<std::string>& agents, const NamedAreas& map_areas) {
  const nlohmann::json document = parse_json(json, file_name);
  StrictObject root{document, file_name};
  RewardWorld world = reward_world_from(root, agents, map_areas);
  root.refuse_unknown_keys();
  return world;
}

}  // namespace tandem
