// A robot and its services as the gateway sees them, for the browser test: a room, two poses, a plan after Replan, and
// wheels that a stop request stops. Prints what it is told as JSON lines; the first line is {"domain": N}.
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <numbers>
#include <optional>
#include <string>

#include "services/bus/events.hpp"
#include "services/common/stop_signal.hpp"
#include "tests/support/domain_lease.hpp"

using namespace tandem;

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
        informs_(bus, topic::kInform, from_seconds(60.0)),
        to_planner_(bus, topic::kHumanMessage, "planner"),
        to_tracker_(bus, topic::kHumanMessage, "tracker"),
        stops_(bus, topic::kStopRequest, "base"),
        resumes_(bus, topic::kResumeRequest, "base"),
        hints_(bus, topic::kPoseHint, "localization"),
        detections_(bus, topic::kDetection, "planner") {
    send_map();
  }

  void step() {
    const Time now = bus_.clock().now();
    hear(now);
    if (computing_since_ && now - *computing_since_ > from_seconds(1.5)) {
      make_plan(now);
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
      std::cout << R"({"human_message":)" << message.kind() << R"(,"x":)" << at.x() << R"(,"y":)" << at.y() << "}"
                << std::endl;
      if (message.kind() == msg::HUMAN_MY_POSE) person_ = at;
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

  /// A room of 24 x 16 m with columns, at 0.1 m.
  void send_map() {
    msg::OccupancyGrid grid;
    grid.map_id("fake room");
    grid.resolution_m(0.1);
    grid.width(240);
    grid.height(160);
    std::vector<std::uint8_t> cells(240 * 160, 0);
    for (int row = 0; row < 160; ++row) {
      for (int column = 0; column < 240; ++column) {
        const bool wall =
            row < 3 || row >= 157 || column < 3 || column >= 237 || (row > 95 && row < 99 && column < 150);
        const bool pillar = row % 40 > 17 && row % 40 < 24 && column % 40 > 17 && column % 40 < 24 && row < 90;
        if (wall || pillar) cells[static_cast<std::size_t>(row * 240 + column)] = 100;
      }
    }
    grid.cells(cells);
    map_.write(grid);
  }

  static msg::Point2 point(double x, double y) {
    msg::Point2 at;
    at.x(x);
    at.y(y);
    return at;
  }

  void make_plan(Time now) {
    computing_since_.reset();
    planned_at_ = now;
    ++plans_;
    const auto path = [&](const char* agent, const std::vector<msg::Point2>& points) {
      msg::PlannedPath one;
      one.agent(agent);
      double time_s = 0.0;
      for (const auto& at : points) {
        msg::TimedPoint timed;
        timed.stamp_ns(to_stamp_ns(now + from_seconds(time_s)));
        timed.x_m(at.x());
        timed.y_m(at.y());
        one.points().push_back(timed);
        time_s += 10.0;
      }
      one.goal_in_map(points.back());
      return one;
    };
    plan_.robot("robot1");
    plan_.id("plan-" + std::to_string(plans_));
    plan_.planner("fake");
    plan_.stamp_ns(to_stamp_ns(now));
    plan_.valid_until_ns(to_stamp_ns(now + from_seconds(600.0)));
    plan_.state(msg::PLAN_ACCEPTED);
    plan_.role(msg::ROLE_PEER_PEER);
    plan_.probability_found(0.6);
    plan_.reason("both sides of the columns");
    plan_.paths({path("robot1", {point(2, 2), point(2, 4.2), point(13, 4.2), point(18, 7)}),
                 path("person1", {person_, point(person_.x(), 8.5), point(20, 8.5), point(20, 13)})});
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
    msg::TeammateState person;
    person.agent("person1");
    person.robot("robot1");
    person.stamp_ns(stamp);
    msg::Pose person_pose;
    person_pose.x(person_.x());
    person_pose.y(person_.y());
    person.map_from_agent(person_pose);
    person.source(msg::SOURCE_MESSAGE);
    person.state(msg::TRACK_TRACKED);
    teammates_.write(person);

    msg::PlannerStatus status;
    status.robot("robot1");
    status.stamp_ns(stamp);
    status.activity(computing_since_ ? msg::PLANNER_COMPUTING : msg::PLANNER_IDLE);
    status.computing_s(computing_since_ ? to_seconds(now - *computing_since_) : 0.0);
    planner_status_.write(status);

    msg::BaseStatus base;
    base.robot("robot1");
    base.stamp_ns(stamp);
    base.connected(true);
    base.motors_enabled(true);
    base.battery_v(12.6);
    base.latched(stopped_);
    if (stopped_) base.stop_reasons({msg::STOP_REQUESTED});
    base_status_.write(base);

    msg::PlanExecution execution;
    execution.robot("robot1");
    execution.stamp_ns(stamp);
    execution.moving(moving());
    execution_.write(execution);

    msg::LinkStatus link;
    link.host("laptop1");
    link.peer("robot1");
    link.up(true);
    link.round_trip_s(0.004);
    link_status_.write(link);

    if (planned_at_) team_plan_.write(plan_);
    if (beats_ % 20 == 0) send_belief(stamp);
  }

  void send_belief(std::int64_t stamp) {
    msg::SearchBelief belief;
    belief.robot("robot1");
    belief.stamp_ns(stamp);
    belief.resolution_m(0.5);
    belief.width(48);
    belief.height(32);
    belief.origin_in_map(point(0, 0));
    std::vector<std::uint8_t> cells;
    for (int row = 0; row < 32; ++row) {
      for (int column = 0; column < 48; ++column) {
        const double away = std::hypot(0.5 * column - 17.0, 0.5 * row - 7.0);
        const bool seen = column < 10 + static_cast<int>(travelled_m_) && row < 18;
        cells.push_back(seen ? 0 : static_cast<std::uint8_t>(254.0 * std::exp(-away / 8.0)));
      }
    }
    belief.cells(cells);
    belief.explored(std::min(1.0, 0.1 + travelled_m_ / 40.0));
    belief_.write(belief);
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
  bus::EventSender<msg::Inform, msg::InformPubSubType> informs_;
  std::string told_;  ///< what the person has not taken notice of
  ReceiverOf<msg::HumanMessagePubSubType> to_planner_;
  ReceiverOf<msg::HumanMessagePubSubType> to_tracker_;
  ReceiverOf<msg::StopRequestPubSubType> stops_;
  ReceiverOf<msg::ResumeRequestPubSubType> resumes_;
  ReceiverOf<msg::PoseHintPubSubType> hints_;
  ReceiverOf<msg::ObjectDetectionPubSubType> detections_;
  msg::Point2 person_ = point(4, 3);
  msg::TeamPlan plan_;
  std::optional<Time> computing_since_;
  std::optional<Time> planned_at_;
  Time last_step_{};
  double travelled_m_ = 0.0;
  bool stopped_ = false;
  int plans_ = 0;
  int beats_ = 0;
};

}  // namespace

int main() try {
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
    team.step();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << "fake_team cannot run: " << error.what() << "\n";
  return EXIT_FAILURE;
}
