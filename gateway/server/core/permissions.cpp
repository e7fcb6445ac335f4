#include "gateway/server/core/permissions.hpp"

#include <array>

namespace tandem::gateway {
namespace {

using protocol::CommandKind;
using protocol::UserRole;

enum class Allowed { Never, Always, BeforeTheSearch };

struct Row {
  CommandKind kind;
  Allowed observer;
  Allowed participant;
  Allowed experimenter;
};

constexpr std::array<Row, 14> kTable{{
    {CommandKind::MyPose, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::MyGoal, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::RobotGoal, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::RobotPose, Allowed::Never, Allowed::BeforeTheSearch, Allowed::Always},
    {CommandKind::Replan, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::ClearMyGoal, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::ClearRobotGoal, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::Found, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::Stop, Allowed::Always, Allowed::Always, Allowed::Always},
    {CommandKind::Resume, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::SourceEdit, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::BeliefEdit, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::Reminder, Allowed::Never, Allowed::Always, Allowed::Always},
    {CommandKind::Layer, Allowed::Never, Allowed::Always, Allowed::Always},
}};

Allowed allowed(const Row& row, UserRole role) {
  switch (role) {
    case UserRole::Operator:
      return row.experimenter;
    case UserRole::Participant:
      return row.participant;
    default:
      return row.observer;
  }
}

}  // namespace

std::optional<std::string> refusal_of(UserRole role, CommandKind kind, bool search_is_running) {
  for (const auto& row : kTable) {
    if (row.kind != kind) continue;
    switch (allowed(row, role)) {
      case Allowed::Always:
        return std::nullopt;
      case Allowed::BeforeTheSearch:
        if (!search_is_running) return std::nullopt;
        return "only before the search starts";
      default:
        return "this phone may only look, and stop the robot";
    }
  }
  return "unknown command";
}

std::optional<std::string> refusal_of(const protocol::Command& command) {
  const bool is_record = command.kind == CommandKind::Reminder || command.kind == CommandKind::Layer;
  if (command.kind == CommandKind::Stop || is_record) return std::nullopt;
  if (command.kind == CommandKind::Resume && command.held_ms < kResumeHoldMs) return "hold for one second";
  const bool is_pose = command.kind == CommandKind::MyPose || command.kind == CommandKind::RobotPose;
  const bool motion = command.kind == CommandKind::Resume;
  if (command.age_ms > (is_pose || motion ? kPoseLifeMs : kWishLifeMs)) return "too old, it waited for the connection";
  return std::nullopt;
}

}  // namespace tandem::gateway
