#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <thread>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/relay/core/forwarding.hpp"
#include "services/relay/core/instance_ledger.hpp"
#include "services/relay/core/relay_config.hpp"

namespace tandem {

/// A topic's writer on the host, for what comes in from the link. It outlives every change of the link: readers on the
/// host do not lose what they have.
struct InwardTopic {
  TopicInfo topic;
  std::unique_ptr<bus::RawWriter> writer;
  InstanceLedger ledger;  ///< the thread that carries in
};

/// Everything of a relay that hangs on its participant on the link: made anew when the address changes.
///
/// Samples flow on two threads of its own, out and in, from construction to destruction.
class LinkSide {
 public:
  using ClockOffset = std::function<std::optional<Duration>()>;

  /// `inward` must outlive it. `clock_offset` gives the peer's clock minus ours, nothing while unmeasured; it is asked
  /// on both threads. Throws std::runtime_error when the link cannot be joined.
  LinkSide(const bus::DomainOptions& options, HostRole role, const RelayConfig& config, bus::Bus& host,
           std::vector<InwardTopic>& inward, ClockOffset clock_offset);
  ~LinkSide();
  LinkSide(const LinkSide&) = delete;
  LinkSide& operator=(const LinkSide&) = delete;

  [[nodiscard]] bus::Bus& bus() { return link_; }
  [[nodiscard]] const std::string& address() const { return address_; }
  void send(const msg::LinkHeartbeat& heartbeat) { heartbeats_out_.write(heartbeat); }
  /// Those of others: a participant hears itself.
  [[nodiscard]] std::vector<bus::Received<msg::LinkHeartbeat>> heartbeats();
  /// Topics for which the other host's relay has not been found, as a reader or as a writer.
  [[nodiscard]] std::vector<std::string> unmatched() const;
  /// Whether any reader or writer of the other host's relay is known.
  [[nodiscard]] bool finds_other() const;
  /// Whether the other host's messages mean what ours do. While not, nothing of it comes in.
  void understand(bool understood) { understood_ = understood; }

 private:
  class OutwardRoute;
  class InwardRoute;
  void carry_out();
  void carry_in();

  std::string address_;
  bus::Bus& host_;
  bus::Bus link_;
  ClockOffset clock_offset_;
  bus::Writer<msg::LinkHeartbeat, msg::LinkHeartbeatPubSubType> heartbeats_out_;
  bus::InOrder<msg::LinkHeartbeat, msg::LinkHeartbeatPubSubType> heartbeats_in_;
  std::vector<std::unique_ptr<OutwardRoute>> outward_;
  std::vector<std::unique_ptr<InwardRoute>> inward_;
  std::set<bus::WriterId> own_;  // what we brought in does not go out again
  std::atomic<bool> understood_ = true;
  std::atomic<bool> ended_ = false;
  std::thread outward_thread_;
  std::thread inward_thread_;
};

}  // namespace tandem
