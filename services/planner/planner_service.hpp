#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/bus/health.hpp"
#include "services/common/clock.hpp"
#include "services/common/site_config.hpp"
#include "services/mapping/core/map_zones.hpp"
#include "services/planner/core/mission/search_mission.hpp"

namespace tandem {

/// Joins a SearchMission to the bus: newest inputs in, one slice of planning, results out.
class PlannerService {
 public:
  PlannerService(const PlannerConfig& config, const SiteConfig& site, MapZones zones, bus::Bus& bus,
                 const Clock& clock);

  void step();

 private:
  template <class PubSubType>
  using Latest = bus::Latest<typename PubSubType::type, PubSubType>;
  template <class PubSubType>
  using Writer = bus::Writer<typename PubSubType::type, PubSubType>;
  template <class PubSubType>
  using Events = bus::EventReceiver<typename PubSubType::type, PubSubType>;

  void read_world();
  void read_session(Time now);
  void read_events(Time now);
  void read_edits(Time now);
  void publish_plan(Time now);
  void publish_status(Time now);
  void publish_belief(Time now);
  void publish_sources();
  void tell_person(Time now);

  PlannerConfig config_;
  SiteConfig site_;
  const Clock& clock_;
  SearchMission mission_;
  MapZones zones_;
  std::string zone_trouble_;  ///< why they do not count; empty if they do
  std::string identity_;
  bool running_ = false;

  Latest<msg::OccupancyGridPubSubType> map_;
  Latest<msg::RobotPosePubSubType> robot_pose_;
  Latest<msg::TeammateStatePubSubType> teammates_;
  Latest<msg::SessionStatePubSubType> session_;
  Latest<msg::PlanExecutionPubSubType> execution_;
  Events<msg::HumanMessagePubSubType> human_messages_;
  Events<msg::BeliefEditPubSubType> belief_edits_;
  Events<msg::SourceEditPubSubType> source_edits_;
  Events<msg::ObjectDetectionPubSubType> detections_;

  Writer<msg::TeamPlanPubSubType> team_plan_;
  Writer<msg::PlannerStatusPubSubType> status_;
  Writer<msg::SearchBeliefPubSubType> belief_;
  Writer<msg::RewardSourcePubSubType> reward_source_;
  Writer<msg::SourceRelationPubSubType> source_relation_;
  bus::EventSender<msg::Inform, msg::InformPubSubType> informs_;
  bus::HealthReporter health_;

  std::string session_code_;
  std::uint64_t sequence_number_ = 0;
  std::string published_plan_;
  PlanStanding published_standing_ = PlanStanding::None;
  Time plan_due_{};
  Time belief_due_{};
  Time status_due_{};
  std::optional<MissionActivity> published_activity_;
  double computing_s_ = 0.0;
  std::uint64_t told_number_ = 0;                          ///< of the newest message to the person
  std::string told_id_;                                    ///< of its event, while they have not taken notice of it
  std::map<std::string, RewardSource> published_sources_;  ///< by id
  std::map<std::pair<std::string, std::string>, Relation> published_relations_;  ///< by the ids they join
};

/// Listens for heartbeats of other planners of this robot and says why this one must not start; empty if it may.
[[nodiscard]] std::string other_planner(const SiteConfig& site, bus::Bus& bus, Duration listen);

}  // namespace tandem
