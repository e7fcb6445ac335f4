#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/relay/core/link_monitor.hpp"
#include "services/relay/core/relay_config.hpp"

namespace tandem {

/// The one door between this host's domain and the link: copies payloads by the rules of the topic table, measures the
/// link by heartbeats, and tells its host how the link is.
class RelayService {
 public:
  RelayService(const SiteConfig& site, const RelayConfig& config, bus::Bus& host, bus::Bus& link);
  ~RelayService();
  RelayService(const RelayService&) = delete;
  RelayService& operator=(const RelayService&) = delete;

  /// One heartbeat and what it tells; to be called each heartbeat period. Samples flow on threads of their own.
  void step();

 private:
  class Route;
  void pump(bus::Bus& from, std::vector<std::unique_ptr<Route>>& routes);
  /// The peer's clock minus ours; nothing while unmeasured.
  [[nodiscard]] std::optional<Duration> clock_offset() const;

  SiteConfig site_;
  RelayConfig config_;
  bus::Bus& host_;
  bus::Bus& link_;
  bus::Writer<msg::LinkHeartbeat, msg::LinkHeartbeatPubSubType> heartbeats_out_;
  bus::InOrder<msg::LinkHeartbeat, msg::LinkHeartbeatPubSubType> heartbeats_in_;
  bus::Writer<msg::LinkStatus, msg::LinkStatusPubSubType> status_;
  bus::HealthReporter health_;
  mutable std::mutex monitor_mutex_;
  LinkMonitor monitor_;
  std::string foreign_contract_;
  bool was_up_ = false;
  Time next_status_{};
  std::vector<std::unique_ptr<Route>> outward_;
  std::vector<std::unique_ptr<Route>> inward_;
  std::set<bus::WriterId> own_;
  std::atomic<bool> ended_ = false;
  std::thread outward_thread_;
  std::thread inward_thread_;
};

/// The link domain of `site`: one participant, in the partition of its team.
[[nodiscard]] bus::DomainOptions link_domain(const SiteConfig& site);

}  // namespace tandem
