#pragma once

#include <memory>
#include <optional>
#include <string>

#include "services/bus/bus.hpp"
#include "services/relay/core/map_exchange.hpp"

namespace tandem {

/// Brings the map to a host that has none: compressed, and by its hash, so that nothing is sent to whom has it.
class MapRelay {
 public:
  /// `host_name` says whose holding is whose.
  MapRelay(std::string host_name, Duration patience, bus::Bus& host);
  ~MapRelay();
  MapRelay(const MapRelay&) = delete;
  MapRelay& operator=(const MapRelay&) = delete;

  /// The link was joined, or will be left: its readers and writers are made anew.
  void join(bus::Bus& link);
  void leave();
  /// To be called some times a second.
  void step();

 private:
  struct Link;
  void read_host();
  void give_way_to(const msg::OccupancyGrid& own);  ///< this host's own map server has the say
  void say_what_is_here();
  void send_where_missing();
  void publish_what_came();

  std::string host_name_;
  bus::Bus& host_;
  bus::Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType> maps_;
  /// Once a map from the link was published here.
  std::optional<bus::Writer<msg::OccupancyGrid, msg::OccupancyGridPubSubType>> brought_;
  msg::OccupancyGrid brought_key_;  ///< the newest of them, its key alone
  MapExchange exchange_;
  std::optional<msg::CompressedMap> packed_own_;
  std::unique_ptr<Link> link_;
};

}  // namespace tandem
