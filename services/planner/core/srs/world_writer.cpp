#include <cmath>
#include <nlohmann/json.hpp>

#include "services/planner/core/srs/boundary_file.hpp"
#include "services/planner/core/srs/world_file.hpp"
#include "services/planner/core/srs/world_words.hpp"

namespace tandem {
namespace {

using nlohmann::json;

json json_of_ratio(const RewardRatio& ratio) {
  json object{{"shape", word_of(kRatioShapeWords, ratio.shape)}, {"per_s", ratio.boundary_per_s}};
  if (ratio.shape != RatioShape::Constant) {
    object["far_per_s"] = ratio.far_per_s;
    object["reach_m"] = ratio.reach_m;
  }
  if (ratio.towards_rad) object["towards_rad"] = *ratio.towards_rad;
  return object;
}

json json_of_source(const RewardSource& source) {
  json object{{"id", source.id},
              {"kind", word_of(kSourceKindWords, source.kind)},
              {"boundary", json_of(source.boundary)},
              {"flow", word_of(kFlowWords, source.flow)}};
  if (!source.meaning.empty()) object["meaning"] = source.meaning;
  if (source.inside != RewardRatio{}) object["inside"] = json_of_ratio(source.inside);
  if (source.outside != RewardRatio{}) object["outside"] = json_of_ratio(source.outside);
  if (std::isfinite(source.pool)) object["pool"] = source.pool;
  if (!source.targets.empty()) object["targets"] = source.targets;
  for (const auto& temper : source.tempers) {
    object["tempers"][temper.agent] = {{"pace", temper.pace}, {"worth", temper.worth}};
  }
  return object;
}

json json_of_relation(const Relation& relation) {
  json object{{"kind", word_of(kRelationKindWords, relation.kind)}, {"from", relation.from}, {"to", relation.to}};
  if (relation.kind == RelationKind::Codependent) {
    object["coupling"] = relation.coupling;
  } else if (relation.trigger != Trigger{}) {
    object["trigger"] = {{"kind", word_of(kTriggerWords, relation.trigger.kind)}, {"value", relation.trigger.value}};
  }
  if (!relation.agents.empty()) object["agents"] = relation.agents;
  return object;
}

}  // namespace

json json_of(const RewardWorld& world) {
  json object{{"sources", json::array()}, {"relations", json::array()}};
  for (const auto& source : world.sources) {
    object["sources"].push_back(json_of_source(source));
    if (const auto* area = std::get_if<NamedArea>(&source.boundary)) {
      object["areas"][area->name] = json_of(area->outline.corners);
    }
  }
  for (const auto& relation : world.relations) object["relations"].push_back(json_of_relation(relation));
  for (const auto& group : world.groups) {
    json one{{"id", group.id}, {"members", group.members}};
    if (std::isfinite(group.pool)) one["pool"] = group.pool;
    object["groups"].push_back(one);
  }
  for (const auto& unaware : world.unawareness) {
    object["knowledge"][unaware.agent] = {{"unaware_of", unaware.sources}};
  }
  if (world.message_cost > 0.0) object["message_cost"] = world.message_cost;
  return object;
}

}  // namespace tandem
