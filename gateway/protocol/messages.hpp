#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tandem::protocol {

/// The messages between phone and gateway (subprotocol tandem.v1, JSON text frames). The document of record is
/// tandem.schema.json beside this file; examples/ is read by the tests of both sides. SI units, map frame.
inline constexpr int kVersion = 1;

struct Point {
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]

  friend bool operator==(const Point&, const Point&) = default;
};

// Phone -> gateway
// -----------------------------------------------------------------------------------------------------

enum class CommandKind {
  MyPose,
  MyGoal,
  RobotGoal,
  RobotPose,
  Replan,
  ClearMyGoal,
  ClearRobotGoal,
  Found,
  Stop,
  Resume,
};

/// Something the person asks for. `sequence` counts the commands of `client` from 1 without gaps; the phone repeats a
/// command after every reconnection until an Ack covers it, and the gateway applies it once.
struct Command {
  std::string client;  ///< drawn by the phone once, 8 to 64 letters, digits, '-'
  std::uint64_t sequence = 0;
  CommandKind kind = CommandKind::Replan;
  std::optional<Point> point_in_map;  ///< for the kinds that name a place, and only for them
  std::optional<double> heading;      ///< [rad] of MyPose or RobotPose, where the phone knows it
  double age_ms = 0.0;                ///< since the press, when it is sent, on the phone's monotonic clock
  double held_ms = 0.0;               ///< Resume: how long the button was held

  friend bool operator==(const Command&, const Command&) = default;
};

/// The phone has drawn this state: how the gateway knows how old a phone's picture is.
struct Seen {
  std::uint64_t sequence = 0;

  friend bool operator==(const Seen&, const Seen&) = default;
};

/// A reminder fired on the phone, or was obeyed.
struct Trigger {
  std::string kind;          ///< toast, popup, multimodal, counters
  double fired_at_ms = 0.0;  ///< the phone's monotonic clock
  double threshold_ms = 0.0;
  std::optional<double> obeyed_after_ms;

  friend bool operator==(const Trigger&, const Trigger&) = default;
};

/// The person has taken notice of the Event of this id: *Got it*. What waits for it is shown again after a
/// reconnection.
struct GotIt {
  std::string id;

  friend bool operator==(const GotIt&, const GotIt&) = default;
};

struct Ping {
  double sent_at_ms = 0.0;  ///< the phone's monotonic clock; comes back in the Pong

  friend bool operator==(const Ping&, const Ping&) = default;
};

using ClientMessage = std::variant<Command, Seen, Trigger, GotIt, Ping>;

// Gateway -> phone
// -----------------------------------------------------------------------------------------------------

enum class UserRole { Observer, Participant, Operator };

/// First message on every connection.
struct Hello {
  int version = kVersion;
  std::string epoch;  ///< of the gateway: another one has forgotten the phones' commands
  UserRole role = UserRole::Observer;
  std::string agent;  ///< whose phone this is: a code, "person1"
  std::string robot;
  std::string mode = "human_robot";

  friend bool operator==(const Hello&, const Hello&) = default;
};

struct RobotState {
  Point position;
  double heading = 0.0;
  std::string status;  ///< ok, uncertain, lost
  double age_s = 0.0;

  friend bool operator==(const RobotState&, const RobotState&) = default;
};

struct PersonState {
  Point position;
  double heading = 0.0;
  std::string source;  ///< laser, message, predicted
  bool tracked = false;
  double age_s = 0.0;

  friend bool operator==(const PersonState&, const PersonState&) = default;
};

struct PlannerState {
  std::string activity = "unknown";  ///< idle, computing, failed, finished, unknown
  double computing_s = 0.0;
  double progress = 0.0;  ///< [0, 1]
  std::string reason;

  friend bool operator==(const PlannerState&, const PlannerState&) = default;
};

struct BaseState {
  bool connected = false;
  bool moving = false;
  bool blocked = false;
  bool latched = false;  ///< stopped until somebody resumes
  std::vector<std::string> stop_reasons;
  double resume_in_s = 0.0;
  double battery_v = 0.0;
  std::string waits_for;  ///< why it stands still, for people

