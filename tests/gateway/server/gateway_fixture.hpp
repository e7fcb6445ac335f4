#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gateway/net/websocket_client.hpp"
#include "gateway/server/gateway_service.hpp"
#include "services/common/file_io.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::gateway {

using net::WebSocketClient;
using protocol::CommandKind;

/// The whole gateway on a bus of its own, with one phone and the services that answer it, in one thread.
class GatewayServiceTest : public testing::Test {
 protected:
  GatewayServiceTest()
      : bus_(options(domains_[0])),
        stops_(bus_, topic::kStopRequest, "base"),
        source_edits_(bus_, topic::kSourceEdit, "planner"),
        belief_edits_(bus_, topic::kBeliefEdit, "planner"),
        reminders_(bus_.in_order(topic::kReminder)),
        to_planner_(bus_, topic::kHumanMessage, "planner"),
        to_tracker_(bus_, topic::kHumanMessage, "tracker") {
    start_gateway();
  }
  ~GatewayServiceTest() override { gateway_.reset(); }

  /// A gateway that ran before has ended by then.
  void start_gateway() {
    gateway_.reset();
    GatewayConfig config = config_;
    config.address = "127.0.0.1";
    config.port = 0;
    config.link_host = "127.0.0.1";
    config.state_folder = folder_.path();
    config.participant_link_file = folder_ / "participant";
    config.observer_link_file = folder_ / "observer";
    config.partner_link_file = folder_ / "partner";
    SiteConfig site;
    site.host = "laptop1";
    site.role = "laptop";
    gateway_.emplace(config, site, bus_, clock_, clock_);
  }

  static bus::DomainOptions options(int domain) {
    bus::DomainOptions options;
    options.domain = domain;
    options.participant = "gateway-test";
    return options;
  }

  WebSocketClient::Options patient() const {
    WebSocketClient::Options options;
    options.retry = std::chrono::seconds{60};
    return options;
  }
  net::PairingLink link(const char* slot) const { return *net::parse_pairing_link(read_file(folder_ / slot)); }

  /// Lets everybody work until `condition` holds, 10 s at most: at the gateway's beat, and when there is news of
  /// `source`, a phone or the bus.
  template <typename Source>
  bool eventually(Source& source, const std::function<bool()>& condition) {
    constexpr std::chrono::milliseconds kBeat{10};
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{10};
         std::chrono::steady_clock::now() < end; source.wait(kBeat)) {
      gateway_->step();
      for (const auto& stop : stops_.take()) {
        stop_requests_.push_back(stop);
        stops_.applied(stop.id());
      }
      for (const auto& message : to_planner_.take()) {
        human_messages_.push_back(message);
        unanswered_.push_back(message.id());
      }
      if (answers_) {
        for (const auto& id : unanswered_) to_planner_.applied(id);
        unanswered_.clear();
      }
      for (const auto& message : to_tracker_.take()) to_tracker_.applied(message.id());
      for (const auto& edit : source_edits_.take()) {
        drawn_.push_back(edit);
        source_edits_.applied(edit.id());
      }
      for (const auto& edit : belief_edits_.take()) {
        said_.push_back(edit);
        belief_edits_.refused(edit.id(), "the search has not begun");
      }
      for (const auto& reminder : reminders_.take()) reminded_.push_back(reminder.message);
      if (condition()) return true;
    }
    return false;
  }

  /// Collects what `phone` gets until a message satisfies `wanted`.
  template <typename Message>
  std::optional<Message> hear(WebSocketClient& phone, const std::function<bool(const Message&)>& wanted) {
    std::optional<Message> found;
    eventually(phone, [&] {
      for (const auto& text : phone.take()) {
        const auto parsed = protocol::parse_server_message(text);
        const auto* message = std::get_if<protocol::ServerMessage>(&parsed);
        if (message == nullptr) {
          ADD_FAILURE() << "the gateway sent " << text;
          continue;
        }
        const auto* one = std::get_if<Message>(message);
        if (one != nullptr && wanted(*one)) found = *one;
      }
      return found.has_value();
    });
    return found;
  }

  static std::string command(std::uint64_t sequence, CommandKind kind, std::optional<protocol::Point> at = {}) {
    protocol::Command one;
    one.client = "phone-0001";
    one.sequence = sequence;
    one.kind = kind;
    one.point_in_map = at;
    return protocol::write(protocol::ClientMessage{one});
  }

  GatewayConfig config_;  ///< of the next gateway
  test::DomainLease domains_{1};
  test::TemporaryFolder folder_;
  bus::Bus bus_;
  SteadyClock clock_;
  bus::EventReceiver<msg::StopRequest, msg::StopRequestPubSubType> stops_;
  bus::EventReceiver<msg::SourceEdit, msg::SourceEditPubSubType> source_edits_;
  bus::EventReceiver<msg::BeliefEdit, msg::BeliefEditPubSubType> belief_edits_;
  bus::InOrder<msg::ReminderEvent, msg::ReminderEventPubSubType> reminders_;
  std::vector<msg::SourceEdit> drawn_;
  std::vector<msg::BeliefEdit> said_;
  std::vector<msg::ReminderEvent> reminded_;
  bus::EventReceiver<msg::HumanMessage, msg::HumanMessagePubSubType> to_planner_;
  bus::EventReceiver<msg::HumanMessage, msg::HumanMessagePubSubType> to_tracker_;
  std::vector<msg::StopRequest> stop_requests_;
  std::vector<msg::HumanMessage> human_messages_;
  std::vector<std::string> unanswered_;  ///< ids of those
  bool answers_ = true;                  ///< the planner sends receipts
  std::optional<GatewayService> gateway_;
};

}  // namespace tandem::gateway
