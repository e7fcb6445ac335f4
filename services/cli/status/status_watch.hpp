#pragma once

#include "services/bus/bus.hpp"
#include "services/cli/status/team_status.hpp"
#include "services/common/site_config.hpp"

namespace tandem::cli {

/// Listens to the team of `site` in a host's domain.
class StatusWatch {
 public:
  StatusWatch(bus::Bus& bus, const SiteConfig& site);
  [[nodiscard]] TeamStatus status() const;

 private:
  void read_robot(TeamStatus& status) const;
  void read_session(TeamStatus& status) const;
  void read_plan(TeamStatus& status) const;

  bus::Bus& bus_;
  SiteConfig site_;
  bus::Latest<msg::ServiceHealth, msg::ServiceHealthPubSubType> health_;
  bus::Latest<msg::LinkStatus, msg::LinkStatusPubSubType> link_;
  bus::Latest<msg::BaseStatus, msg::BaseStatusPubSubType> base_;
  bus::Latest<msg::RobotPose, msg::RobotPosePubSubType> pose_;
  bus::Latest<msg::TeammateState, msg::TeammateStatePubSubType> teammates_;
  bus::Latest<msg::SessionState, msg::SessionStatePubSubType> sessions_;
  bus::Latest<msg::TeamPlan, msg::TeamPlanPubSubType> plans_;
  bus::Latest<msg::PlanExecution, msg::PlanExecutionPubSubType> executions_;
  bus::Latest<msg::SearchBelief, msg::SearchBeliefPubSubType> beliefs_;
};

}  // namespace tandem::cli
