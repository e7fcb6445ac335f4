#include "services/mapping/map_server_service.hpp"

#include <spdlog/spdlog.h>

#include "services/mapping/core/map_file.hpp"
#include "services/mapping/map_messages.hpp"

namespace tandem {

MapServerService::MapServerService(const MapServerConfig& config, const std::filesystem::path& config_folder,
                                   const SiteConfig& site, bus::Bus& bus)
    : maps_(bus.writer(topic::kMap)), health_(bus, site, "map-server") {
  const std::filesystem::path file = config_folder / config.map;  // an absolute path stands for itself
  const OccupancyGrid grid = load_map(file, config.max_cells);
  const msg::OccupancyGrid message = to_message(grid, map_id_of(file));
  maps_.write(message);
  spdlog::info("map published: id={} sha256={} cells={}x{} resolution_m={}", message.map_id(), message.sha256(),
               grid.width(), grid.height(), grid.resolution_m());
}

void MapServerService::step() {
  health_.step(msg::HEALTH_OK);
}

}  // namespace tandem
