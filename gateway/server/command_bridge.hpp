#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gateway/protocol/messages.hpp"
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

  /// Sends `command` of the phone of `agent`.
  void submit(const protocol::Command& command, const std::string& agent);

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
  };
  [[nodiscard]] bus::EventOutcome outcome_of(const Pending& pending) const;

  SiteConfig site_;
  const Clock& clock_;
  bus::EventSender<msg::HumanMessage, msg::HumanMessagePubSubType> human_messages_;
  bus::EventSender<msg::PoseHint, msg::PoseHintPubSubType> pose_hints_;
  bus::EventSender<msg::ObjectDetection, msg::ObjectDetectionPubSubType> detections_;
  bus::EventSender<msg::StopRequest, msg::StopRequestPubSubType> stop_requests_;
  bus::EventSender<msg::ResumeRequest, msg::ResumeRequestPubSubType> resume_requests_;
  std::vector<Pending> pending_;
  std::uint64_t sequence_number_ = 0;  ///< of human messages
};

}  // namespace tandem::gateway
