#include "services/cli/study/study_recorder.hpp"

#include <utility>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/mapping/map_messages.hpp"
#include "services/planner/planner_messages.hpp"
#include "services/recorder/core/schemas.hpp"

namespace tandem::cli {
namespace {

msg::Pose pose_message(const Pose2& pose) {
  msg::Pose message;
  message.x(pose.x);
  message.y(pose.y);
  message.heading(pose.heading);
  return message;
}

msg::Point2 point_message(const Eigen::Vector2d& point) {
  msg::Point2 message;
  message.x(point.x());
  message.y(point.y());
  return message;
}

msg::TrueAgent true_agent(const std::string& id, const Pose2& map_from_agent) {
  msg::TrueAgent agent;
  agent.id(id);
  agent.map_from_agent(pose_message(map_from_agent));
  return agent;
}

msg::HumanMessageKind kind_of(simulator::PhonePress press) {
  switch (press) {
    case simulator::PhonePress::MyPose:
      return msg::HUMAN_MY_POSE;
    case simulator::PhonePress::MyGoal:
      return msg::HUMAN_MY_GOAL;
    case simulator::PhonePress::Replan:
    case simulator::PhonePress::Found:  // not recorded: a detection says it
      break;
  }
  return msg::HUMAN_REPLAN;
}

}  // namespace

StudyRecorder::StudyRecorder(mcap::Writer& writer, const OccupancyGrid& map, StudyTeam team, std::string condition,
                             std::string session)
    : channels_(writer),
      map_(map),
      team_(std::move(team)),
      condition_(std::move(condition)),
      session_(std::move(session)) {}

template <class Topic, class Message>
void StudyRecorder::write(const Topic& topic, const std::string& type, Time now, const Message& message) {
  const std::string schema = "tandem::msg::" + type;
  const auto channel = channels_.channel_of(std::string{topic.name}, schema, recorder::idl_of(schema));
  const auto stamp = static_cast<std::uint64_t>(to_stamp_ns(now));
  channels_.write(channel, stamp, stamp, bus::encode<typename Topic::Type>(message));
}

void StudyRecorder::write_session(Time now, bool is_over, const std::string& outcome) {
  msg::SessionState state;
  state.robot(team_.robot);
  state.agent(team_.agent);
  state.code(session_);
  state.stamp_ns(to_stamp_ns(now));
  state.phase(is_over ? msg::SESSION_ENDED : msg::SESSION_RUNNING);
  state.condition(condition_);
  state.reminder("none");
  state.mode("human_robot");
  state.started_ns(to_stamp_ns(began_));
  state.ended_ns(is_over ? to_stamp_ns(now) : 0);
  state.outcome(outcome);
  write(topic::kSession, "SessionState", now, state);
}

void StudyRecorder::began(Time now, const std::string& /*session*/, const Eigen::Vector2d& object_in_map) {
  began_ = now;
  object_in_map_ = object_in_map;
  write(topic::kMap, "OccupancyGrid", now, to_message(map_, "study"));
  write_session(now, false, "");
}

void StudyRecorder::pressed(Time now, const simulator::PhoneMessage& message) {
  if (message.press == simulator::PhonePress::Found) return;
  msg::HumanMessage press;
  press.agent(team_.agent);
  press.robot(team_.robot);
  press.id(session_ + "-" + std::to_string(++messages_));
  press.sequence_number(messages_);
  press.stamp_ns(to_stamp_ns(now));
  press.kind(kind_of(message.press));
  if (message.point_in_map) press.point_in_map(point_message(*message.point_in_map));
  press.heading_known(message.heading.has_value());
  press.heading(message.heading.value_or(0.0));
  write(topic::kHumanMessage, "HumanMessage", now, press);
}

void StudyRecorder::planned(Time now, const MissionPlan& plan, PlanStanding standing) {
  auto message = to_message(plan, standing, {team_.robot, session_, "study", ++plans_, now});
  for (auto& path : message.paths()) path.agent(path.agent() == "robot" ? team_.robot : team_.agent);
  write(topic::kTeamPlan, "TeamPlan", now, message);
}

void StudyRecorder::stood(Time now, const Pose2& map_from_robot, const Pose2& map_from_person,
                          std::span<const Pose2> map_from_passers_by, int collisions) {
  msg::RobotPose pose;
  pose.robot(team_.robot);
  pose.stamp_ns(to_stamp_ns(now));
  pose.map_from_base(pose_message(map_from_robot));
  pose.agreement(1.0);
  write(topic::kRobotPose, "RobotPose", now, pose);

  msg::GroundTruth truth;
  truth.stamp_ns(to_stamp_ns(now));
  truth.robots().push_back(true_agent(team_.robot, map_from_robot));
  truth.people().push_back(true_agent(team_.agent, map_from_person));
  int number = 0;
  for (const Pose2& other : map_from_passers_by) {
    truth.people().push_back(true_agent("passer_by" + std::to_string(++number), other));
  }
  msg::TrueObject object;
  object.id("token1");
  object.position_in_map(point_message(object_in_map_));
  truth.objects().push_back(object);
  truth.collisions(static_cast<std::uint32_t>(collisions));
  write(topic::kGroundTruth, "GroundTruth", now, truth);
}

void StudyRecorder::believed(Time now, const SearchMission& mission) {
  auto message = belief_message(mission, team_.robot, now);
  for (auto& share : message.explored_by()) share.agent(share.agent() == "robot" ? team_.robot : team_.agent);
  write(topic::kBelief, "SearchBelief", now, message);
}

void StudyRecorder::ended(Time now, const experiment::EpisodeResult& result) {
  if (result.found) {
    msg::ObjectDetection detection;
    detection.robot(team_.robot);
    detection.id(session_ + "-found");
    detection.stamp_ns(to_stamp_ns(now));
    detection.detected_by(result.found_by == "robot" ? team_.robot : team_.agent);
    detection.point_in_map(point_message(object_in_map_));
    detection.confidence(1.0);
    write(topic::kDetection, "ObjectDetection", now, detection);
  }
  write_session(now, true, result.found ? "found" : "time_limit");
}

}  // namespace tandem::cli
