#include "gateway/server/command_bridge.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace tandem::gateway {

using protocol::CommandKind;

namespace {

constexpr Duration kReceiptPatience = from_seconds(2.0);

bool is_message_to_team(CommandKind kind) {
  switch (kind) {
    case CommandKind::MyPose:
    case CommandKind::MyGoal:
    case CommandKind::RobotGoal:
    case CommandKind::ClearMyGoal:
    case CommandKind::ClearRobotGoal:
    case CommandKind::Replan:
      return true;
    default:
      return false;
  }
}

}  // namespace

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
      resume_requests_(bus, topic::kResumeRequest),
      source_edits_(bus, topic::kSourceEdit),
      belief_edits_(bus, topic::kBeliefEdit),
      reminders_(bus, topic::kReminder),
      answers_(bus, topic::kQuestionnaireAnswer),
      recorded_messages_(bus.writer(topic::kHumanMessage)),
      recorded_detections_(bus.writer(topic::kDetection)) {}

Sender CommandBridge::sender_of(const protocol::Command& command, const std::string& agent) const {
  return {.agent = agent.empty() ? site_.agent : agent,
          .robot = site_.robot,
          .id = event_id_of(command),
          .pressed = clock_.now() - from_seconds(command.age_ms / 1000.0)};
}

void CommandBridge::record(const protocol::Command& command, const std::string& agent) {
  const Sender sender = sender_of(command, agent);
  if (command.kind == CommandKind::Found) {
    recorded_detections_.write(to_detection(command, sender));
  } else {
    recorded_messages_.write(to_human_message(command, sender, ++sequence_number_));
  }
  spdlog::info("command recorded: kind={} agent={} id={}", protocol::name_of(command.kind), sender.agent, sender.id);
}

void CommandBridge::submit(const protocol::Command& command, const std::string& agent) {
  const Sender sender = sender_of(command, agent);
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
    case CommandKind::SourceEdit:
      source_edits_.send(to_source_edit(command, sender));
      break;
    case CommandKind::BeliefEdit:
      belief_edits_.send(to_belief_edit(command, sender));
      break;
    case CommandKind::Reminder:
      reminders_.send(to_reminder(command, sender));
      break;
    case CommandKind::Layer:
      answers_.send(to_layer_record(command, sender));
      break;
    default:
      waiting_.push_back({command, sender});
      return send_next_messages();
  }
  await_receipt(command, sender);
}

void CommandBridge::send_next_messages() {
  const auto is_answered_or_late = [this](const Pending& pending) {
    return !is_message_to_team(pending.kind) || clock_.now() - pending.sent >= kReceiptPatience;
  };
  while (!waiting_.empty() && std::all_of(pending_.begin(), pending_.end(), is_answered_or_late)) {
    const Waiting next = std::move(waiting_.front());
    waiting_.pop_front();
    human_messages_.send(to_human_message(next.command, next.sender, ++sequence_number_));
    await_receipt(next.command, next.sender);
  }
}

void CommandBridge::await_receipt(const protocol::Command& command, const Sender& sender) {
  pending_.push_back({command.client, command.sequence, command.kind, sender.id, clock_.now()});
  spdlog::info("command sent: kind={} agent={} id={}", protocol::name_of(command.kind), sender.agent, sender.id);
}

std::vector<CommandBridge::Settled> CommandBridge::step() {
  human_messages_.step();
  pose_hints_.step();
  detections_.step();
  stop_requests_.step();
  resume_requests_.step();
  source_edits_.step();
  belief_edits_.step();
  reminders_.step();
  answers_.step();
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
  send_next_messages();
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
    case CommandKind::SourceEdit:
      return source_edits_.outcome(pending.event_id);
    case CommandKind::BeliefEdit:
      return belief_edits_.outcome(pending.event_id);
    case CommandKind::Reminder:
      return reminders_.outcome(pending.event_id);
    case CommandKind::Layer:
      return answers_.outcome(pending.event_id);
    default:
      return human_messages_.outcome(pending.event_id);
  }
}

}  // namespace tandem::gateway
