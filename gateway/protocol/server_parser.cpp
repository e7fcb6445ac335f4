#include <utility>

#include "gateway/protocol/json_reader.hpp"
#include "gateway/protocol/messages.hpp"

namespace tandem::protocol {
namespace {

constexpr double kFar = 1e5;                            // [m]
constexpr double kTurn = 6.3;                           // [rad]
constexpr double kLong = 1e12;                          // [ms]
constexpr std::uint64_t kMany = 9'007'199'254'740'991;  // 2^53 - 1
constexpr std::uint64_t kCells = 100'000'000;

Point read_point(ObjectReader& reader) {
  return {reader.number("x", -kFar, kFar), reader.number("y", -kFar, kFar)};
}

/// `[a, b, ...]` of exactly `count` numbers.
bool are_numbers(const Json& list, std::size_t count) {
  if (!list.is_array() || list.size() != count) return false;
  for (const auto& one : list) {
    if (!one.is_number()) return false;
  }
  return true;
}

/// `[x, y]` at `key`.
Point read_pair(ObjectReader& reader, const char* key) {
  const Json& pair = reader.array(key);
  if (are_numbers(pair, 2)) return {pair[0].get<double>(), pair[1].get<double>()};
  reader.fail(std::string{key} + " is not [x, y]");
  return {};
}

Hello read_hello(ObjectReader& reader) {
  Hello hello;
  hello.version = static_cast<int>(reader.count("version", 1, 1));
  hello.epoch = reader.text("epoch", 1, 64);
  const std::string role = reader.word("role", {"observer", "participant", "operator"});
  hello.role = role == "operator"      ? UserRole::Operator
               : role == "participant" ? UserRole::Participant
                                       : UserRole::Observer;
  hello.agent = reader.text("agent", 0, 64);
  hello.robot = reader.text("robot", 0, 64);
  return hello;
}

Session read_session(ObjectReader& reader, std::string& reason) {
  Session session;
  session.phase = reader.word("phase", {"none", "preparing", "running", "ended"});
  session.mode = reader.word("mode", {"human_robot", "human_human"});
  ObjectReader rule{reader.object("reminder"), reason};
  session.reminder = {rule.word("kind", {"none", "toast", "popup", "multimodal", "counters"}),
                      rule.number("threshold_ms", 1.0, kLong), rule.number("factor", 0.0, 1.0),
                      rule.number("floor_ms", 1.0, kLong)};
  (void)rule.complete();
  return session;
}

PersonState read_person(const Json& json, std::string& reason) {
  ObjectReader person{json, reason};
  PersonState state{.position = read_point(person),
                    .heading = person.number("heading", -kTurn, kTurn),
                    .source = person.word("source", {"laser", "message", "predicted"}),
                    .tracked = person.truth("tracked"),
                    .age_s = person.number("age_s", 0.0, kLong)};
  if (person.has("goal")) state.goal = read_pair(person, "goal");
  (void)person.complete();
  return state;
}

State read_state(ObjectReader& reader, std::string& reason) {
  State state;
  state.sequence = reader.count("sequence", 0, kMany);
  if (reader.has("robot")) {
    ObjectReader robot{reader.object("robot"), reason};
    state.robot = RobotState{.position = read_point(robot),
                             .heading = robot.number("heading", -kTurn, kTurn),
                             .status = robot.word("status", {"ok", "uncertain", "lost"}),
                             .age_s = robot.number("age_s", 0.0, kLong)};
    (void)robot.complete();
  }
  if (reader.has("person")) {
    state.person = read_person(reader.object("person"), reason);
  }
  if (reader.has("partner")) state.partner = read_person(reader.object("partner"), reason);
  ObjectReader planner{reader.object("planner"), reason};
  state.planner = {planner.word("activity", {"idle", "computing", "failed", "finished", "unknown"}),
                   planner.number("computing_s", 0.0, kLong), planner.number("progress", 0.0, 1.0),
                   planner.text("reason", 0, 500)};
  (void)planner.complete();
  ObjectReader base{reader.object("base"), reason};
  state.base.connected = base.truth("connected");
  state.base.moving = base.truth("moving");
  state.base.blocked = base.truth("blocked");
  state.base.latched = base.truth("latched");
  for (const auto& why : base.array("stop_reasons")) {
    if (why.is_string()) {
      state.base.stop_reasons.push_back(why.get<std::string>());
    } else {
      base.fail("a stop reason is not a text");
    }
  }
  state.base.resume_in_s = base.number("resume_in_s", 0.0, kLong);
  state.base.battery_v = base.number("battery_v", 0.0, 1000.0);
  state.base.waits_for = base.text("waits_for", 0, 500);
  (void)base.complete();
  ObjectReader link{reader.object("link"), reason};
  state.link = {link.word("quality", {"good", "weak", "one_way", "lost", "unknown"}),
                link.number("round_trip_ms", 0.0, kLong)};
  (void)link.complete();
  state.explored = reader.number("explored", 0.0, 1.0);
  return state;
}

Plan read_plan(ObjectReader& reader, std::string& reason) {
  Plan plan;
  plan.id = reader.text("id", 0, 128);
  plan.state = reader.word("state", {"none", "proposed", "accepted", "rejected", "superseded"});
  plan.role = reader.word("role", {"none", "leader_follower", "peer_peer", "master_slave", "leader_leader"});
  plan.reason = reader.text("reason", 0, 500);
  plan.probability_found = reader.number("probability_found", 0.0, 1.0);
  for (const auto& json : reader.array("paths")) {
    ObjectReader one{json, reason};
    if (!reason.empty()) return plan;
    Path path;
    path.agent = one.text("agent", 1, 64);
    path.goal = read_pair(one, "goal");
    path.goal_fixed = one.truth("goal_fixed");
    for (const auto& point : one.array("points")) {
      if (!are_numbers(point, 3)) {
        one.fail("a point is not [t, x, y]");
        break;
      }
      path.points.push_back({point[0].get<double>(), {point[1].get<double>(), point[2].get<double>()}});
    }
    (void)one.complete();
    plan.paths.push_back(std::move(path));
  }
  return plan;
}

Sources read_sources(ObjectReader& reader, std::string& reason) {
  Sources sources;
  for (const auto& json : reader.array("sources")) {
    ObjectReader one{json, reason};
    if (!reason.empty()) return sources;
    Source source;
    source.id = one.text("id", 1, 128);
    source.edit = one.word("edit", {"avoid", "pass_through", "go_to", "stay_behind"});
    for (const auto& point : one.array("outline")) {
      if (!are_numbers(point, 2)) {
        one.fail("a point is not [x, y]");
        break;
      }
      source.outline.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    source.radius_m = one.number("radius_m", 0.0, kFar);
    for (const auto& target : one.array("targets")) {
      if (target.is_string()) {
        source.targets.push_back(target.get<std::string>());
      } else {
        one.fail("a target is not a text");
      }
    }
    (void)one.complete();
    sources.sources.push_back(std::move(source));
  }
  return sources;
}

Map read_map(ObjectReader& reader) {
  Map map;
  map.id = reader.text("id", 0, 128);
  map.resolution_m = reader.number("resolution_m", 1e-3, 10.0);
  map.width = static_cast<std::uint32_t>(reader.count("width", 1, 20'000));
  map.height = static_cast<std::uint32_t>(reader.count("height", 1, 20'000));
  map.origin = read_point(reader);
  map.heading = reader.number("heading", -kTurn, kTurn);
  std::uint64_t cells = 0;
  for (const auto& run : reader.array("runs")) {
    const bool good = are_numbers(run, 2) && run[0].is_number_unsigned() && run[1].is_number_unsigned() &&
                      run[0].get<std::uint64_t>() <= kCells && run[1].get<std::uint64_t>() <= 255;
    if (!good) {
      reader.fail("a run is not [count, value]");
      return map;
    }
    map.runs.push_back({run[0].get<std::uint32_t>(), run[1].get<std::uint8_t>()});
    cells += run[0].get<std::uint64_t>();
  }
  if (cells != std::uint64_t{map.width} * map.height) reader.fail("the runs do not fill the map");
  return map;
}

Ack read_ack(ObjectReader& reader, std::string& reason) {
  Ack ack;
  ack.client = reader.text("client", 8, 64);
  ack.up_to = reader.count("up_to", 0, kMany);
  for (const auto& json : reader.array("results")) {
    ObjectReader one{json, reason};
    if (!reason.empty()) return ack;
    ack.results.push_back(
        {one.count("sequence", 1, kMany), one.word("outcome", {"applied", "refused"}), one.text("reason", 0, 500)});
    (void)one.complete();
  }
  return ack;
}

Event read_event(ObjectReader& reader) {
  Event event;
  event.kind = reader.word("kind", {"found", "error", "inform"});
  event.text = reader.text("text", 0, 500);
  if (reader.has("x") || reader.has("y")) event.point_in_map = read_point(reader);
  if (reader.has("id")) event.id = reader.text("id", 1, 128);
  return event;
}

}  // namespace

std::variant<ServerMessage, Malformed> parse_server_message(std::string_view text) {
  std::string reason;
  const auto json = parse_json(text, reason);
  if (!json) return Malformed{reason};
  ObjectReader reader{*json, reason};
  const std::string type = reader.text("type", 1, 16);
  ServerMessage message;
  if (type == "hello") {
    message = read_hello(reader);
  } else if (type == "session") {
    message = read_session(reader, reason);
  } else if (type == "sources") {
    message = read_sources(reader, reason);
  } else if (type == "state") {
    message = read_state(reader, reason);
  } else if (type == "plan") {
    message = read_plan(reader, reason);
  } else if (type == "map") {
    message = read_map(reader);
  } else if (type == "ack") {
    message = read_ack(reader, reason);
  } else if (type == "event") {
    message = read_event(reader);
  } else if (type == "pong") {
    message = Pong{reader.number("sent_at_ms", 0.0, kLong)};
  } else {
    reader.fail("type is none of hello, session, state, plan, sources, map, ack, event, pong");
  }
  if (!reader.complete()) return Malformed{reason};
  return message;
}

}  // namespace tandem::protocol
