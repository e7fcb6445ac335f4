#pragma once

#include <filesystem>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/mapping/core/map_server_config.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// Publishes one map, for readers now and later.
class MapServerService {
 public:
  /// Loads and publishes the map; a relative path counts from `config_folder`. Throws MapError if it is a wrong one.
  MapServerService(const MapServerConfig& config, const std::filesystem::path& config_folder, const SiteConfig& site,
                   bus::Bus& bus);

  /// Says that it is there.
  void step();

 private:
  bus::Writer<msg::OccupancyGrid, msg::OccupancyGridPubSubType> maps_;
  bus::HealthReporter health_;
};

}  // namespace tandem
