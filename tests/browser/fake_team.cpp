// A robot and its services as the gateway sees them, for the browser test: a room, two poses, a plan after Replan, and
// wheels that a stop request stops. Prints what it is told as JSON lines; the first line is {"domain": N}. Takes lines:
//
//   lose | track | silent | speak | session PHASE MODE REMINDER
//
// The robot loses the person or finds them again; no pose is said any more; the session is another one.
#include <poll.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "services/bus/events.hpp"
#include "services/common/stop_signal.hpp"
#include "tests/browser/fake_messages.hpp"
#include "tests/support/domain_lease.hpp"

using namespace tandem;
using test::point;

namespace {

constexpr double kSpeedMps = 0.5;

class FakeTeam {
 public:
  explicit FakeTeam(bus::Bus& bus)
      : bus_(bus),
        map_(bus.writer(topic::kMap)),
        robot_pose_(bus.writer(topic::kRobotPose)),
        teammates_(bus.writer(topic::kTeammates)),
        planner_status_(bus.writer(topic::kPlannerStatus)),
        execution_(bus.writer(topic::kPlanExecution)),
        base_status_(bus.writer(topic::kBaseStatus)),
        link_status_(bus.writer(topic::kLinkStatus)),
        team_plan_(bus.writer(topic::kTeamPlan)),
        belief_(bus.writer(topic::kBelief)),
        ground_truth_(bus.writer(topic::kGroundTruth)),
        reward_sources_(bus.writer(topic::kRewardSource)),
        sessions_(bus.writer(topic::kSession)),
        informs_(bus, topic::kInform, from_seconds(60.0)),
        to_planner_(bus, topic::kHumanMessage, "planner"),
        to_tracker_(bus, topic::kHumanMessage, "tracker"),
        stops_(bus, topic::kStopRequest, "base"),
        resumes_(bus, topic::kResumeRequest, "base"),
        hints_(bus, topic::kPoseHint, "localization"),
        detections_(bus, topic::kDetection, "planner"),
        source_edits_(bus, topic::kSourceEdit, "planner"),
        belief_edits_(bus, topic::kBeliefEdit, "planner"),
        reminders_(bus, topic::kReminder, "recorder"),
        answers_(bus, topic::kQuestionnaireAnswer, "recorder") {
    map_.write(test::fake_room());
  }

  /// Does what a line of standard input says.
  void obey(const std::string& line) {
    std::istringstream words{line};
    std::string word;
    words >> word;
    if (word == "lose") lost_ = true;
    if (word == "track") lost_ = false;
    if (word == "silent") silent_ = true;
    if (word == "speak") silent_ = false;
    if (word == "session") {
      std::string phase;
      msg::SessionState session;
      session.robot("robot1");
      session.code("fake");
      words >> phase >> session.mode() >> session.reminder();
      session.phase(phase == "running" ? msg::SESSION_RUNNING
                    : phase == "ended" ? msg::SESSION_ENDED
                                       : msg::SESSION_PREPARING);
      sessions_.write(session);
    }
  }

  void step() {
    const Time now = bus_.clock().now();
    hear(now);
    if (computing_since_ && now - *computing_since_ > from_seconds(1.5)) {
      computing_since_.reset();
      planned_at_ = now;
      plan_ = test::fake_plan(++plans_, person_.value_or(point(4, 3)), goals_, now);
      inform(now);
    }
    if (moving()) travelled_m_ += kSpeedMps * to_seconds(now - last_step_);
    last_step_ = now;
    say(now);
  }

 private:
  bool moving() const { return planned_at_.has_value() && !stopped_; }

