#include <utility>

#include "gateway/protocol/json_reader.hpp"
#include "gateway/protocol/messages.hpp"

namespace tandem::protocol {
namespace {

Json json_of(const Point& point) {
  return Json::array({point.x, point.y});
}

Json json_of(const PersonState& person) {
  Json json{{"x", person.position.x},  {"y", person.position.y},    {"heading", person.heading},
            {"source", person.source}, {"tracked", person.tracked}, {"age_s", person.age_s}};
  if (person.goal) json["goal"] = json_of(*person.goal);
  return json;
}

struct Writer {
  Json operator()(const Hello& hello) const {
    return {{"type", "hello"},      {"version", hello.version},
            {"epoch", hello.epoch}, {"role", std::string{name_of(hello.role)}},
            {"agent", hello.agent}, {"robot", hello.robot}};
  }
  Json operator()(const Session& session) const {
    const auto& rule = session.reminder;
    return {{"type", "session"},
            {"phase", session.phase},
            {"mode", session.mode},
            {"reminder",
             {{"kind", rule.kind},
              {"threshold_ms", rule.threshold_ms},
              {"factor", rule.factor},
              {"floor_ms", rule.floor_ms}}}};
  }
  Json operator()(const State& state) const {
    Json json{{"type", "state"},
              {"sequence", state.sequence},
              {"planner",
               {{"activity", state.planner.activity},
                {"computing_s", state.planner.computing_s},
                {"progress", state.planner.progress},
                {"reason", state.planner.reason}}},
              {"base",
               {{"connected", state.base.connected},
                {"moving", state.base.moving},
                {"blocked", state.base.blocked},
                {"latched", state.base.latched},
                {"stop_reasons", state.base.stop_reasons},
                {"resume_in_s", state.base.resume_in_s},
                {"battery_v", state.base.battery_v},
                {"waits_for", state.base.waits_for}}},
              {"link", {{"quality", state.link.quality}, {"round_trip_ms", state.link.round_trip_ms}}},
              {"explored", state.explored}};
    if (state.robot) {
      json["robot"] = {{"x", state.robot->position.x},
                       {"y", state.robot->position.y},
                       {"heading", state.robot->heading},
                       {"status", state.robot->status},
                       {"age_s", state.robot->age_s}};
    }
    if (state.person) json["person"] = json_of(*state.person);
    if (state.partner) json["partner"] = json_of(*state.partner);
    return json;
  }
  Json operator()(const Plan& plan) const {
    Json paths = Json::array();
    for (const auto& path : plan.paths) {
      Json points = Json::array();
      for (const auto& at : path.points) points.push_back(Json::array({at.time_s, at.point.x, at.point.y}));
      paths.push_back({{"agent", path.agent},
                       {"goal", json_of(path.goal)},
                       {"goal_fixed", path.goal_fixed},
                       {"points", std::move(points)}});
    }
    return {{"type", "plan"},           {"id", plan.id},         {"state", plan.state},
            {"role", plan.role},        {"reason", plan.reason}, {"probability_found", plan.probability_found},
            {"paths", std::move(paths)}};
  }
  Json operator()(const Sources& message) const {
    Json sources = Json::array();
    for (const auto& source : message.sources) {
      Json outline = Json::array();
      for (const auto& point : source.outline) outline.push_back(json_of(point));
      sources.push_back({{"id", source.id},
                         {"edit", source.edit},
                         {"outline", std::move(outline)},
                         {"radius_m", source.radius_m},
                         {"targets", source.targets}});
    }
    return {{"type", "sources"}, {"sources", std::move(sources)}};
  }
  Json operator()(const Map& map) const {
    Json runs = Json::array();
    for (const auto& run : map.runs) runs.push_back(Json::array({run.count, run.value}));
    return {{"type", "map"},      {"id", map.id},           {"resolution_m", map.resolution_m},
            {"width", map.width}, {"height", map.height},   {"x", map.origin.x},
            {"y", map.origin.y},  {"heading", map.heading}, {"runs", std::move(runs)}};
  }
  Json operator()(const Ack& ack) const {
    Json results = Json::array();
    for (const auto& one : ack.results) {
      results.push_back({{"sequence", one.sequence}, {"outcome", one.outcome}, {"reason", one.reason}});
    }
    return {{"type", "ack"}, {"client", ack.client}, {"up_to", ack.up_to}, {"results", std::move(results)}};
  }
  Json operator()(const Event& event) const {
    Json json{{"type", "event"}, {"kind", event.kind}, {"text", event.text}};
    if (event.point_in_map) {
      json["x"] = event.point_in_map->x;
      json["y"] = event.point_in_map->y;
    }
    if (!event.id.empty()) json["id"] = event.id;
    return json;
  }
  Json operator()(const Pong& pong) const { return {{"type", "pong"}, {"sent_at_ms", pong.sent_at_ms}}; }
};

}  // namespace

std::string_view name_of(UserRole role) {
  switch (role) {
    case UserRole::Operator:
      return "operator";
    case UserRole::Participant:
      return "participant";
    default:
      return "observer";
  }
}

std::string write(const ServerMessage& message) {
  return std::visit(Writer{}, message).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tandem::protocol
