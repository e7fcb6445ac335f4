#include <algorithm>
#include <array>
#include <cmath>
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
constexpr std::size_t kCorners = 200;                   // of a drawn outline

constexpr std::array<std::pair<CommandKind, std::string_view>, 14> kKinds{{
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
    {CommandKind::SourceEdit, "source_edit"},
    {CommandKind::BeliefEdit, "belief_edit"},
    {CommandKind::Reminder, "reminder"},
    {CommandKind::Layer, "layer"},
}};

bool is_client_id(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
  });
}

std::vector<Point> read_outline(ObjectReader& reader) {
  std::vector<Point> outline;
  const Json& points = reader.array("outline");
  if (points.empty() || points.size() > kCorners) reader.fail("outline has no point, or too many");
  for (const auto& point : points) {
    const bool good = point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
    const Point at = good ? Point{point[0].get<double>(), point[1].get<double>()} : Point{};
    if (!good || std::abs(at.x) > kFar || std::abs(at.y) > kFar) {
      reader.fail("a point of outline is not [x, y]");
      return {};
    }
    outline.push_back(at);
  }
  return outline;
}

Drawing read_source_edit(ObjectReader& reader) {
  Drawing drawing;
  drawing.edit = reader.word("edit", {"avoid", "pass_through", "go_to", "stay_behind", "remove"});
  if (drawing.edit == "remove") {
    drawing.source = reader.text("source", 1, 128);
  } else if (drawing.edit == "avoid") {
    drawing.outline = read_outline(reader);
    drawing.strength = reader.word("strength", {"a_bit", "quite", "very"});
    drawing.target = reader.word("target", {"everybody", "robot", "me"});
  } else if (drawing.edit != "stay_behind") {
    drawing.outline = read_outline(reader);
    drawing.strength = reader.word("strength", {"a_bit", "quite", "very"});
    drawing.target = reader.word("target", {"robot", "me"});  // the planner sends one there, not both
  }
  return drawing;
}

Drawing read_belief_edit(ObjectReader& reader) {
  Drawing drawing;
  drawing.edit = reader.word("edit", {"likely_here", "not_here", "searched", "look_again"});
  drawing.outline = read_outline(reader);
  drawing.strength = drawing.edit == "searched" ? reader.word("strength", {"roughly", "well"})
                                                : reader.word("strength", {"a_bit", "quite", "very"});
  return drawing;
}

Reminder read_reminder(ObjectReader& reader) {
  Reminder reminder;
  reminder.kind = reader.word("reminder", {"toast", "popup", "multimodal"});
  reminder.threshold_ms = reader.number("threshold_ms", 0.0, kLong);
  if (reader.has("obeyed_after_ms")) reminder.obeyed_after_ms = reader.number("obeyed_after_ms", 0.0, kLong);
  return reminder;
}

/// What commands of some kinds carry besides place and age.
void read_rest(ObjectReader& reader, Command& command) {
  switch (command.kind) {
    case CommandKind::MyPose:
    case CommandKind::RobotPose:
      if (reader.has("heading")) {
        command.heading = reader.number("heading", -2 * std::numbers::pi, 2 * std::numbers::pi);
      }
      break;
    case CommandKind::Resume:
      command.held_ms = reader.number("held_ms", 0.0, 60'000.0);
      break;
    case CommandKind::SourceEdit:
      command.drawing = read_source_edit(reader);
      break;
    case CommandKind::BeliefEdit:
      command.drawing = read_belief_edit(reader);
      break;
    case CommandKind::Reminder:
      command.reminder = read_reminder(reader);
      break;
    case CommandKind::Layer:
      command.layer = Layer{reader.word("layer", {"belief", "explored"}), reader.truth("shown")};
      break;
    default:
      break;
  }
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
  command.age_ms = reader.number("age_ms", 0.0, kLong);
  if (reader.has("sent_at_ms")) command.sent_at_ms = reader.number("sent_at_ms", 0.0, kLong);
  read_rest(reader, command);
  return command;
}

void write_drawing(const Drawing& drawing, Json& json) {
  json["edit"] = drawing.edit;
  if (!drawing.outline.empty()) {
    Json points = Json::array();
    for (const Point& point : drawing.outline) points.push_back(Json::array({point.x, point.y}));
    json["outline"] = std::move(points);
  }
  if (!drawing.strength.empty()) json["strength"] = drawing.strength;
  if (!drawing.target.empty()) json["target"] = drawing.target;
  if (!drawing.source.empty()) json["source"] = drawing.source;
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
    if (command.sent_at_ms) json["sent_at_ms"] = *command.sent_at_ms;
    if (command.heading) json["heading"] = *command.heading;
    if (command.kind == CommandKind::Resume) json["held_ms"] = command.held_ms;
    if (command.drawing) write_drawing(*command.drawing, json);
    if (command.reminder) {
      json["reminder"] = command.reminder->kind;
      json["threshold_ms"] = command.reminder->threshold_ms;
      if (command.reminder->obeyed_after_ms) json["obeyed_after_ms"] = *command.reminder->obeyed_after_ms;
    }
    if (command.layer) {
      json["layer"] = command.layer->name;
      json["shown"] = command.layer->shown;
    }
    return json;
  }
  Json operator()(const Seen& seen) const { return {{"type", "seen"}, {"sequence", seen.sequence}}; }
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
  } else if (type == "got_it") {
    message = GotIt{reader.text("id", 1, 128)};
  } else if (type == "ping") {
    message = Ping{reader.number("sent_at_ms", 0.0, kLong)};
  } else {
    reader.fail("type is none of cmd, seen, got_it, ping");
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
