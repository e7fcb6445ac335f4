#include "services/relay/relay_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "services/common/format.hpp"
#include "services/common/version.hpp"
#include "services/relay/link_security.hpp"
#include "services/relay/relay_messages.hpp"

namespace tandem {
namespace {

constexpr Duration kStatusPeriod = std::chrono::milliseconds{500};
constexpr Duration kLookPeriod = std::chrono::seconds{1};
constexpr int kDaysToWarn = 21;
constexpr Duration kStrangerNamed = std::chrono::seconds{3};

/// Security does not go with a discovery server: Fast DDS would join, and exchange nothing.
void refuse_secured_server(const SiteConfig& site) {
  if (!site.secure_link || site.discovery != "server") return;
  throw ConfigError(
      "site.toml: secure_link does not go with discovery = \"server\": Fast DDS 2.9 secures no discovery server. Use "
      "\"auto\", \"peers\" or \"multicast\"");
}

void warn_before_the_end(const SiteConfig& site) {
  if (!site.secure_link) return;
  const int left = days_left(site, wall_time());
  if (left < kDaysToWarn) spdlog::warn("security files end soon: days={} folder={}", left, site.security_folder);
}

}  // namespace

bus::DomainOptions link_domain(const SiteConfig& site, const RelayConfig& config, const std::string& address) {
  bus::DomainOptions options;
  options.kind = bus::DomainOptions::Kind::Link;
  options.domain = static_cast<int>(site.link_domain);
  options.participant = "relay@" + site.host;
  options.address = address;
  options.discovery = bus::discovery_of(site.discovery);
  options.peers = site.peers;
  options.servers = site.servers;
  options.partitions = {site.robot};
  options.bulk_rate_bps = config.bulk_rate_bps;
  if (site.secure_link) options.security = security_files_in(site.security_folder);
  return options;
}

RelayService::RelayService(const SiteConfig& site, const RelayConfig& config, bus::Bus& host)
    : site_(site),
      config_(config),
      host_(host),
      status_(host.writer(topic::kLinkStatus)),
      health_(host, site, "relay"),
      monitor_(site.host, from_seconds(config.heartbeat_timeout_s)),
      maps_(site.host, from_seconds(config.map_patience_s), host) {
  if (is_alone()) return;
  refuse_secured_server(site);
  for (const auto& topic : topics_by_urgency()) {
    if (!carries(rule_of(topic), role_of(site), Crossing::LinkToHost)) continue;
    inward_.push_back({topic, host.raw_writer(topic), {}});
  }
  follow_address();
}

bool RelayService::is_alone() const {
  return site_.role == "both";
}

void RelayService::follow_address() {
  const std::optional<std::string> in_use = link_ ? std::optional{link_->address()} : std::nullopt;
  const auto address = link_address(site_.link_address, AddressWatcher::addresses(), in_use);
  if (!address) {
    // A link whose address is gone is kept: when the same address comes back, it goes on.
    if (!link_) set_trouble("waiting for the link", "no address at " + site_.link_address);
    return;
  }
  if (address != in_use) join_link(*address);
}

void RelayService::join_link(const std::string& address) {
  if (link_ && link_->address() != address) {
    spdlog::info("address of the link changes: old={} new={}", link_->address(), address);
  }
  maps_.leave();
  link_.reset();  // first: two participants of one host would each send everything
  try {
    if (const auto trouble = security_trouble(site_, wall_time()); !trouble.empty()) throw std::runtime_error(trouble);
    link_ = std::make_unique<LinkSide>(link_domain(site_, config_, address), role_of(site_), config_, host_, inward_,
                                       [this] { return clock_offset(); });
    maps_.join(link_->bus());
    trouble_.clear();
    spdlog::info("link joined: address={} domain={} discovery={} secured={}", address, site_.link_domain,
                 site_.discovery, site_.secure_link);
    warn_before_the_end(site_);
  } catch (const std::runtime_error& error) {  // the address may have gone again meanwhile, the clock may be set later
    link_.reset();
    set_trouble("link not joined", error.what());
  }
}

void RelayService::set_trouble(const char* what, const std::string& trouble) {
  if (trouble != trouble_) spdlog::warn("{}: {}", what, trouble);
  trouble_ = trouble;
}

void RelayService::look_for_refused() {
  std::string refused;
  if (link_) {
    for (const auto& peer : link_->bus().refused_peers()) {
      refused += formatted("%sno exchange with \"%s\": %s", refused.empty() ? "" : "; ", peer.name.c_str(),
                           peer.reason.c_str());
    }
  }
  if (!refused.empty() && refused != refused_) spdlog::warn("{}", refused);
  refused_ = refused;
}

void RelayService::mend_torn_link(bool is_up, Time now) {
  if (!link_ || is_alone()) return;
  const std::vector<std::string> unmatched = link_->unmatched();
  // A stranger is found as well, but does not count as silent: it is heard, and named.
  if (!torn_.add(now, {is_up, link_->finds_other() && !hears_strangers(now), unmatched.size()})) return;
  if (is_up) {
    std::string topics;
    for (const std::string& topic : unmatched) topics += (topics.empty() ? "" : ",") + topic;
    spdlog::warn("link joined anew: the other host is heard, but not found on all topics: unmatched={}", topics);
  } else {
    spdlog::warn("link joined anew: the other host's relay is announced, but its heartbeats do not come");
  }
  join_link(std::string{link_->address()});
}

bool RelayService::hears_strangers(Time now) const {
  return std::any_of(strangers_.begin(), strangers_.end(),
                     [&](const auto& stranger) { return now - stranger.second.heard <= kStrangerNamed; });
}

std::optional<Duration> RelayService::clock_offset() const {
  const std::lock_guard lock{monitor_mutex_};
  return monitor_.clock_offset();
}

void RelayService::step() {
  const Time now = host_.clock().now();
  if (!is_alone() && (watcher_.changed() || (!link_ && now >= next_look_))) {
    follow_address();
    next_look_ = now + kLookPeriod;
  }
  if (now >= next_refused_) {
    look_for_refused();
    next_refused_ = now + kLookPeriod;
  }
  const LinkState state = exchange_heartbeats(now);
  mend_torn_link(state.up, now);
  tell_host(state, now);
  maps_.step();
}

LinkState RelayService::exchange_heartbeats(Time now) {
  const std::lock_guard lock{monitor_mutex_};
  if (link_) {
    for (const auto& received : link_->heartbeats()) {
      if (is_of_our_peer(received)) monitor_.heard(from_message(received.message), received.received);
    }
    link_->send(to_message(monitor_.next_heartbeat(now), site_.role));
  }
  LinkState state = monitor_.state(now);
  if (is_alone()) state.up = true;
  return state;
}

bool RelayService::is_of_our_peer(const bus::Received<msg::LinkHeartbeat>& heartbeat) {
  const auto& message = heartbeat.message;
  const auto is_stranger = [&](bus::PeerFault fault) {
    strangers_[message.host()] = {std::move(fault), heartbeat.received};
    return false;
  };
  if (message.host() == site_.host) {
    return is_stranger(
        {"X6", "another host on the link is called " + site_.host + " too: give each its own host in site.toml"});
  }
  if (message.role() == site_.role) {
    return is_stranger({site_.role == "robot" ? "X6" : "X5",
                        "host " + message.host() + " on the link is a " + site_.role + " of " + site_.robot +
                            " too: give each robot its own name, and one laptop, in site.toml"});
  }
  if (const auto rival = seat_.rival_of(message.host(), heartbeat.received)) {
    const auto& [first, second] = std::minmax(message.host(), *rival);
    return is_stranger({message.role() == "robot" ? "X6" : "X5", "hosts " + first + " and " + second +
                                                                     " on the link are both a " + message.role() +
                                                                     " of " + site_.robot + ": end one"});
  }
  const bool our_contract = message.contract_hash() == contract_hash();
  link_->understand(our_contract);
  if (our_contract) return true;
  return is_stranger(bus::other_contract("host " + message.host(), "", message.contract_hash(), contract_hash()));
}

std::vector<bus::PeerFault> RelayService::link_faults(Time now) const {
  if (!link_) return {};
  auto faults = link_->bus().peer_faults();
  for (const auto& [host, stranger] : strangers_) {
    if (now - stranger.heard <= kStrangerNamed) faults.push_back(stranger.fault);
  }
  return faults;
}

void RelayService::tell_host(const LinkState& state, Time now) {
  if (state.up != was_up_) {
    spdlog::info("link {}: peer={} heard_age_s={:.2f}", state.up ? "up" : "lost", state.peer, state.heard_age_s);
  }
  if (now >= next_status_ || state.up != was_up_) {
    status_.write(to_message(state, site_.host, now));
    next_status_ = now + kStatusPeriod;
  }
  was_up_ = state.up;

  if (!trouble_.empty()) {
    health_.step(msg::HEALTH_DEGRADED, trouble_);
    return;
  }
  std::string reason = state.up ? "" : "no heartbeat from the other host";
  for (const std::string& more : {refused_, maps_.trouble()})
    reason += (reason.empty() || more.empty() ? "" : "; ") + more;
  health_.step(state.up && maps_.trouble().empty() ? msg::HEALTH_OK : msg::HEALTH_DEGRADED, reason, link_faults(now));
}

}  // namespace tandem
