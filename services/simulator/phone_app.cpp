#include "services/simulator/phone_app.hpp"

#include <algorithm>
#include <variant>

namespace tandem::simulator {
namespace {

protocol::CommandKind kind_of(PhonePress press) {
  switch (press) {
    case PhonePress::MyPose:
      return protocol::CommandKind::MyPose;
    case PhonePress::MyGoal:
      return protocol::CommandKind::MyGoal;
    case PhonePress::Replan:
      return protocol::CommandKind::Replan;
    case PhonePress::Found:
      return protocol::CommandKind::Found;
  }
  return protocol::CommandKind::Replan;
}

}  // namespace

void PhoneApp::connected_anew() {
  view_.connected = false;
}

std::vector<std::string> PhoneApp::receive(const std::string& text, Time now) {
  const auto parsed = protocol::parse_server_message(text);
  const auto* message = std::get_if<protocol::ServerMessage>(&parsed);
  std::vector<std::string> answers;
  if (message == nullptr) {
    ++malformed_;
  } else if (std::holds_alternative<protocol::Hello>(*message)) {
    view_.connected = true;
    for (const auto& kept : outbox_) answers.push_back(text_of(kept, now));
  } else if (const auto* state = std::get_if<protocol::State>(message)) {
    view_.computing = state->planner.activity == "computing";
    view_.search_over = state->planner.activity == "finished";
    if (!last_seen_ || now - *last_seen_ >= std::chrono::seconds{1}) {
      last_seen_ = now;
      answers.push_back(protocol::write(protocol::ClientMessage{protocol::Seen{state->sequence}}));
    }
  } else if (const auto* plan = std::get_if<protocol::Plan>(message)) {
    show(*plan);
  } else if (const auto* event = std::get_if<protocol::Event>(message)) {
    if (!event->id.empty()) answers.push_back(protocol::write(protocol::ClientMessage{protocol::GotIt{event->id}}));
  } else if (const auto* ack = std::get_if<protocol::Ack>(message)) {
    while (!outbox_.empty() && outbox_.front().command.sequence <= ack->up_to) outbox_.pop_front();
    for (const auto& result : ack->results) {
      if (result.sequence == last_replan_) view_.replan_refused = result.outcome == "refused";
    }
  }
  return answers;
}

void PhoneApp::show(const protocol::Plan& plan) {
  view_.plan.reset();
  if (plan.id.empty() || (plan.state != "proposed" && plan.state != "accepted")) return;
  const auto own = std::find_if(plan.paths.begin(), plan.paths.end(),
                                [this](const protocol::Path& path) { return path.agent == agent_; });
  if (own == plan.paths.end()) return;
  PhonePlan shown{plan.id, {}};
  for (const auto& point : own->points) shown.own_path_in_map.emplace_back(point.point.x, point.point.y);
  view_.plan = std::move(shown);
}

std::vector<std::string> PhoneApp::press(const PhoneMessage& message, Time now) {
  Kept kept{.command = {}, .pressed = now};
  kept.command.client = client_;
  kept.command.sequence = ++last_sequence_;
  kept.command.kind = kind_of(message.press);
  if (message.point_in_map) {
    kept.command.point_in_map = protocol::Point{message.point_in_map->x(), message.point_in_map->y()};
  }
  kept.command.heading = message.heading;
  if (message.press == PhonePress::Replan) {
    last_replan_ = last_sequence_;
    view_.replan_refused = false;
  }
  outbox_.push_back(kept);
  if (!view_.connected) return {};
  return {text_of(kept, now)};
}

std::string PhoneApp::text_of(const Kept& kept, Time now) {
  protocol::Command command = kept.command;
  command.age_ms = 1000.0 * to_seconds(now - kept.pressed);
  return protocol::write(protocol::ClientMessage{std::move(command)});
}

}  // namespace tandem::simulator
