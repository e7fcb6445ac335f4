#pragma once

#include <map>
#include <optional>
#include <string>

#include "gateway/protocol/messages.hpp"
#include "services/common/time.hpp"

namespace tandem::gateway {

/// Two people who search without a robot: each sees where the other one said they are, and go.
class TwoPeople {
 public:
  /// Takes what the person of `agent` pressed at `pressed`: a pose, a goal, or that there is none any more.
  void note(const std::string& agent, const protocol::Command& command, Time pressed);
  /// None before their first pose.
  [[nodiscard]] std::optional<protocol::PersonState> state_of(const std::string& agent, Time now) const;

 private:
  struct Person {
    std::optional<protocol::Point> pose;
    double heading = 0.0;
    Time posed{};
    std::optional<protocol::Point> goal;
  };
  std::map<std::string, Person> people_;
};

/// Whether `kind` means anything without a robot.
[[nodiscard]] bool is_between_people(protocol::CommandKind kind);

/// `state` as the other one of the two sees it.
[[nodiscard]] protocol::State mirrored(protocol::State state);

}  // namespace tandem::gateway
