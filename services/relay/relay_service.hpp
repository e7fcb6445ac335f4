#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/relay/address_watcher.hpp"
#include "services/relay/core/link_monitor.hpp"
#include "services/relay/core/peer_seat.hpp"
#include "services/relay/core/relay_config.hpp"
#include "services/relay/core/torn_link.hpp"
#include "services/relay/link_side.hpp"
#include "services/relay/map_relay.hpp"

namespace tandem {

/// The one door between this host's domain and the link: copies payloads by the rules of the topic table, measures the
/// link by heartbeats, tells its host how the link is, and joins the link anew when its address changes.
class RelayService {
 public:
  RelayService(const SiteConfig& site, const RelayConfig& config, bus::Bus& host);

  /// One heartbeat and what it tells; to be called each heartbeat period. Samples flow on threads of their own.
  void step();

 private:
  [[nodiscard]] bool is_alone() const;  ///< everything runs on one host: nothing has to cross
  void follow_address();
  void join_link(const std::string& address);
  void set_trouble(const char* what, const std::string& trouble);
  void look_for_refused();
  /// Joins the link anew where the other host is heard, but not all of it is found, or where it is there, but silent.
  void mend_torn_link(bool is_up, Time now);
  [[nodiscard]] bool hears_strangers(Time now) const;
  [[nodiscard]] LinkState exchange_heartbeats(Time now);
  /// Whether a heartbeat is one of the other host of this team; names it if not.
  [[nodiscard]] bool is_of_our_peer(const bus::Received<msg::LinkHeartbeat>& heartbeat);
  /// What others on the link do wrong.
  [[nodiscard]] std::vector<bus::PeerFault> link_faults(Time now) const;
  void tell_host(const LinkState& state, Time now);
  /// The peer's clock minus ours; nothing while unmeasured.
  [[nodiscard]] std::optional<Duration> clock_offset() const;

  SiteConfig site_;
  RelayConfig config_;
  bus::Bus& host_;
  bus::Writer<msg::LinkStatus, msg::LinkStatusPubSubType> status_;
  bus::HealthReporter health_;
  mutable std::mutex monitor_mutex_;
  LinkMonitor monitor_;
  struct Stranger {
    bus::PeerFault fault;
    Time heard{};
  };
  std::map<std::string, Stranger> strangers_;  // by host: relays that are not of our kind, or of our name
  PeerSeat seat_;
  bool was_up_ = false;
  Time next_status_{};
  AddressWatcher watcher_;
  Time next_look_{};
  std::string trouble_;  // why the link is not joined, empty if it is
  std::string refused_;  // who is on the link without being a peer, and why; empty if nobody
  Time next_refused_{};
  TornLink torn_;
  std::vector<InwardTopic> inward_;
  std::unique_ptr<LinkSide> link_;
  MapRelay maps_;  // after the link: its readers there must go first
};

/// The link domain of `site` at `address`: one participant, in the partition of its team.
[[nodiscard]] bus::DomainOptions link_domain(const SiteConfig& site, const RelayConfig& config,
                                             const std::string& address);

}  // namespace tandem
