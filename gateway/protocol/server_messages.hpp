#pragma once
// Gateway -> phone. Included by messages.hpp.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gateway/protocol/point.hpp"

namespace tandem::protocol {

inline constexpr int kVersion = 1;

enum class UserRole { Observer, Participant, Operator };

/// First message on every connection.
struct Hello {
  int version = kVersion;
  std::string epoch;  ///< of the gateway: another one has forgotten the phones' commands
  UserRole role = UserRole::Observer;
  std::string agent;  ///< whose phone this is: a code, "person1"
  std::string robot;

  friend bool operator==(const Hello&, const Hello&) = default;
};

/// When the page reminds the person of My pose. It keeps the time itself, also without a link.
struct ReminderRule {
  std::string kind = "none";       ///< none, toast, popup, multimodal, counters
  double threshold_ms = 10'000.0;  ///< since the last pose
  double factor = 0.75;            ///< the next threshold after one that was not obeyed ...
  double floor_ms = 3'000.0;       ///< ... but not below this; a pose restores it

  friend bool operator==(const ReminderRule&, const ReminderRule&) = default;
};

/// The search that goes on; sent on every connection and on change.
struct Session {
  std::string phase = "none";        ///< none, preparing, running, ended
  std::string mode = "human_robot";  ///< human_robot, human_human
  ReminderRule reminder;

  friend bool operator==(const Session&, const Session&) = default;
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
  std::optional<Point> goal{};  ///< of two people who search without a robot: where they said they go

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
  std::optional<PersonState> person;   ///< whose phone it is
  std::optional<PersonState> partner;  ///< the other one of two people who search without a robot
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

/// A reward source that somebody has drawn.
struct Source {
  std::string id;
  std::string edit;                  ///< avoid, pass_through, go_to, stay_behind
  std::vector<Point> outline;        ///< a polygon, or the centre of a disc; of stay_behind: nothing
  double radius_m = 0.0;             ///< of the disc
  std::vector<std::string> targets;  ///< agents whom it concerns; empty: everybody

  friend bool operator==(const Source&, const Source&) = default;
};

/// Everything drawn that holds now; sent on change.
struct Sources {
  std::vector<Source> sources;

  friend bool operator==(const Sources&, const Sources&) = default;
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

using ServerMessage = std::variant<Hello, Session, State, Plan, Sources, Map, Ack, Event, Pong>;

[[nodiscard]] std::string_view name_of(UserRole role);

}  // namespace tandem::protocol
