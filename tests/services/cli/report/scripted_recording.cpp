#include "tests/services/cli/report/scripted_recording.hpp"

#include <cmath>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/common/time.hpp"
#include "services/mapping/map_messages.hpp"
#include "services/recorder/core/schemas.hpp"

namespace tandem::test {
namespace {

constexpr double kLength_s = 120.0;
constexpr int kTellings = 3;

class Script {
 public:
  Script(mcap::Writer& writer, std::string code, double began_s)
      : channels_(writer), code_(std::move(code)), began_(from_seconds(began_s)) {}

  [[nodiscard]] std::int64_t stamp(double time_s) const { return (began_ + from_seconds(time_s)).count(); }
  [[nodiscard]] std::string next_id() { return code_ + "-" + std::to_string(++events_); }

  template <class Topic, class Message>
  void write(const Topic& topic, const std::string& type, double time_s, const Message& message) {
    const std::string schema = "tandem::msg::" + type;
    const auto channel = channels_.channel_of(std::string{topic.name}, schema, recorder::idl_of(schema));
    const auto at = static_cast<std::uint64_t>(stamp(time_s));
    channels_.write(channel, at, at, bus::encode<typename Topic::Type>(message));
  }

  void session(double time_s, msg::SessionPhase phase) {
    msg::SessionState state;
    state.robot("robot1");
    state.agent("human1");
    state.code(code_);
    state.stamp_ns(stamp(time_s));
    state.phase(phase);
    state.condition("app");
    state.reminder("toast");
    state.mode("human_robot");
    if (phase != msg::SESSION_PREPARING) state.started_ns(stamp(0.0));
    if (phase == msg::SESSION_ENDED) {
      state.ended_ns(stamp(time_s));
      state.outcome("found");
    }
    write(topic::kSession, "SessionState", time_s, state);
  }

  void press(double time_s, msg::HumanMessageKind kind) {
    msg::HumanMessage message;
    message.agent("human1");
    message.robot("robot1");
    message.id(next_id());
    message.stamp_ns(stamp(time_s));
    message.kind(kind);
    message.point_in_map().x(2.0);
    message.point_in_map().y(1.0);
    for (int i = 0; i < kTellings; ++i) write(topic::kHumanMessage, "HumanMessage", time_s + 0.1 * i, message);
  }

  void plan(double time_s, const std::string& id, msg::PlanState state, msg::CollaborationRole role) {
    msg::TeamPlan message;
    message.robot("robot1");
    message.id(id);
    message.session(code_);
    message.state(state);
    message.role(role);
    message.value(90.0);
    for (const char* agent : {"robot1", "human1"}) {
      msg::PlannedPath path;
      path.agent(agent);
      for (int i = 0; i < 3; ++i) {
        msg::TimedPoint point;
        point.stamp_ns(stamp(time_s + i));
        point.x_m(1.0 + i);
        point.y_m(1.0);
        path.points().push_back(point);
      }
      message.paths().push_back(path);
    }
    for (int i = 0; i < kTellings; ++i) {  // told again each second while it holds
      message.stamp_ns(stamp(time_s + i));
      message.lower_bound_s(i == 0 ? 0.0 : 70.0);  // it is found after the plan is out
      write(topic::kTeamPlan, "TeamPlan", time_s + i, message);
    }
  }

  void belief(double time_s) {
    msg::SearchBelief message;
    message.robot("robot1");
    message.stamp_ns(stamp(time_s));
    message.resolution_m(1.0);
    message.width(4);
    message.height(2);
    message.peak(0.25);
    message.cells(std::vector<std::uint8_t>{254, 127, 0, 255, 10, 20, 30, 40});
    message.explored(time_s / 150.0);
    for (const auto& [agent, share] : {std::pair{"robot1", time_s / 240.0}, std::pair{"human1", time_s / 400.0}}) {
      msg::ExploredShare one;
      one.agent(agent);
      one.share(share);
      message.explored_by().push_back(one);
    }
    write(topic::kBelief, "SearchBelief", time_s, message);
  }

  void base(double time_s, const std::vector<msg::StopReason>& reasons) {
    msg::BaseStatus status;
    status.robot("robot1");
    status.stamp_ns(stamp(time_s));
    status.speed_limit_mps(0.5);
    status.stop_reasons(reasons);
    write(topic::kBaseStatus, "BaseStatus", time_s, status);
  }

