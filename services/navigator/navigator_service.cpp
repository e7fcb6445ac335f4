#include "services/navigator/navigator_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "services/navigator/navigator_messages.hpp"

namespace tandem::navigator {
namespace {

/// The newest message about `robot`, if there is one that the mailbox has not given before.
template <class Box>
auto new_of(Box& box, const std::string& robot) {
  auto received = box.take_new();
  if (received && received->message.robot() != robot) received.reset();
  return received;
}

LinkLoss link_loss_of(const std::string& word) {
  if (word == "finish_leg") return LinkLoss::FinishLeg;
  return word == "retreat" ? LinkLoss::Retreat : LinkLoss::Stop;
}

}  // namespace

NavigatorService::NavigatorService(const NavigatorConfig& config, const SiteConfig& site,
                                   const std::vector<MapArea>& zones, bus::Bus& bus, Clock& clock)
    : config_(config),
      robot_(site.robot),
      host_(site.host),
      link_loss_(link_loss_of(site.on_link_loss)),
      zones_(zones),
      bus_(bus),
      clock_(clock),
      health_(bus, site, "navigator"),
      plans_(bus.in_order(topic::kTeamPlan, 100)),
      sessions_(bus.latest(topic::kSession)),
      poses_(bus.latest(topic::kRobotPose)),
      scans_(bus.latest(topic::kScan)),
      odometry_(bus.latest(topic::kOdometry)),
      people_(bus.latest(topic::kPeople)),
      base_status_(bus.latest(topic::kBaseStatus)),
      links_(bus.latest(topic::kLinkStatus)),
      commands_(bus.writer(topic::kVelocityCommand)),
      executions_(bus.writer(topic::kPlanExecution)),
      navigator_(config, link_loss_, zones_),
      epoch_(clock.epoch()) {}

Situation NavigatorService::situation(Time now) {
  constexpr double kPeopleTimeout = 1.0;  // [s]
  Situation& known = situation_;
  known.now = now;
  // Receive times are the machine's, decisions are in mission time: what counts is the age.
  const Time machine_now = bus_.clock().now();
  const auto heard = [&](Time received) { return now - (machine_now - received); };
  for (const auto& session : sessions_.each()) {
    if (session.message.robot() == robot_) known.running_session = running_session(session.message);
  }
  if (const auto pose = new_of(poses_, robot_)) {
    LocatedPose located = located_pose(pose->message);
    // A pose whose stamp stands still is as old as when it was first heard.
    const bool repeated = known.pose && known.pose->stamp == located.stamp;
    located.received = repeated ? known.pose->received : heard(pose->received);
    known.pose = located;
  }
  if (const auto scan = new_of(scans_, robot_)) {
    ScanHits hits = scan_hits(scan->message);
    hits.received =
        known.obstacles && known.obstacles->stamp == hits.stamp ? known.obstacles->received : heard(scan->received);
    known.obstacles = std::move(hits);
  }
  if (const auto odometry = new_of(odometry_, robot_)) known.velocity = twist(odometry->message.velocity());
  if (const auto people = new_of(people_, robot_)) {
    known.people = walking_people(people->message);
    people_heard_ = now;
  }
  if (now - people_heard_ > from_seconds(kPeopleTimeout)) known.people.clear();
  constexpr double kLinkTimeout = 1.5;  // [s] as in the gate
  for (const auto& link : links_.each()) {
    if (link.message.host() != host_ || !link.message.up() || link.message.one_way()) continue;
    link_heard_ =
        std::max(link_heard_.value_or(Time{}), heard(link.received) - from_seconds(link.message.heard_age_s()));
  }
  known.link_lost = link_heard_ && now - *link_heard_ > from_seconds(kLinkTimeout);
  if (const auto status = new_of(base_status_, robot_)) known.base = base_report(status->message);
  return known;
}

void NavigatorService::step() {
  const Time now = clock_.now();
  if (clock_.epoch() != epoch_) {  // time begins anew: nothing known before holds
    epoch_ = clock_.epoch();
    navigator_ = Navigator{config_, link_loss_, zones_};
    situation_ = {};
    in_session_.reset();
    next_execution_ = {};
  }
  for (auto& plan : plans_.take()) {
    if (plan.message.robot() == robot_) {
      navigator_.receive_plan(plan_news(plan.message, robot_), now - (bus_.clock().now() - plan.received));
    }
  }
  publish(navigator_.decide(situation(now)), now);
}

void NavigatorService::publish(const Decision& decision, Time now) {
  // Without a session it is silent: then an operator may drive (teleop), whom a second commander would brake.
  constexpr double kLastWords = 1.0;  // [s] one of them may be lost
  if (situation_.running_session) in_session_ = now;
  if (in_session_ && now - *in_session_ <= from_seconds(kLastWords)) {
    commands_.write(velocity_command(decision.velocity, robot_, now, ++sequence_number_));
  }

  const Execution& execution = decision.execution;
  const bool changed = execution.differs_from(published_);
  if (changed || now >= next_execution_) {
    executions_.write(plan_execution(execution, robot_, now));
    next_execution_ = now + from_seconds(config_.execution_period_s);
  }
  if (changed) {
    spdlog::info("execution: plan={} moving={} blocked={} finished={} reason={}", execution.plan_id, execution.moving,
                 execution.blocked, execution.finished, execution.reason);
    published_ = execution;
  }
  health_.step(msg::HEALTH_OK);
}

}  // namespace tandem::navigator
