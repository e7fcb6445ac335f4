#include "services/cli/status/status_watch.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "idl/topics.hpp"
#include "services/bus/stop_reasons.hpp"
#include "services/cli/team_words.hpp"

namespace tandem::cli {
namespace {

constexpr std::array kHealth{"starting", "ok", "degraded", "failed"};
constexpr std::array kLocalization{"ok", "uncertain", "lost"};
constexpr std::array kPhases{"preparing", "running", "ended"};

/// The word for a value of an enum; a later version may have more.
template <std::size_t Count, class Enum>
std::string word_of(const std::array<const char*, Count>& words, Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < Count ? words[index] : "unknown";
}

Pose2 pose_of(const msg::Pose& pose) {
  return {pose.x(), pose.y(), pose.heading()};
}

}  // namespace

StatusWatch::StatusWatch(bus::Bus& bus, const SiteConfig& site)
    : bus_(bus),
      site_(site),
      health_(bus.latest(topic::kServiceHealth)),
      link_(bus.latest(topic::kLinkStatus)),
      base_(bus.latest(topic::kBaseStatus)),
      pose_(bus.latest(topic::kRobotPose)),
      teammates_(bus.latest(topic::kTeammates)),
      sessions_(bus.latest(topic::kSession)),
      plans_(bus.latest(topic::kTeamPlan)),
      executions_(bus.latest(topic::kPlanExecution)),
      beliefs_(bus.latest(topic::kBelief)) {}

TeamStatus StatusWatch::status() const {
  TeamStatus status{.host = site_.host, .robot = site_.robot, .agent = site_.agent};
  for (const auto& received : health_.each()) {
    const auto& health = received.message;
    const bool is_well = received.writer_alive && health.state() == msg::HEALTH_OK;
    status.services.push_back({health.host(), health.service(),
                               received.writer_alive ? word_of(kHealth, health.state()) : "gone",
                               is_well ? "" : health.reason(), health.version()});
  }
  std::ranges::sort(status.services, {}, [](const ServiceStatus& one) { return std::tie(one.host, one.service); });
  for (const auto& received : link_.each()) {
    const auto& link = received.message;
    if (link.host() != site_.host) continue;
    status.link = LinkView{link.peer(),    link.up() && received.writer_alive,
                           link.one_way(), link.round_trip_s(),
                           link.loss(),    link.clock_offset_s()};
  }
  read_robot(status);
  for (const auto& received : teammates_.each()) {
    const auto& person = received.message;
    if (person.agent() != site_.agent) continue;
    status.person = PersonStatus{pose_of(person.map_from_agent()),
                                 received.writer_alive && person.state() == msg::TRACK_TRACKED, person.age_s()};
  }
  read_session(status);
  read_plan(status);
  return status;
}

void StatusWatch::read_robot(TeamStatus& status) const {
  RobotStatus robot;
  bool is_heard = false;
  for (const auto& received : base_.each()) {
    const auto& base = received.message;
    if (base.robot() != site_.robot) continue;
    is_heard = true;
    robot.connected = base.connected() && received.writer_alive;
    for (const auto reason : base.stop_reasons()) {
      if (reason != msg::STOP_NONE) robot.stop_reasons.push_back(bus::words_of(reason));
    }
    robot.latched = base.latched();
    robot.battery_v = base.battery_v();
    robot.speed_limit_mps = base.speed_limit_mps();
  }
  for (const auto& received : pose_.each()) {
    const auto& pose = received.message;
    if (pose.robot() != site_.robot) continue;
    is_heard = true;
    robot.map_from_base = pose_of(pose.map_from_base());
    robot.localization = word_of(kLocalization, pose.status());
    robot.agreement = pose.agreement();
  }
  if (is_heard) status.robot_status = robot;
  for (const auto& received : executions_.each()) {
    const auto& execution = received.message;
    if (execution.robot() == site_.robot) {
      status.execution = execution.moving() ? "moving" : execution.blocked() ? "blocked" : execution.reason();
    }
  }
}

void StatusWatch::read_session(TeamStatus& status) const {
  for (const auto& received : sessions_.each()) {
    const auto& session = received.message;
    if (session.robot() != site_.robot) continue;
    const bool is_over = session.phase() == msg::SESSION_ENDED;
    const Time until = is_over ? from_stamp_ns(session.ended_ns()) : bus_.clock().now();
    const bool has_begun = session.started_ns() > 0;
    status.session = SessionView{
        session.code(),
        !is_over && !received.writer_alive ? "without a leader" : word_of(kPhases, session.phase()),
        session.condition(),
        has_begun ? to_seconds(until - from_stamp_ns(session.started_ns())) : 0.0,
        session.outcome(),
    };
  }
}

void StatusWatch::read_plan(TeamStatus& status) const {
  for (const auto& received : plans_.each()) {
    const auto& plan = received.message;
    if (plan.robot() != site_.robot) continue;
    status.plan = PlanView{words_of(plan.state()), words_of(plan.role()), plan.value(), plan.reason()};
  }
  for (const auto& received : beliefs_.each()) {
    if (received.message.robot() == site_.robot) status.explored = received.message.explored();
  }
}

}  // namespace tandem::cli
