#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

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
  /// That another host's map is not this host's, and what to do; empty while they agree.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  struct Link;
  void read_host();
  void give_way_to(const msg::OccupancyGrid& own);  ///< this host's own map server has the say
  void say_what_is_here();
  [[nodiscard]] std::vector<HeldMap> maps_of_others() const;
  void send_where_missing(const std::vector<HeldMap>& others);
  void compare(const std::vector<HeldMap>& others);
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
  std::string trouble_;
};

}  // namespace tandem