  void stand(double time_s) {
    msg::RobotPose pose;
    pose.robot("robot1");
    pose.stamp_ns(stamp(time_s));
    pose.map_from_base().x(1.0 + 0.01 * time_s);
    pose.map_from_base().y(1.0);
    write(topic::kRobotPose, "RobotPose", time_s, pose);
    msg::TeammateState teammate;
    teammate.agent("human1");
    teammate.robot("robot1");
    teammate.stamp_ns(stamp(time_s));
    teammate.map_from_agent().x(1.0 + 0.01 * time_s);
    teammate.map_from_agent().y(2.0);
    teammate.state(msg::TRACK_TRACKED);
    write(topic::kTeammates, "TeammateState", time_s, teammate);
    msg::TrackedPeople people;
    people.robot("robot1");
    people.stamp_ns(stamp(time_s));
    for (const double y : {2.0, 1.5 + 1.0}) {  // the teammate himself, and one who passes by 1.5 m away
      msg::TrackedPerson person;
      person.position_in_map().x(1.0 + 0.01 * time_s + (y > 2.0 ? 1.0 : 0.0));
      person.position_in_map().y(y);
      people.people().push_back(person);
    }
    write(topic::kPeople, "TrackedPeople", time_s, people);
  }

  void answer(double time_s, const std::string& question, const std::string& words) {
    msg::QuestionnaireAnswer message;
    message.agent("human1");
    message.id(next_id());
    message.stamp_ns(stamp(time_s));
    message.question(question);
    message.answer(words);
    write(topic::kQuestionnaireAnswer, "QuestionnaireAnswer", time_s, message);
  }

  void found(double time_s) {
    msg::ObjectDetection detection;
    detection.robot("robot1");
    detection.id(next_id());
    detection.stamp_ns(stamp(time_s));
    detection.detected_by("human1");
    detection.point_in_map().x(3.0);
    detection.point_in_map().y(1.5);
    for (int i = 0; i < kTellings; ++i) write(topic::kDetection, "ObjectDetection", time_s, detection);
  }

  void map() {
    OccupancyGrid grid{50, 30, 0.1};
    for (CellState& cell : grid.cells()) cell = CellState::Free;
    write(topic::kMap, "OccupancyGrid", -5.0, to_message(grid, "room"));
  }

 private:
  mcap::ChannelTable channels_;
  std::string code_;
  Duration began_;
  int events_ = 0;
};

}  // namespace

void write_scripted_search(mcap::Writer& writer, const std::string& code, double began_s) {
  Script script{writer, code, began_s};
  script.map();
  script.session(-4.0, msg::SESSION_PREPARING);
  script.press(-3.0, msg::HUMAN_MY_POSE);
  script.session(0.0, msg::SESSION_RUNNING);
  script.plan(0.0, "first", msg::PLAN_PROPOSED, msg::ROLE_LEADER_FOLLOWER);
  script.plan(4.0, "first", msg::PLAN_ACCEPTED, msg::ROLE_LEADER_FOLLOWER);
  for (const double time_s : {5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 50.0, 100.0}) {
    script.press(time_s, msg::HUMAN_MY_POSE);
  }
  script.press(49.0, msg::HUMAN_MY_GOAL);
  script.press(49.5, msg::HUMAN_REPLAN);
  script.plan(50.0, "second", msg::PLAN_PROPOSED, msg::ROLE_PEER_PEER);
  script.press(79.0, msg::HUMAN_ROBOT_GOAL);
  script.press(79.5, msg::HUMAN_REPLAN);
  script.plan(79.8, "second", msg::PLAN_REJECTED, msg::ROLE_PEER_PEER);
  script.plan(80.0, "third", msg::PLAN_PROPOSED, msg::ROLE_MASTER_SLAVE);
  for (int i = 0; i <= 12; ++i) script.belief(10.0 * i);
  for (int i = 0; i <= 240; ++i) script.stand(0.5 * i);
  script.base(0.0, {});
  script.base(20.0, {msg::STOP_OBSTACLE});
  script.base(30.0, {});
  script.base(60.0, {msg::STOP_LINK_LOST});
  script.base(65.0, {});
  script.found(119.9);
  script.session(kLength_s, msg::SESSION_ENDED);
  script.answer(130.0, "ease", "6");
  script.answer(131.0, "expert", "yes");
  script.answer(40.0, "layer belief", "shown");
}

}  // namespace tandem::test
