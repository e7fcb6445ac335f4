#pragma once

#include <planning.h>

/// What people read of a plan.
namespace tandem::cli {

[[nodiscard]] constexpr const char* words_of(msg::CollaborationRole role) {
  switch (role) {
    case msg::ROLE_LEADER_FOLLOWER:
      return "robot leads, person follows";
    case msg::ROLE_PEER_PEER:
      return "peers";
    case msg::ROLE_MASTER_SLAVE:
      return "person commands, robot obeys";
    case msg::ROLE_LEADER_LEADER:
      return "both lead";
  }
  return "";
}

[[nodiscard]] constexpr const char* words_of(msg::PlanState state) {
  switch (state) {
    case msg::PLAN_PROPOSED:
      return "proposed";
    case msg::PLAN_ACCEPTED:
      return "accepted";
    case msg::PLAN_REJECTED:
      return "rejected";
    case msg::PLAN_SUPERSEDED:
      return "superseded";
  }
  return "";
}

}  // namespace tandem::cli
