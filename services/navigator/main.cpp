#include <spdlog/spdlog.h>

#include <cstdlib>

#include "services/bus/bus_clock.hpp"
#include "services/common/config.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/mapping/core/map_zones.hpp"
#include "services/navigator/navigator_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "navigator", "Drives the robot along accepted plans.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<navigator::NavigatorConfig>(options.config_file());

  bus::Bus bus{bus::host_domain(site, "navigator", options.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  const auto clock = bus::make_clock(options.clock, bus);
  const MapZones zones = load_zones_of_host(options.config_folder);
  navigator::NavigatorService service{config, site, zones.areas, bus, *clock};
  spdlog::info("navigator ready: robot={} domain={} hard_zones={}", site.robot, site.host_domain, zones.areas.size());

  const StopSignal stop;
  const auto stopping = [&stop] { return stop.requested(); };
  for (Metronome beat{*clock, from_seconds(config.period_s)}; !stop.requested(); beat.wait(stopping)) {
    service.step();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("navigator cannot run: {}", error.what());
  return EXIT_FAILURE;
}
