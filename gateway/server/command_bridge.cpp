#include "gateway/server/command_bridge.hpp"

#include <spdlog/spdlog.h>

#include "gateway/server/gateway_messages.hpp"

namespace tandem::gateway {

using protocol::CommandKind;

std::string event_id_of(const protocol::Command& command) {
  return command.client + "-" + std::to_string(command.sequence);
}

CommandBridge::CommandBridge(bus::Bus& bus, const SiteConfig& site, const Clock& clock)
    : site_(site),
      clock_(clock),
      human_messages_(bus, topic::kHumanMessage),
      pose_hints_(bus, topic::kPoseHint),
      detections_(bus, topic::kDetection),
      stop_requests_(bus, topic::kStopRequest),
      resume_requests_(bus, topic::kResumeRequest) {}

void CommandBridge::submit(const protocol::Command& command, const std::string& agent) {
  const Sender sender{.agent = agent.empty() ? site_.agent : agent,
                      .robot = site_.robot,
                      .id = event_id_of(command),
                      .pressed = clock_.now() - from_seconds(command.age_ms / 1000.0)};
  switch (command.kind) {
    case CommandKind::Stop:
      stop_requests_.send(to_stop_request(sender));
      break;
    case CommandKind::Resume:
      resume_requests_.send(to_resume_request(command, sender));
      break;
    case CommandKind::RobotPose:
      pose_hints_.send(to_pose_hint(command, sender));
      break;
    case CommandKind::Found:
      detections_.send(to_detection(command, sender));
      break;
    default:
      human_messages_.send(to_human_message(command, sender, ++sequence_number_));
  }
  pending_.push_back({command.client, command.sequence, command.kind, sender.id});
  spdlog::info("command sent: kind={} agent={} id={}", protocol::name_of(command.kind), sender.agent, sender.id);
}

std::vector<CommandBridge::Settled> CommandBridge::step() {
  human_messages_.step();
  pose_hints_.step();
  detections_.step();
  stop_requests_.step();
  resume_requests_.step();
  std::vector<Settled> settled;
  std::erase_if(pending_, [&](const Pending& pending) {
    const auto outcome = outcome_of(pending);
    using State = bus::EventOutcome::State;
    if (outcome.state == State::Pending) return false;
    const bool applied = outcome.state == State::Applied;
    const std::string reason = outcome.state == State::Undelivered ? "no answer from " + outcome.by : outcome.reason;
    if (!applied) {
      spdlog::warn("command not applied: kind={} id={} by={} why={}", protocol::name_of(pending.kind), pending.event_id,
                   outcome.by, reason);
    }
    settled.push_back(
        {pending.client, {pending.sequence, applied ? "applied" : "refused", applied ? "" : reason.substr(0, 300)}});
    return true;
  });
  return settled;
}

bus::EventOutcome CommandBridge::outcome_of(const Pending& pending) const {
  switch (pending.kind) {
    case CommandKind::Stop:
      return stop_requests_.outcome(pending.event_id);
    case CommandKind::Resume:
      return resume_requests_.outcome(pending.event_id);
    case CommandKind::RobotPose:
      return pose_hints_.outcome(pending.event_id);
    case CommandKind::Found:
      return detections_.outcome(pending.event_id);
    default:
      return human_messages_.outcome(pending.event_id);
  }
}

}  // namespace tandem::gateway
