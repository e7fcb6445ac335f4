#include "gateway/server/team_view.hpp"

#include <algorithm>
#include <cmath>

#include "gateway/server/gateway_messages.hpp"

namespace tandem::gateway {
namespace {

/// A planner says its plan again every second; one not heard for this long is dead.
constexpr Duration kPlanLife = from_seconds(3.0);

/// What the person has not taken notice of for so long is shown to no phone any more.
constexpr Duration kInformLife = from_seconds(30.0);

/// The newest sample of the instances for which `is_ours` holds.
template <class Message, class PubSubType, class Predicate>
std::optional<bus::Received<Message>> newest_of(const bus::Latest<Message, PubSubType>& topic, Predicate is_ours) {
  std::optional<bus::Received<Message>> newest;
  for (auto& one : topic.each()) {
    if (is_ours(one.message) && (!newest || one.received > newest->received)) newest = std::move(one);
  }
  return newest;
}

}  // namespace

TeamView::TeamView(bus::Bus& bus, const SiteConfig& site)
    : bus_(bus),
      site_(site),
      maps_(bus.latest(topic::kMap)),
      robot_poses_(bus.latest(topic::kRobotPose)),
      teammates_(bus.latest(topic::kTeammates)),
      planner_statuses_(bus.latest(topic::kPlannerStatus)),
      executions_(bus.latest(topic::kPlanExecution)),
      base_statuses_(bus.latest(topic::kBaseStatus)),
      link_statuses_(bus.latest(topic::kLinkStatus)),
      plans_(bus.latest(topic::kTeamPlan)),
      reward_sources_(bus.latest(topic::kRewardSource)),
      beliefs_(bus.latest(topic::kBelief)),
      sessions_(bus.latest(topic::kSession)),
      detections_(bus.in_order(topic::kDetection)),
      informs_(bus, topic::kInform, "gateway") {}

void TeamView::step() {
  map_.changed = plan_.changed = sources_.changed = belief_.changed = false;
  events_.clear();
  read_map();
  read_plan();
  read_sources();
  read_belief();
  read_events();
}

void TeamView::read_map() {
  const auto map = maps_.take_new();
  if (!map || map->message.cells().size() != std::size_t{map->message.width()} * map->message.height()) return;
  map_frame_ = to_phone(map->message);
  map_ = {protocol::write(protocol::ServerMessage{*map_frame_}), true};
  map_frame_->runs.clear();
}

void TeamView::read_plan() {
  const Time now = bus_.clock().now();
  if (const auto plan = plans_.take_new(); plan && plan->message.robot() == site_.robot) {
    plan_heard_ = plan->received;
    std::string text = protocol::write(protocol::ServerMessage{to_phone(plan->message)});
    if (text != plan_.data) plan_ = {std::move(text), true};
    shown_plan_id_ = plan->message.id();
  } else if (!shown_plan_id_.empty() && now - plan_heard_ > kPlanLife) {
    plan_ = {protocol::write(protocol::ServerMessage{protocol::Plan{}}), true};
    shown_plan_id_.clear();
  }
}

void TeamView::read_sources() {
  protocol::Sources drawn;
  for (const auto& source : reward_sources_.each()) {
    if (auto shown = to_phone(source.message)) drawn.sources.push_back(std::move(*shown));
  }
  std::string text = protocol::write(protocol::ServerMessage{std::move(drawn)});
  if (text != sources_.data) sources_ = {std::move(text), true};
}

void TeamView::read_belief() {
  const auto belief = beliefs_.take_new();
  if (!belief || belief->message.robot() != site_.robot) return;
  explored_ = std::clamp(std::isfinite(belief->message.explored()) ? belief->message.explored() : 0.0, 0.0, 1.0);
  const auto cells = std::size_t{belief->message.width()} * belief->message.height();
  if (cells == 0 || belief->message.cells().size() != cells) return;
  belief_ = {protocol::write(to_phone(belief->message, ++belief_revision_)), true};
}

void TeamView::read_events() {
  for (const auto& received : detections_.take()) {
    const auto& detection = received.message;
    const auto& id = detection.id();
    const bool repeated = std::find(seen_detections_.begin(), seen_detections_.end(), id) != seen_detections_.end();
    if (repeated || detection.robot() != site_.robot) continue;
    seen_detections_.push_back(id);
    found_ = protocol::Event{"found", detection.detected_by(),
                             protocol::Point{detection.point_in_map().x(), detection.point_in_map().y()}};
    events_.push_back(*found_);
  }
  for (const auto& inform : informs_.take()) {
    if (inform.agent() != site_.agent) {
      informs_.refused(inform.id(), "there is no phone of " + inform.agent());
      continue;
    }
    inform_ = protocol::Event{"inform", inform.reason().substr(0, 300), {}, inform.id()};
    inform_heard_ = bus_.clock().now();
    events_.push_back(*inform_);
  }
}

std::optional<protocol::Event> TeamView::waiting_inform() const {
  return bus_.clock().now() - inform_heard_ < kInformLife ? inform_ : std::nullopt;
}

void TeamView::got_it(const std::string& id) {
  if (!inform_ || inform_->id != id) return;
  informs_.applied(id);
  inform_.reset();
}

protocol::State TeamView::state() const {
  const Time now = bus_.clock().now();
  const auto is_ours = [this](const auto& message) { return message.robot() == site_.robot; };
  protocol::State state;
  if (const auto pose = newest_of(robot_poses_, is_ours)) state.robot = to_phone(pose->message, now - pose->received);
  const auto person = newest_of(teammates_, [this](const auto& message) { return message.agent() == site_.agent; });
  if (person) state.person = to_phone(person->message, now - person->received);
  if (const auto status = newest_of(planner_statuses_, is_ours)) state.planner = to_phone(status->message);
  const auto base = newest_of(base_statuses_, is_ours);
  const auto execution = newest_of(executions_, is_ours);
  state.base = to_phone(base ? &base->message : nullptr, execution ? &execution->message : nullptr);
  const auto link = newest_of(link_statuses_, [this](const auto& message) { return message.host() == site_.host; });
  if (link) state.link = to_phone(link->message);
  state.explored = explored_;
  return state;
}

protocol::Session TeamView::session() const {
  const auto session = newest_of(sessions_, [this](const auto& one) { return one.robot() == site_.robot; });
  return to_phone(session ? &session->message : nullptr);
}

bool TeamView::is_on_map(const protocol::Point& point) const {
  if (!map_frame_) return true;
  const double dx = point.x - map_frame_->origin.x;
  const double dy = point.y - map_frame_->origin.y;
  const double along = dx * std::cos(map_frame_->heading) + dy * std::sin(map_frame_->heading);
  const double across = -dx * std::sin(map_frame_->heading) + dy * std::cos(map_frame_->heading);
  return along >= 0.0 && across >= 0.0 && along <= map_frame_->width * map_frame_->resolution_m &&
         across <= map_frame_->height * map_frame_->resolution_m;
}

}  // namespace tandem::gateway
