#pragma once

#include <map>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/event_log.hpp"

namespace tandem::bus {

/// An id no other event has: who, when, and a count within this process.
[[nodiscard]] std::string new_event_id(const std::string& who, const Clock& clock);

/// The services named in `appliers` ("planner,tracker").
[[nodiscard]] std::vector<std::string> split_appliers(std::string_view appliers);

/// Sends Events of one topic and repeats each until every applier has sent its receipt, or gives up.
template <class Message, class PubSubType>
class EventSender {
 public:
  EventSender(Bus& bus, const Topic<PubSubType>& topic, Duration give_up_after = std::chrono::seconds{10})
      : bus_(bus),
        writer_(bus.writer(topic)),
        receipts_(bus.in_order(topic::kMessageReceipt)),
        sent_(split_appliers(topic.appliers), std::chrono::seconds{1}, give_up_after) {}

  /// Sends `event`, whose id must be new (new_event_id).
  void send(const Message& event) {
    sent_.sent(event.id(), bus_.clock().now());
    if (sent_.is_pending(event.id())) unanswered_[event.id()] = event;
    writer_.write(event);
  }
  /// Reads receipts and repeats what is due; to be called a few times a second.
  void step() {
    for (const auto& receipt : receipts_.take()) {
      const auto& message = receipt.message;
      sent_.answered(message.id(), message.by(), message.applied(), message.reason());
    }
    for (const auto& id : sent_.due(bus_.clock().now())) writer_.write(unanswered_.at(id));
    std::erase_if(unanswered_, [this](const auto& item) { return !sent_.is_pending(item.first); });
  }
  [[nodiscard]] EventOutcome outcome(const std::string& id) const { return sent_.outcome(id); }
  /// Whether anybody listens yet: for a sender that has just begun, whose first words nobody would hear.
  [[nodiscard]] bool is_heard() { return writer_.raw().matched_readers() > 0; }

 private:
  Bus& bus_;
  Writer<Message, PubSubType> writer_;
  InOrder<msg::MessageReceipt, msg::MessageReceiptPubSubType> receipts_;
  SentEvents sent_;
  std::map<std::string, Message> unanswered_;
};
template <class PubSubType, class... Times>
EventSender(Bus&, const Topic<PubSubType>&, Times...) -> EventSender<typename PubSubType::type, PubSubType>;

/// Gives each Event of one topic once, and answers repetitions as the first was answered.
template <class Message, class PubSubType>
class EventReceiver {
 public:
  EventReceiver(Bus& bus, const Topic<PubSubType>& topic, std::string service)
      : bus_(bus),
        topic_(topic.name),
        service_(std::move(service)),
        events_(bus.in_order(topic)),
        receipts_(bus.writer(topic::kMessageReceipt)) {}

  /// New events in order of arrival. Each must be answered by applied() or refused().
  [[nodiscard]] std::vector<Message> take() {
    std::vector<Message> fresh;
    for (auto& received : events_.take()) {
      const std::string id = received.message.id();
      if (log_.is_new(id)) {
        fresh.push_back(std::move(received.message));
      } else if (const auto answer = log_.answer_to(id)) {
        send_receipt(id, *answer);
      }
    }
    return fresh;
  }
  void applied(const std::string& id) { answer(id, {true, ""}); }
  void refused(const std::string& id, const std::string& reason) { answer(id, {false, reason}); }

 private:
  void answer(const std::string& id, const AppliedEvents::Answer& given) {
    log_.answer(id, given);
    send_receipt(id, given);
  }
  void send_receipt(const std::string& id, const AppliedEvents::Answer& given) {
    msg::MessageReceipt receipt;
    receipt.id(id);
    receipt.topic(topic_);
    receipt.by(service_);
    receipt.stamp_ns(to_stamp_ns(bus_.clock().now()));
    receipt.applied(given.applied);
    receipt.reason(given.reason);
    receipts_.write(receipt);
  }

  Bus& bus_;
  std::string topic_;
  std::string service_;
  InOrder<Message, PubSubType> events_;
  Writer<msg::MessageReceipt, msg::MessageReceiptPubSubType> receipts_;
  AppliedEvents log_;
};
template <class PubSubType>
EventReceiver(Bus&, const Topic<PubSubType>&, const char*) -> EventReceiver<typename PubSubType::type, PubSubType>;

}  // namespace tandem::bus
