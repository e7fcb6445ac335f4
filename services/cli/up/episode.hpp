#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/cli/up/episode_view.hpp"
#include "services/common/site_config.hpp"

namespace tandem::cli {

/// What an episode needs to know before it begins.
struct EpisodePlan {
  std::string session_code;
  std::string condition = "demo";
  std::string reminder = "none";
  std::string mode = "human_robot";
  double limit_s = 600.0;
  /// map_from_base, told to the localization as an operator would; none: it knows, or is told by *Robot pose*.
  std::optional<Pose2> robot_start;
  bool without_robot = false;  ///< two people: nobody's pose is waited for
  /// Whose health must be OK before the session starts: "robot1/base", or "base" of whichever host.
  std::vector<std::string> needed;
  Duration ready_within = std::chrono::seconds{60};
};

/// Leads one search from the laptop's domain: waits for the services, places the robot, opens the session, watches, and
/// closes the session when the object is found, the time is up, or somebody else has ended it.
class Episode {
 public:
  enum class Phase { Starting, Placing, Running, Found, TimeUp, Ended, Failed };

  Episode(bus::Bus& laptop, const SiteConfig& site, EpisodePlan plan, const OccupancyGrid& map);

  /// Reads what came and goes on; to be called a few times a second.
  void step();
  /// Closes the session before its end, as on Ctrl-C.
  void abort(const std::string& reason);
  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool is_over() const { return phase_ >= Phase::Found; }
  [[nodiscard]] const EpisodeView& view() const { return view_; }
  /// Why it failed, for people.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// Counts of what the person sent, by kind.
  [[nodiscard]] int messages() const { return view_.messages; }

 private:
  void observe();
  void observe_places();
  void observe_plan();
  void observe_robot();
  [[nodiscard]] std::vector<std::string> missing_services() const;
  void await_services(Time now);
  void await_pose(Time now);
  void go_on(Time now);
  [[nodiscard]] std::optional<std::string> outcome_by_another() const;
  void place_robot();
  void start_session();
  void end_session(Phase phase, const std::string& outcome);
  void publish_session();

  bus::Bus& bus_;
  SiteConfig site_;
  EpisodePlan plan_;
  Phase phase_ = Phase::Starting;
  EpisodeView view_;
  std::string reason_;
  Time began_;
  Time session_began_{};
  std::string hint_id_;
  msg::SessionState session_;
  bool was_stopped_ = false;
  std::set<std::string> message_ids_;

  bus::Writer<msg::SessionState, msg::SessionStatePubSubType> sessions_;
  bus::Latest<msg::SessionState, msg::SessionStatePubSubType> told_sessions_;  ///< ours, and what others say of it
  bus::EventSender<msg::PoseHint, msg::PoseHintPubSubType> hints_;
  bus::Latest<msg::ServiceHealth, msg::ServiceHealthPubSubType> health_;
  bus::Latest<msg::RobotPose, msg::RobotPosePubSubType> robot_pose_;
  bus::Latest<msg::TeammateState, msg::TeammateStatePubSubType> teammates_;
  bus::Latest<msg::TeamPlan, msg::TeamPlanPubSubType> team_plan_;
  bus::Latest<msg::SearchBelief, msg::SearchBeliefPubSubType> belief_;
  bus::Latest<msg::BaseStatus, msg::BaseStatusPubSubType> base_status_;
  bus::Latest<msg::PlanExecution, msg::PlanExecutionPubSubType> execution_;
  bus::Latest<msg::LinkStatus, msg::LinkStatusPubSubType> link_;
  bus::InOrder<msg::ObjectDetection, msg::ObjectDetectionPubSubType> detections_;
  bus::InOrder<msg::HumanMessage, msg::HumanMessagePubSubType> human_messages_;
};

}  // namespace tandem::cli
