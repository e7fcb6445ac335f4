#pragma once

#include <optional>
#include <string>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/navigator/core/navigator.hpp"

namespace tandem::navigator {

/// The navigator on the bus: newest inputs in, one decision, one velocity command out; twenty times a second.
///
/// Commands a velocity in every beat, 0 while it stands: so the safety gate sees a dead navigator as stale commands.
class NavigatorService {
 public:
  NavigatorService(const NavigatorConfig& config, const SiteConfig& site, const std::vector<MapArea>& zones,
                   bus::Bus& bus, Clock& clock);
  void step();

 private:
  template <class PubSub>
  using LatestOf = bus::Latest<typename PubSub::type, PubSub>;
  template <class PubSub>
  using WriterOf = bus::Writer<typename PubSub::type, PubSub>;

  [[nodiscard]] Situation situation(Time now);
  void publish(const Decision& decision, Time now);

  NavigatorConfig config_;
  std::string robot_;
  std::string host_;
  LinkLoss link_loss_;
  Zones zones_;
  bus::Bus& bus_;
  Clock& clock_;
  bus::HealthReporter health_;

  bus::InOrder<msg::TeamPlan, msg::TeamPlanPubSubType> plans_;
  LatestOf<msg::SessionStatePubSubType> sessions_;
  LatestOf<msg::RobotPosePubSubType> poses_;
  LatestOf<msg::LaserScanPubSubType> scans_;
  LatestOf<msg::OdometryPubSubType> odometry_;
  LatestOf<msg::TrackedPeoplePubSubType> people_;
  LatestOf<msg::BaseStatusPubSubType> base_status_;
  LatestOf<msg::LinkStatusPubSubType> links_;
  WriterOf<msg::VelocityCommandPubSubType> commands_;
  WriterOf<msg::PlanExecutionPubSubType> executions_;

  Navigator navigator_;
  Situation situation_;  ///< what of it stays from one beat to the next
  Time people_heard_{};
  std::optional<Time> link_heard_;  ///< the other side, last
  std::uint64_t sequence_number_ = 0;
  std::optional<Time> in_session_;  ///< when a session ran, last
  Execution published_;
  Time next_execution_{};
  int epoch_ = 0;
};

}  // namespace tandem::navigator
