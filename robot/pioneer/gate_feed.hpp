#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/safety/core/safety_gate.hpp"
#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"

namespace tandem {

/// Gives the gate what the bus knows: commands, scans, people, pose, link, and what people ask for.
class GateFeed {
 public:
  /// `map_sha256` is of the map whose hard zones the gate minds; empty: it minds none, and any map will do.
  GateFeed(bus::Bus& bus, const SiteConfig& site, std::string map_sha256);

  /// Hands over everything that came; STOP first. True if somebody asked for something that should not wait.
  bool feed(safety::SafetyGate& gate, const Pose2& odom_from_base, Time now);
  /// Fills in all of `input` but the base. Its list of people is valid until the next call.
  void complete(safety::GateInput& input, Time now);
  /// Who asked for a stop or a resume since the last call, and how it was answered: for the log.
  [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  template <typename Message, typename PubSubType>
  using Latest = bus::Latest<Message, PubSubType>;
  void find_people(Time now, safety::PeopleInput& people);

  std::string robot_;
  std::string host_;
  bool may_go_on_;
  bus::InOrder<msg::VelocityCommand, msg::VelocityCommandPubSubType> commands_;
  bus::EventReceiver<msg::StopRequest, msg::StopRequestPubSubType> stops_;
  bus::EventReceiver<msg::ResumeRequest, msg::ResumeRequestPubSubType> resumes_;
  Latest<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  Latest<msg::TrackedPeople, msg::TrackedPeoplePubSubType> people_;
  Latest<msg::TeammateState, msg::TeammateStatePubSubType> teammates_;
  Latest<msg::RobotPose, msg::RobotPosePubSubType> poses_;
  Latest<msg::LinkStatus, msg::LinkStatusPubSubType> links_;
  std::string map_sha256_;
  std::optional<Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType>> maps_;
  bool other_map_ = true;
  std::optional<Time> link_heard_;
  std::optional<Pose2> map_from_base_;  ///< while fresh
  std::vector<Eigen::Vector2d> people_in_base_;
  std::vector<std::string> notes_;
};

}  // namespace tandem
