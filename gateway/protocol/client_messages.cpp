#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <utility>

#include "gateway/protocol/json_reader.hpp"
#include "gateway/protocol/messages.hpp"

namespace tandem::protocol {
namespace {

constexpr double kFar = 1e5;                            // [m] no map is larger
constexpr double kLong = 1e12;                          // [ms]
constexpr std::uint64_t kMany = 9'007'199'254'740'991;  // 2^53 - 1: what a phone can count to

constexpr std::array<std::pair<CommandKind, std::string_view>, 10> kKinds{{
    {CommandKind::MyPose, "my_pose"},
    {CommandKind::MyGoal, "my_goal"},
    {CommandKind::RobotGoal, "robot_goal"},
    {CommandKind::RobotPose, "robot_pose"},
    {CommandKind::Replan, "replan"},
    {CommandKind::ClearMyGoal, "clear_my_goal"},
    {CommandKind::ClearRobotGoal, "clear_robot_goal"},
    {CommandKind::Found, "found"},
    {CommandKind::Stop, "stop"},
    {CommandKind::Resume, "resume"},
}};

bool is_client_id(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
  });
}

Command read_command(ObjectReader& reader) {
  Command command;
  command.client = reader.text("client", 8, 64);
  if (!is_client_id(command.client)) reader.fail("client has a strange character");
  command.sequence = reader.count("sequence", 1, kMany);
  const std::string kind = reader.text("kind", 1, 32);
  const auto* known = std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& one) { return one.second == kind; });
  if (known == kKinds.end()) {
    reader.fail("kind is none of the known words");
    return command;
  }
  command.kind = known->first;
  if (names_a_place(command.kind)) {
    command.point_in_map = Point{reader.number("x", -kFar, kFar), reader.number("y", -kFar, kFar)};
  }
  const bool has_heading = command.kind == CommandKind::MyPose || command.kind == CommandKind::RobotPose;
  if (has_heading && reader.has("heading")) {
    command.heading = reader.number("heading", -2 * std::numbers::pi, 2 * std::numbers::pi);
  }
  command.age_ms = reader.number("age_ms", 0.0, kLong);
  if (command.kind == CommandKind::Resume) command.held_ms = reader.number("held_ms", 0.0, 60'000.0);
  return command;
}

Trigger read_trigger(ObjectReader& reader) {
  Trigger trigger;
  trigger.kind = reader.word("kind", {"toast", "popup", "multimodal", "counters"});
  trigger.fired_at_ms = reader.number("fired_at_ms", 0.0, kLong);
  trigger.threshold_ms = reader.number("threshold_ms", 0.0, kLong);
  if (reader.has("obeyed_after_ms")) trigger.obeyed_after_ms = reader.number("obeyed_after_ms", 0.0, kLong);
  return trigger;
}

struct Writer {
  Json operator()(const Command& command) const {
    Json json{{"type", "cmd"},
              {"client", command.client},
              {"sequence", command.sequence},
              {"kind", std::string{name_of(command.kind)}},
              {"age_ms", command.age_ms}};
    if (command.point_in_map) {
      json["x"] = command.point_in_map->x;
      json["y"] = command.point_in_map->y;
    }
    if (command.heading) json["heading"] = *command.heading;
    if (command.kind == CommandKind::Resume) json["held_ms"] = command.held_ms;
    return json;
  }
  Json operator()(const Seen& seen) const { return {{"type", "seen"}, {"sequence", seen.sequence}}; }
  Json operator()(const Trigger& trigger) const {
    Json json{{"type", "trig"},
              {"kind", trigger.kind},
              {"fired_at_ms", trigger.fired_at_ms},
              {"threshold_ms", trigger.threshold_ms}};
    if (trigger.obeyed_after_ms) json["obeyed_after_ms"] = *trigger.obeyed_after_ms;
    return json;
  }
  Json operator()(const GotIt& got_it) const { return {{"type", "got_it"}, {"id", got_it.id}}; }
  Json operator()(const Ping& ping) const { return {{"type", "ping"}, {"sent_at_ms", ping.sent_at_ms}}; }
};

}  // namespace

bool names_a_place(CommandKind kind) {
  switch (kind) {
    case CommandKind::MyPose:
    case CommandKind::MyGoal:
    case CommandKind::RobotGoal:
    case CommandKind::RobotPose:
    case CommandKind::Found:
      return true;
    default:
      return false;
  }
}

std::string_view name_of(CommandKind kind) {
  return kKinds[static_cast<std::size_t>(kind)].second;
}

std::variant<ClientMessage, Malformed> parse_client_message(std::string_view text) {
  std::string reason;
  const auto json = parse_json(text, reason);
  if (!json) return Malformed{reason};
  ObjectReader reader{*json, reason};
  const std::string type = reader.text("type", 1, 16);
  ClientMessage message;
  if (type == "cmd") {
    message = read_command(reader);
  } else if (type == "seen") {
    message = Seen{reader.count("sequence", 0, kMany)};
  } else if (type == "trig") {
    message = read_trigger(reader);
  } else if (type == "got_it") {
    message = GotIt{reader.text("id", 1, 128)};
  } else if (type == "ping") {
    message = Ping{reader.number("sent_at_ms", 0.0, kLong)};
  } else {
    reader.fail("type is none of cmd, seen, trig, got_it, ping");
  }
  if (!reader.complete()) return Malformed{reason};
  return message;
}

std::string write(const ClientMessage& message) {
  return std::visit(Writer{}, message).dump();
}

std::optional<std::string> parse_pairing_request(std::string_view body) {
  std::string reason;
  const auto json = parse_json(body, reason);
  if (!json) return std::nullopt;
  ObjectReader reader{*json, reason};
  std::string token = reader.text("token", 1, 64);
  if (!reader.complete()) return std::nullopt;
  return token;
}

}  // namespace tandem::protocol