  friend bool operator==(const BaseState&, const BaseState&) = default;
};

struct LinkState {
  std::string quality = "unknown";  ///< good, weak, one_way, lost, unknown
  double round_trip_ms = 0.0;

  friend bool operator==(const LinkState&, const LinkState&) = default;
};

/// What everybody believes now; sent when it changes, at most ten times and at least once a second.
struct State {
  std::uint64_t sequence = 0;
  std::optional<RobotState> robot;
  std::optional<PersonState> person;
  PlannerState planner;
  BaseState base;
  LinkState link;
  double explored = 0.0;  ///< [0, 1] of the searched area

  friend bool operator==(const State&, const State&) = default;
};

struct PathPoint {
  double time_s = 0.0;  ///< since the plan was made
  Point point;

  friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

struct Path {
  std::string agent;
  std::vector<PathPoint> points;
  Point goal;
  bool goal_fixed = false;  ///< a person chose it

  friend bool operator==(const Path&, const Path&) = default;
};

struct Plan {
  std::string id;              ///< empty: there is no plan
  std::string state = "none";  ///< proposed, accepted, rejected, superseded, none
  std::string role = "none";   ///< leader_follower, peer_peer, master_slave, leader_leader, none
  std::string reason;          ///< why this plan, for people
  double probability_found = 0.0;
  std::vector<Path> paths;

  friend bool operator==(const Plan&, const Plan&) = default;
};

/// The map, row by row from the lower left, as runs of equal cells.
struct Map {
  struct Run {
    std::uint32_t count = 0;
    std::uint8_t value = 0;  ///< 0 free, 100 occupied, 255 unknown

    friend bool operator==(const Run&, const Run&) = default;
  };
  std::string id;
  double resolution_m = 0.0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Point origin;          ///< corner of cell (0, 0)
  double heading = 0.0;  ///< of the rows [rad]
  std::vector<Run> runs;

  friend bool operator==(const Map&, const Map&) = default;
};

struct Result {
  std::uint64_t sequence = 0;
  std::string outcome;  ///< applied, refused
  std::string reason;   ///< of a refusal

  friend bool operator==(const Result&, const Result&) = default;
};

/// The fate of every command of `client` up to `up_to` is known; `results` tell what became of some of them.
struct Ack {
  std::string client;
  std::uint64_t up_to = 0;
  std::vector<Result> results;

  friend bool operator==(const Ack&, const Ack&) = default;
};

/// Something happened.
struct Event {
  std::string kind;  ///< found, error, inform
  std::string text;
  std::optional<Point> point_in_map;
  std::string id{};  ///< of what waits for a GotIt; empty: nothing does

  friend bool operator==(const Event&, const Event&) = default;
};

struct Pong {
  double sent_at_ms = 0.0;

  friend bool operator==(const Pong&, const Pong&) = default;
};

using ServerMessage = std::variant<Hello, State, Plan, Map, Ack, Event, Pong>;

// Text
// -----------------------------------------------------------------------------------------------------------------

/// Why a text is not a message.
struct Malformed {
  std::string reason;
};

/// Exactly one message, with no unknown, missing or repeated key, no number that is not finite, nesting of at most 8.
[[nodiscard]] std::variant<ClientMessage, Malformed> parse_client_message(std::string_view text);
[[nodiscard]] std::variant<ServerMessage, Malformed> parse_server_message(std::string_view text);

[[nodiscard]] std::string write(const ClientMessage& message);
[[nodiscard]] std::string write(const ServerMessage& message);

/// True for the kinds of command that name a place.
[[nodiscard]] bool names_a_place(CommandKind kind);
[[nodiscard]] std::string_view name_of(CommandKind kind);
[[nodiscard]] std::string_view name_of(UserRole role);

/// The token in the body of POST /api/pair, `{"token": "..."}`; none if it is anything else.
[[nodiscard]] std::optional<std::string> parse_pairing_request(std::string_view body);

}  // namespace tandem::protocol
