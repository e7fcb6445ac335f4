#include <spdlog/spdlog.h>

#include <cstdlib>

#include "robot/laser/laser_service.hpp"
#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "laser", "Reads a Hokuyo or SICK laser and publishes its scans.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<LaserConfig>(options.config_file());

  const StopSignal stop;
  bus::Bus bus{bus::host_domain(site, "laser")};
  const auto mission = bus::make_clock(options.clock, bus);
  SteadyClock timer;  // the device keeps no mission time
  LaserService service{config, site, bus, timer, *mission};
  spdlog::info("laser ready: device={} domain={}", config.device, site.host_domain);

  while (!stop.requested()) service.step();  // waits for the device
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("laser cannot run: {}", error.what());
  return EXIT_FAILURE;
}
