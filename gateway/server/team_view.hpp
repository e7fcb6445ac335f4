#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gateway/protocol/messages.hpp"
#include "idl/topics.hpp"
#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/common/site_config.hpp"

namespace tandem::gateway {

/// What the bus says about the team, in the words of the phone.
class TeamView {
 public:
  TeamView(bus::Bus& bus, const SiteConfig& site);

  /// Reads what is new. To be called before the rest.
  void step();

  [[nodiscard]] protocol::State state() const;
  /// As the bus says it.
  [[nodiscard]] protocol::Session session() const;
  /// False only for a point that is certainly off the map.
  [[nodiscard]] bool is_on_map(const protocol::Point& point) const;

  /// As text frames; empty while there is nothing. `..._changed` is true until the next step.
  struct Shown {
    std::string data;
    bool changed = false;
  };
  [[nodiscard]] const Shown& map() const { return map_; }
  [[nodiscard]] const Shown& plan() const { return plan_; }
  [[nodiscard]] const Shown& sources() const { return sources_; }
  [[nodiscard]] const Shown& belief() const { return belief_; }  ///< binary
  /// What happened since the last step.
  [[nodiscard]] const std::vector<protocol::Event>& events() const { return events_; }
  /// That the object was found, for phones that come later.
  [[nodiscard]] const std::optional<protocol::Event>& found() const { return found_; }
  /// What the person is to take notice of, for phones that come later.
  [[nodiscard]] std::optional<protocol::Event> waiting_inform() const;
  /// The person has taken notice of the message of this id: only now its receipt is sent.
  void got_it(const std::string& id);

 private:
  void read_map();
  void read_plan();
  void read_sources();
  void read_belief();
  void read_events();

  bus::Bus& bus_;
  SiteConfig site_;
  bus::Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType> maps_;
  bus::Latest<msg::RobotPose, msg::RobotPosePubSubType> robot_poses_;
  bus::Latest<msg::TeammateState, msg::TeammateStatePubSubType> teammates_;
  bus::Latest<msg::PlannerStatus, msg::PlannerStatusPubSubType> planner_statuses_;
  bus::Latest<msg::PlanExecution, msg::PlanExecutionPubSubType> executions_;
  bus::Latest<msg::BaseStatus, msg::BaseStatusPubSubType> base_statuses_;
  bus::Latest<msg::LinkStatus, msg::LinkStatusPubSubType> link_statuses_;
  bus::Latest<msg::TeamPlan, msg::TeamPlanPubSubType> plans_;
  bus::Latest<msg::RewardSource, msg::RewardSourcePubSubType> reward_sources_;
  bus::Latest<msg::SearchBelief, msg::SearchBeliefPubSubType> beliefs_;
  bus::Latest<msg::SessionState, msg::SessionStatePubSubType> sessions_;
  bus::InOrder<msg::ObjectDetection, msg::ObjectDetectionPubSubType> detections_;
  bus::EventReceiver<msg::Inform, msg::InformPubSubType> informs_;

  Shown map_;
  Shown plan_;
  Shown sources_;
  Shown belief_;
  std::vector<protocol::Event> events_;
  std::optional<protocol::Event> found_;
  std::optional<protocol::Event> inform_;  ///< the newest message that waits
  Time inform_heard_{};
  std::optional<protocol::Map> map_frame_;  ///< without its cells: for is_on_map
  Time plan_heard_{};
  std::string shown_plan_id_;
  std::uint32_t belief_revision_ = 0;
  double explored_ = 0.0;
  std::vector<std::string> seen_detections_;
};

}  // namespace tandem::gateway
