#pragma once

#include <map>
#include <string>

#include "services/experiment/core/episode/episode.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::cli {

/// Who takes part in the recorded episodes of a study.
struct StudyTeam {
  std::string robot = "robot1";
  std::string agent = "human1";
};

/// Records an episode in process with the topics of a live one, so that `tandem report` and Foxglove read both alike:
/// session, map, human_message, team_plan, belief, robot_pose and ground_truth at 10 Hz, detection.
class StudyRecorder final : public experiment::EpisodeObserver {
 public:
  /// `writer` must outlive it. `condition` is that of the session.
  StudyRecorder(mcap::Writer& writer, const OccupancyGrid& map, StudyTeam team, std::string condition,
                std::string session);

  void began(Time now, const std::string& session, const Eigen::Vector2d& object_in_map) override;
  void pressed(Time now, const simulator::PhoneMessage& message) override;
  void planned(Time now, const MissionPlan& plan, PlanStanding standing) override;
  void stood(Time now, const Pose2& map_from_robot, const Pose2& map_from_person,
             std::span<const Pose2> map_from_passers_by, int collisions) override;
  void believed(Time now, const SearchMission& mission) override;
  void ended(Time now, const experiment::EpisodeResult& result) override;

 private:
  template <class Topic, class Message>
  void write(const Topic& topic, const std::string& type, Time now, const Message& message);
  void write_session(Time now, bool is_over, const std::string& outcome);

  mcap::ChannelTable channels_;
  const OccupancyGrid& map_;
  StudyTeam team_;
  std::string condition_;
  std::string session_;
  Time began_{};
  Eigen::Vector2d object_in_map_ = Eigen::Vector2d::Zero();
  std::uint64_t messages_ = 0;
  std::uint64_t plans_ = 0;
};

}  // namespace tandem::cli
