#include "services/relay/map_relay.hpp"

#include <spdlog/spdlog.h>

#include "services/common/format.hpp"
#include "services/relay/relay_messages.hpp"

namespace tandem {

struct MapRelay::Link {
  bus::Writer<msg::MapHolding, msg::MapHoldingPubSubType> holding_out;
  bus::Latest<msg::MapHolding, msg::MapHoldingPubSubType> holdings_in;
  bus::Writer<msg::CompressedMap, msg::CompressedMapPubSubType> maps_out;
  bus::InOrder<msg::CompressedMap, msg::CompressedMapPubSubType> maps_in;
  std::optional<std::string> said;  // the holding that was announced
  bool sent = false;                // our own map lies on the link

  explicit Link(bus::Bus& bus)
      : holding_out(bus.writer(topic::kMapHolding)),
        holdings_in(bus.latest(topic::kMapHolding)),
        maps_out(bus.writer(topic::kCompressedMap)),
        maps_in(bus.in_order(topic::kCompressedMap, 4)) {}
};

MapRelay::MapRelay(std::string host_name, Duration patience, bus::Bus& host)
    : host_name_(std::move(host_name)),
      host_(host),
      maps_(host.latest(topic::kMap)),
      exchange_(host.clock().now(), patience) {}

MapRelay::~MapRelay() = default;

void MapRelay::join(bus::Bus& link) {
  link_ = std::make_unique<Link>(link);
}

void MapRelay::leave() {
  link_.reset();
  trouble_.clear();
}

void MapRelay::step() {
  read_host();
  if (!link_) return;
  say_what_is_here();
  const auto others = maps_of_others();
  send_where_missing(others);
  compare(others);
  publish_what_came();
}

void MapRelay::read_host() {
  const auto received = maps_.take_new();
  if (!received || (brought_ && received->writer == brought_->raw().id())) return;
  give_way_to(received->message);
  packed_own_ = packed(received->message);
  exchange_.own_is(received->message.sha256());
  if (link_) link_->sent = false;
}

void MapRelay::give_way_to(const msg::OccupancyGrid& own) {
  if (!brought_) return;
  // The writer stays: what it says now must still reach its readers.
  if (brought_key_.map_id() == own.map_id()) {
    brought_->write(own);
  } else {
    brought_->dispose(brought_key_);
  }
}

void MapRelay::say_what_is_here() {
  const auto holding = exchange_.holding(host_.clock().now());
  if (!holding || holding == link_->said) return;
  msg::MapHolding message;
  message.host(host_name_);
  message.sha256(*holding);
  link_->holding_out.write(message);
  link_->said = holding;
}

std::vector<HeldMap> MapRelay::maps_of_others() const {
  std::vector<HeldMap> others;
  for (const auto& received : link_->holdings_in.each()) {
    const auto& held = received.message;
    if (received.writer_alive && held.host() != host_name_) others.push_back({held.host(), held.sha256()});
  }
  return others;
}

void MapRelay::compare(const std::vector<HeldMap>& others) {
  const Time now = host_.clock().now();
  const auto other = exchange_.other_map(others, now);
  if (!other) {
    trouble_.clear();
    return;
  }
  constexpr std::size_t kEnough = 8;  // digits of a hash, to tell two maps apart
  trouble_ = formatted("the map of this host (sha256 %s) is not that of %s (%s): give both the same map file",
                       exchange_.holding(now)->substr(0, kEnough).c_str(), other->host.c_str(),
                       other->sha256.substr(0, kEnough).c_str());
}

void MapRelay::send_where_missing(const std::vector<HeldMap>& others) {
  const bool asked_for = exchange_.is_asked_for(others);
  if (asked_for && !link_->sent) {
    link_->maps_out.write(*packed_own_);
    spdlog::info("map sent over the link: id={} sha256={} bytes={}", packed_own_->map_id(), packed_own_->sha256(),
                 packed_own_->zstd_cells().size());
  } else if (!asked_for && link_->sent) {
    link_->maps_out.dispose(*packed_own_);  // who comes later asks for himself
  }
  link_->sent = asked_for;
}

void MapRelay::publish_what_came() {
  for (const auto& received : link_->maps_in.take()) {
    const auto& came = received.message;
    if (!exchange_.is_welcome(came.sha256())) continue;
    const auto grid = unpacked(came);
    if (!grid) {
      spdlog::warn("map from the link dropped, its cells do not fit its hash: id={} sha256={}", came.map_id(),
                   came.sha256());
      continue;
    }
    if (!brought_) brought_.emplace(host_.writer(topic::kMap));
    brought_->write(*grid);
    brought_key_.map_id(came.map_id());
    exchange_.brought_is(came.sha256());
    spdlog::info("map published from the link: id={} sha256={}", came.map_id(), came.sha256());
  }
}

}  // namespace tandem
