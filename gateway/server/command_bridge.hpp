#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "gateway/protocol/messages.hpp"
#include "gateway/server/gateway_messages.hpp"
#include "idl/topics.hpp"
#include "services/bus/events.hpp"
#include "services/common/clock.hpp"
#include "services/common/site_config.hpp"

namespace tandem::gateway {

/// The id of the Event that `command` becomes: what the phone that counts it calls it.
[[nodiscard]] std::string event_id_of(const protocol::Command& command);

/// Puts commands of phones on the bus as Events, and tells what became of them.
///
/// A command that a phone sends again, to a gateway that has been restarted, is the same Event by its id, and who
/// applied it already does not do so twice.
class CommandBridge {
 public:
  /// `clock` is mission time, for the stamps.
  CommandBridge(bus::Bus& bus, const SiteConfig& site, const Clock& clock);

  /// Sends `command` of the phone of `agent`. A message to the team waits for the receipt of the one before, for two
  /// seconds at most: while services find each other the later of two goals would overtake the earlier.
  void submit(const protocol::Command& command, const std::string& agent);
  /// Puts `command` of two people who search without a robot into the recording: nobody else applies it.
  void record(const protocol::Command& command, const std::string& agent);

  struct Settled {
    std::string client;
    protocol::Result result;
  };
  /// Repeats what has no receipt yet. Gives the commands whose fate is known since the last call.
  [[nodiscard]] std::vector<Settled> step();

 private:
  struct Pending {
    std::string client;
    std::uint64_t sequence = 0;
    protocol::CommandKind kind = protocol::CommandKind::Replan;
    std::string event_id;
    Time sent{};
  };
  struct Waiting {
    protocol::Command command;
    Sender sender;
  };
  void send_next_messages();
  void await_receipt(const protocol::Command& command, const Sender& sender);
  [[nodiscard]] Sender sender_of(const protocol::Command& command, const std::string& agent) const;
  [[nodiscard]] bus::EventOutcome outcome_of(const Pending& pending) const;

  SiteConfig site_;
  const Clock& clock_;
  bus::EventSender<msg::HumanMessage, msg::HumanMessagePubSubType> human_messages_;
  bus::EventSender<msg::PoseHint, msg::PoseHintPubSubType> pose_hints_;
  bus::EventSender<msg::ObjectDetection, msg::ObjectDetectionPubSubType> detections_;
  bus::EventSender<msg::StopRequest, msg::StopRequestPubSubType> stop_requests_;
  bus::EventSender<msg::ResumeRequest, msg::ResumeRequestPubSubType> resume_requests_;
  bus::EventSender<msg::SourceEdit, msg::SourceEditPubSubType> source_edits_;
  bus::EventSender<msg::BeliefEdit, msg::BeliefEditPubSubType> belief_edits_;
  bus::EventSender<msg::ReminderEvent, msg::ReminderEventPubSubType> reminders_;
  bus::EventSender<msg::QuestionnaireAnswer, msg::QuestionnaireAnswerPubSubType> answers_;
  bus::Writer<msg::HumanMessage, msg::HumanMessagePubSubType> recorded_messages_;
  bus::Writer<msg::ObjectDetection, msg::ObjectDetectionPubSubType> recorded_detections_;
  std::vector<Pending> pending_;
  std::deque<Waiting> waiting_;        ///< messages to the team that were not sent yet
  std::uint64_t sequence_number_ = 0;  ///< of human messages
};

}  // namespace tandem::gateway
