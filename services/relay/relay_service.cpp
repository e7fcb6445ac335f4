#include "services/relay/relay_service.hpp"

#include <spdlog/spdlog.h>

#include "services/bus/payload_type.hpp"
#include "services/common/version.hpp"
#include "services/relay/core/forwarding.hpp"
#include "services/relay/relay_messages.hpp"

namespace tandem {
namespace {

constexpr Duration kStatusPeriod = std::chrono::milliseconds{500};

}  // namespace

bus::DomainOptions link_domain(const SiteConfig& site) {
  bus::DomainOptions options;
  options.kind = bus::DomainOptions::Kind::Link;
  options.domain = static_cast<int>(site.link_domain);
  options.participant = "relay@" + site.host;
  options.address = site.link_address;
  options.discovery = site.discovery;
  options.peers = site.peers;
  options.partitions = {site.robot};
  return options;
}

/// One topic in one direction.
class RelayService::Route {
 public:
  Route(const TopicInfo& topic, Crossing crossing, bus::Bus& from, bus::Bus& to, std::size_t scan_beams)
      : name_(topic.name),
        crossing_(crossing),
        thins_scans_(topic.name == topic::kScan.name && crossing == Crossing::HostToLink),
        scan_beams_(scan_beams),
        type_(topic),
        gate_(rule_of(topic)),
        box_(std::make_shared<bus::InOrderBox>(1000)),
        writer_(to.raw_writer(topic)),
        subscription_(from.subscribe(topic, box_)) {}

  [[nodiscard]] bus::WriterId writer_id() const { return writer_->id(); }

  /// `own` are the writers of all routes: what we brought in does not go out again.
  void forward(Time now, std::optional<Duration> clock_offset, const std::set<bus::WriterId>& own) {
    for (const auto& sample : box_->take()) {
      if (own.contains(sample.writer)) continue;
      if (sample.kind != bus::RawSample::Kind::Data) {
        writer_->dispose(sample.key);
        continue;
      }
      // Inward, the source's clock is the peer's.
      const bool inward = crossing_ == Crossing::LinkToHost;
      const Time source_time =
          sample.source_time - (inward ? clock_offset.value_or(Duration::zero()) : Duration::zero());
      const bool age_known = !inward || clock_offset.has_value();
      const double age_s = age_known ? to_seconds(now - source_time) : 0.0;
      if (!gate_.passes(sample.key, now, age_s)) continue;
      if (!type_.is_well_formed(sample.payload)) {  // the link is outside: nothing malformed enters the house
        spdlog::warn("malformed sample dropped: topic={} bytes={}", name_, sample.payload.size());
        continue;
      }
      writer_->write(thins_scans_ ? thinned_payload(sample.payload) : sample.payload, sample.key, source_time);
    }
  }

 private:
  [[nodiscard]] std::vector<std::uint8_t> thinned_payload(const std::vector<std::uint8_t>& payload) const {
    const auto scan = bus::decode<msg::LaserScanPubSubType>(payload);
    return scan ? bus::encode<msg::LaserScanPubSubType>(thinned(*scan, scan_beams_)) : payload;
  }

  std::string name_;
  Crossing crossing_;
  bool thins_scans_;
  std::size_t scan_beams_;
  bus::PayloadType type_;
  ForwardingGate gate_;
  std::shared_ptr<bus::InOrderBox> box_;  // shared with the subscription, which may still be filling it at the end
  std::unique_ptr<bus::RawWriter> writer_;
  std::unique_ptr<bus::Subscription> subscription_;
};

RelayService::RelayService(const SiteConfig& site, const RelayConfig& config, bus::Bus& host, bus::Bus& link)
    : site_(site),
      config_(config),
      host_(host),
      link_(link),
      heartbeats_out_(link.writer(topic::kLinkHeartbeat)),
      heartbeats_in_(link.in_order(topic::kLinkHeartbeat)),
      status_(host.writer(topic::kLinkStatus)),
      health_(host, site, "relay"),
      monitor_(site.host, from_seconds(config.heartbeat_timeout_s)) {
  const HostRole role = site.role == "robot" ? HostRole::Robot : HostRole::Laptop;
  const auto scan_beams = static_cast<std::size_t>(config.scan_beams);
  for (const auto& topic : all_topics()) {
    if (site.role == "both") break;  // one host: nothing has to cross
    if (carries(rule_of(topic), role, Crossing::HostToLink)) {
      outward_.push_back(std::make_unique<Route>(topic, Crossing::HostToLink, host, link, scan_beams));
    }
    if (carries(rule_of(topic), role, Crossing::LinkToHost)) {
      inward_.push_back(std::make_unique<Route>(topic, Crossing::LinkToHost, link, host, scan_beams));
    }
  }
  for (const auto* routes : {&outward_, &inward_}) {
    for (const auto& route : *routes) own_.insert(route->writer_id());
  }
  outward_thread_ = std::thread{[this] { pump(host_, outward_); }};
  inward_thread_ = std::thread{[this] { pump(link_, inward_); }};
}

RelayService::~RelayService() {
  ended_ = true;
  outward_thread_.join();
  inward_thread_.join();
}

void RelayService::pump(bus::Bus& from, std::vector<std::unique_ptr<Route>>& routes) {
  while (!ended_) {
    from.wait(std::chrono::milliseconds{100});
    const auto offset = clock_offset();
    for (auto& route : routes) route->forward(from.clock().now(), offset, own_);
  }
}

std::optional<Duration> RelayService::clock_offset() const {
  const std::lock_guard lock{monitor_mutex_};
  return monitor_.clock_offset();
}

void RelayService::step() {
  const Time now = link_.clock().now();
  LinkState state;
  Heartbeat heartbeat;
  {
    const std::lock_guard lock{monitor_mutex_};
    for (const auto& received : heartbeats_in_.take()) {
      if (received.message.contract_hash() != contract_hash()) foreign_contract_ = received.message.host();
      monitor_.heard(from_message(received.message), received.received);
    }
    heartbeat = monitor_.next_heartbeat(now);
    state = monitor_.state(now);
  }
  heartbeats_out_.write(to_message(heartbeat));
  if (site_.role == "both") state.up = true;

  if (state.up != was_up_) {
    spdlog::info("link {}: peer={} heard_age_s={:.2f}", state.up ? "up" : "lost", state.peer, state.heard_age_s);
  }
  if (now >= next_status_ || state.up != was_up_) {
    status_.write(to_message(state, site_.host, now));
    next_status_ = now + kStatusPeriod;
  }
  was_up_ = state.up;

  if (!foreign_contract_.empty()) {
    health_.step(msg::HEALTH_DEGRADED, "host " + foreign_contract_ + " runs another version: install the same on both");
  } else {
    health_.step(state.up ? msg::HEALTH_OK : msg::HEALTH_DEGRADED, state.up ? "" : "no heartbeat from the other host");
  }
}

}  // namespace tandem
