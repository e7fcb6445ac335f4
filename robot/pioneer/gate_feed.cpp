#include "robot/pioneer/gate_feed.hpp"

#include <cmath>

#include "robot/pioneer/base_messages.hpp"

namespace tandem {
namespace {

constexpr double kFreshPose_s = 0.5;
constexpr double kFreshTeammate_s = 1.0;
constexpr std::size_t kMostCommands = 100;

/// Another process may have set its clock before a step of the wall clock: only a stamp that can be true counts.
Time plausible_stamp(Time stamp, Time received) {
  constexpr Duration kLongestWay = std::chrono::seconds{1};
  return stamp <= received && received - stamp < kLongestWay ? stamp : received;
}

}  // namespace

GateFeed::GateFeed(bus::Bus& bus, const SiteConfig& site, std::string map_sha256)
    : robot_(site.robot),
      host_(site.host),
      may_go_on_(site.on_link_loss != "stop"),
      commands_(bus.in_order(topic::kVelocityCommand, kMostCommands)),
      stops_(bus, topic::kStopRequest, "base"),
      resumes_(bus, topic::kResumeRequest, "base"),
      scans_(bus.latest(topic::kScan)),
      people_(bus.latest(topic::kPeople)),
      teammates_(bus.latest(topic::kTeammates)),
      poses_(bus.latest(topic::kRobotPose)),
      links_(bus.latest(topic::kLinkStatus)),
      map_sha256_(std::move(map_sha256)) {
  if (!map_sha256_.empty()) maps_.emplace(bus.latest(topic::kMap));
}

bool GateFeed::feed(safety::SafetyGate& gate, const Pose2& odom_from_base, Time now) {
  bool asked = false;
  for (const auto& stop : stops_.take()) {
    if (!stop.robot().empty() && stop.robot() != robot_) continue;
    gate.take_stop(stop.latched());
    asked = true;
    stops_.applied(stop.id());
    notes_.push_back("stop requested: who=" + stop.who());
  }
  for (const auto& resume : resumes_.take()) {
    if (resume.robot() != robot_) continue;
    const std::string_view refusal = gate.take_resume(resume.held_ms() / 1000.0, now);
    if (refusal.empty()) {
      resumes_.applied(resume.id());
    } else {
      resumes_.refused(resume.id(), std::string{refusal});
    }
    notes_.push_back("resume requested: who=" + resume.who() + (refusal.empty() ? " granted" : " refused: ") +
                     std::string{refusal});
  }
  for (const auto& command : commands_.take()) {
    if (command.message.robot() != robot_) continue;
    gate.take_command(from_message(command.message, command.writer), command.received);
    asked = true;
  }
  if (const auto scan = scans_.take_new(); scan && scan->message.robot() == robot_) {
    gate.take_scan(view_of(scan->message), odom_from_base, scan->received);
  }
  return asked;
}

void GateFeed::complete(safety::GateInput& input, Time now) {
  input.pose = {};
  map_from_base_.reset();
  if (const auto pose = poses_.newest(); pose && pose->message.robot() == robot_) {
    input.pose.age_s = to_seconds(now - pose->received);
    input.pose.lost = pose->message.status() == msg::LOCALIZATION_LOST;
    input.pose.map_from_base = from_message(pose->message.map_from_base());
    input.pose.stamp = plausible_stamp(from_stamp_ns(pose->message.stamp_ns()), pose->received);
    if (*input.pose.age_s < kFreshPose_s) map_from_base_ = from_message(pose->message.map_from_base());
  }
  find_people(now, input.people);
  if (maps_) {
    if (const auto map = maps_->take_new()) other_map_ = map->message.sha256() != map_sha256_;
    input.other_map = other_map_;
  }

  for (const auto& link : links_.each()) {
    if (link.message.host() != host_ || !link.message.up() || link.message.one_way()) continue;
    const Time heard = link.received - from_seconds(link.message.heard_age_s());
    if (!link_heard_ || heard > *link_heard_) link_heard_ = heard;
  }
  input.link.may_go_on = may_go_on_;
  input.link.silent_s.reset();
  if (link_heard_) input.link.silent_s = to_seconds(now - *link_heard_);
}

void GateFeed::find_people(Time now, safety::PeopleInput& people) {
  people_in_base_.clear();
  people.age_s.reset();
  const auto add = [&](const Pose2& map_from_base, double x, double y) {
    if (std::isfinite(x) && std::isfinite(y)) people_in_base_.push_back(inverse(map_from_base) * Eigen::Vector2d{x, y});
  };
  if (const auto seen = people_.newest(); seen && seen->message.robot() == robot_) {
    people.age_s = to_seconds(now - seen->received);
    const Pose2 map_from_base = map_from_base_.value_or(from_message(seen->message.map_from_base()));
    for (const auto& person : seen->message.people()) {
      add(map_from_base, person.position_in_map().x(), person.position_in_map().y());
    }
  }
  // A teammate counts where the laser sees one; where a message or a guess puts one, nobody may be.
  for (const auto& teammate : teammates_.each()) {
    const auto& message = teammate.message;
    const double age_s = message.age_s() + to_seconds(now - teammate.received);
    if (!map_from_base_ || message.robot() != robot_ || message.source() != msg::SOURCE_LASER ||
        message.state() != msg::TRACK_TRACKED || !(age_s < kFreshTeammate_s)) {
      continue;
    }
    add(*map_from_base_, message.map_from_agent().x(), message.map_from_agent().y());
  }
  people.in_base = people_in_base_;
}

}  // namespace tandem
