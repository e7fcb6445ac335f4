#include <spdlog/spdlog.h>

#include <cstdlib>

#include "robot/link/device.hpp"
#include "robot/pioneer/base_service.hpp"
#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options = parse_service_options(
      argc, argv, "base", "Drives a Pioneer (P2OS) through the safety gate and publishes its odometry.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<BaseConfig>(options.config_file());
  static_cast<void>(parse_device(config.device));  // a name that can never be opened is refused now
  const MapZones zones = load_map_zones(config.map.empty() ? "" : options.config_folder / config.map);

  const StopSignal stop;
  bus::Bus bus{bus::host_domain(site, "base")};
  const auto mission = bus::make_clock(options.clock, bus);
  SteadyClock timer;  // wheels keep no mission time
  BaseService service{config, zones, site, bus, timer, *mission};
  spdlog::info("base started: device={} domain={} hard_zones={}", config.device, site.host_domain, zones.areas.size());

  while (!stop.requested()) service.step();  // waits for the device
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("base cannot run: {}", error.what());
  return EXIT_FAILURE;
}