  void hear(Time now) {
    for (const auto& message : to_tracker_.take()) to_tracker_.applied(message.id());
    for (const auto& message : to_planner_.take()) {
      const auto& at = message.point_in_map();
      std::cout << R"({"human_message":)" << message.kind() << R"(,"x":)" << at.x() << R"(,"y":)" << at.y()
                << R"(,"agent":")" << message.agent() << R"(","id":")" << message.id() << "\"}" << std::endl;
      if (message.kind() == msg::HUMAN_MY_POSE) person_ = at;
      if (message.kind() == msg::HUMAN_MY_GOAL) goals_.person = at;
      if (message.kind() == msg::HUMAN_ROBOT_GOAL) goals_.robot = at;
      if (message.kind() == msg::HUMAN_CLEAR_MY_GOAL) goals_.person.reset();
      if (message.kind() == msg::HUMAN_CLEAR_ROBOT_GOAL) goals_.robot.reset();
      if (message.kind() == msg::HUMAN_REPLAN) computing_since_ = now;
      to_planner_.applied(message.id());
    }
    for (const auto& request : stops_.take()) {
      std::cout << R"({"stop_request":")" << request.who() << "\"}" << std::endl;
      stopped_ = true;
      stops_.applied(request.id());
    }
    for (const auto& request : resumes_.take()) {
      std::cout << R"({"resume_request":)" << request.held_ms() << "}" << std::endl;
      stopped_ = false;
      resumes_.applied(request.id());
    }
    hear_edits();
    for (const auto& event : reminders_.take()) {
      std::cout << R"({"reminder":")" << event.kind() << R"(","fired":)" << event.fired() << R"(,"obeyed":)"
                << event.obeyed() << R"(,"threshold_s":)" << event.threshold_s() << R"(,"stamp_s":)" << std::fixed
                << 1e-9 * static_cast<double>(event.stamp_ns()) << std::defaultfloat << "}" << std::endl;
      reminders_.applied(event.id());
    }
    for (const auto& answer : answers_.take()) {
      std::cout << R"({"question":")" << answer.question() << R"(","answer":")" << answer.answer() << "\"}"
                << std::endl;
      answers_.applied(answer.id());
    }
    informs_.step();
    if (!told_.empty() && informs_.outcome(told_).state == bus::EventOutcome::State::Applied) {
      std::cout << R"({"got_it":true})" << std::endl;
      told_.clear();
    }
    for (const auto& hint : hints_.take()) hints_.applied(hint.id());
    for (const auto& detection : detections_.take()) {
      std::cout << R"({"detection":")" << detection.detected_by() << "\"}" << std::endl;
      detections_.applied(detection.id());
    }
  }

  void hear_edits() {
    for (const auto& edit : source_edits_.take()) {
      std::cout << R"({"source_edit":)" << edit.kind() << R"(,"corners":)" << edit.boundary_in_map().size()
                << R"(,"strength":")" << edit.strength() << R"(","targets":)" << edit.targets().size() << "}"
                << std::endl;
      msg::RewardSource gone;
      gone.id(edit.source_id());
      if (edit.kind() == msg::EDIT_REMOVE) {
        reward_sources_.dispose(gone);
      } else {
        reward_sources_.write(test::fake_source(edit));
      }
      source_edits_.applied(edit.id());
    }
    for (const auto& edit : belief_edits_.take()) {
      std::cout << R"({"belief_edit":)" << edit.kind() << R"(,"corners":)" << edit.boundary_in_map().size()
                << R"(,"strength":")" << edit.strength() << "\"}" << std::endl;
      belief_edits_.applied(edit.id());
    }
  }

  void inform(Time now) {
    msg::Inform inform;
    inform.agent("person1");
    told_ = bus::new_event_id("planner", bus_.clock());
    inform.id(told_);
    inform.stamp_ns(to_stamp_ns(now));
    inform.source_id("where it may be");
    inform.reason("The robot has searched 34 m² that you have not: look where the map is purple.");
    informs_.send(inform);
  }

  void say(Time now) {
    if (silent_) return;
    const auto stamp = to_stamp_ns(now);
    msg::Pose pose;
    pose.x(2.0 + std::max(0.0, travelled_m_ - 2.2));
    pose.y(2.0 + std::min(2.2, travelled_m_));
    pose.heading(travelled_m_ < 2.2 ? std::numbers::pi / 2 : 0.0);
    msg::RobotPose robot;
    robot.robot("robot1");
    robot.stamp_ns(stamp);
    robot.map_from_base(pose);
    robot.agreement(0.9);
    robot_pose_.write(robot);

    msg::GroundTruth truth;
    truth.stamp_ns(stamp);
    truth.left_wheel_mps(moving() ? kSpeedMps : 0.0);
    truth.right_wheel_mps(moving() ? kSpeedMps : 0.0);
    ground_truth_.write(truth);

    if (++beats_ % 5 != 0) return;
    say_how_it_goes(now, stamp);
    if (planned_at_) team_plan_.write(plan_);
    if (beats_ % 20 == 0) belief_.write(test::fake_belief(travelled_m_, stamp));
  }

  void say_how_it_goes(Time now, std::int64_t stamp) {
    if (person_) teammates_.write(test::fake_teammate(*person_, lost_, stamp));
    msg::PlannerStatus status;
    status.robot("robot1");
    status.stamp_ns(stamp);
    status.activity(computing_since_ ? msg::PLANNER_COMPUTING : msg::PLANNER_IDLE);
    status.computing_s(computing_since_ ? to_seconds(now - *computing_since_) : 0.0);
    planner_status_.write(status);
    base_status_.write(test::fake_base_status(stopped_, stamp));
    execution_.write(test::fake_execution(moving(), stamp));
    link_status_.write(test::fake_link_status());
  }

  template <class PubSubType>
  using WriterOf = bus::Writer<typename PubSubType::type, PubSubType>;
  template <class PubSubType>
  using ReceiverOf = bus::EventReceiver<typename PubSubType::type, PubSubType>;

  bus::Bus& bus_;
  WriterOf<msg::OccupancyGridPubSubType> map_;
  WriterOf<msg::RobotPosePubSubType> robot_pose_;
  WriterOf<msg::TeammateStatePubSubType> teammates_;
  WriterOf<msg::PlannerStatusPubSubType> planner_status_;
  WriterOf<msg::PlanExecutionPubSubType> execution_;
  WriterOf<msg::BaseStatusPubSubType> base_status_;
  WriterOf<msg::LinkStatusPubSubType> link_status_;
  WriterOf<msg::TeamPlanPubSubType> team_plan_;
  WriterOf<msg::SearchBeliefPubSubType> belief_;
  WriterOf<msg::GroundTruthPubSubType> ground_truth_;
  WriterOf<msg::RewardSourcePubSubType> reward_sources_;
  WriterOf<msg::SessionStatePubSubType> sessions_;
  bus::EventSender<msg::Inform, msg::InformPubSubType> informs_;
  std::string told_;  ///< what the person has not taken notice of
  ReceiverOf<msg::HumanMessagePubSubType> to_planner_;
  ReceiverOf<msg::HumanMessagePubSubType> to_tracker_;
  ReceiverOf<msg::StopRequestPubSubType> stops_;
  ReceiverOf<msg::ResumeRequestPubSubType> resumes_;
  ReceiverOf<msg::PoseHintPubSubType> hints_;
  ReceiverOf<msg::ObjectDetectionPubSubType> detections_;
  ReceiverOf<msg::SourceEditPubSubType> source_edits_;
  ReceiverOf<msg::BeliefEditPubSubType> belief_edits_;
  ReceiverOf<msg::ReminderEventPubSubType> reminders_;
  ReceiverOf<msg::QuestionnaireAnswerPubSubType> answers_;
  std::optional<msg::Point2> person_;
  test::FakeGoals goals_;
  bool lost_ = false;
  bool silent_ = false;
  msg::TeamPlan plan_;
  std::optional<Time> computing_since_;
  std::optional<Time> planned_at_;
  Time last_step_{};
  double travelled_m_ = 0.0;
  bool stopped_ = false;
  int plans_ = 0;
  int beats_ = 0;
};

/// The line that waits on standard input; none if there is none.
std::optional<std::string> waiting_line() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  std::string line;
  const bool waits = std::cin.rdbuf()->in_avail() > 0 || poll(&input, 1, 0) > 0;
  if (!waits || !std::getline(std::cin, line)) return std::nullopt;
  return line;
}

}  // namespace

int main() try {
  std::ios::sync_with_stdio(false);  // or nobody can tell whether a line waits
  const test::DomainLease domains{1};
  bus::DomainOptions options;
  options.domain = domains[0];
  options.participant = "fake-team";
  bus::Bus bus{options};
  FakeTeam team{bus};
  std::cout << R"({"domain":)" << domains[0] << "}" << std::endl;
  const StopSignal stop;
  SteadyClock clock;
  for (Metronome beat{clock, from_seconds(0.05)}; !stop.requested(); beat.wait([&] { return stop.requested(); })) {
    if (const auto line = waiting_line()) team.obey(*line);
    team.step();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "fake_team cannot run: " << error.what() << "\n";
  return EXIT_FAILURE;
}
