#pragma once
// Phone -> gateway. Included by messages.hpp.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gateway/protocol/point.hpp"

namespace tandem::protocol {

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
  SourceEdit,
  BeliefEdit,
  Reminder,
  Layer,
};

/// What a person draws: a source of reward, or what they know of where the object is.
struct Drawing {
  std::string edit;            ///< avoid, pass_through, go_to, stay_behind, remove; likely_here, not_here, searched,
                               ///< look_again
  std::vector<Point> outline;  ///< one point: a tap; of stay_behind and remove: none
  std::string strength;        ///< a_bit, quite, very; of searched: roughly, well; of stay_behind, remove: none
  std::string target;          ///< whom avoid, pass_through, go_to concern: everybody, robot, me
  std::string source;          ///< of remove: which

  friend bool operator==(const Drawing&, const Drawing&) = default;
};

/// A reminder of My pose fired on the phone, or was obeyed.
struct Reminder {
  std::string kind;  ///< toast, popup, multimodal
  double threshold_ms = 0.0;
  std::optional<double> obeyed_after_ms;  ///< since it fired; none: it fires

  friend bool operator==(const Reminder&, const Reminder&) = default;
};

/// A layer of the map is shown or hidden from now on.
struct Layer {
  std::string name;  ///< belief, explored
  bool shown = false;

  friend bool operator==(const Layer&, const Layer&) = default;
};

/// Something the person asks for. `sequence` counts the commands of `client` from 1 without gaps; the phone repeats a
/// command after every reconnection until an Ack covers it, and the gateway applies it once.
struct Command {
  std::string client;  ///< drawn by the phone once, 8 to 64 letters, digits, '-'
  std::uint64_t sequence = 0;
  CommandKind kind = CommandKind::Replan;
  std::optional<Point> point_in_map;   ///< for the kinds that name a place, and only for them
  std::optional<double> heading;       ///< [rad] of MyPose or RobotPose, where the phone knows it
  double age_ms = 0.0;                 ///< since the press, when it is sent, on the phone's monotonic clock
  std::optional<double> sent_at_ms{};  ///< that clock then, as in a Ping: tells how long it was on its way
  double held_ms = 0.0;                ///< Resume: how long the button was held
  std::optional<Drawing> drawing{};    ///< of SourceEdit and BeliefEdit
  std::optional<Reminder> reminder{};
  std::optional<Layer> layer{};

  friend bool operator==(const Command&, const Command&) = default;
};

/// The phone has drawn this state: how the gateway knows how old a phone's picture is.
struct Seen {
  std::uint64_t sequence = 0;

  friend bool operator==(const Seen&, const Seen&) = default;
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

using ClientMessage = std::variant<Command, Seen, GotIt, Ping>;

/// True for the kinds of command that name a place.
[[nodiscard]] bool names_a_place(CommandKind kind);
[[nodiscard]] std::string_view name_of(CommandKind kind);

}  // namespace tandem::protocol
