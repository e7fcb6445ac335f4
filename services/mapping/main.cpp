#include <spdlog/spdlog.h>

#include <cstdlib>

#include "services/common/clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/mapping/map_server_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "map-server", "Publishes the map of this host, and refuses a wrong one.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<MapServerConfig>(options.config_file());

  const StopSignal stop;
  bus::Bus bus{bus::host_domain(site, "map-server", options.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  MapServerService service{config, options.config_folder, site, bus};

  SteadyClock clock;  // a map has no mission time
  for (Metronome beat{clock, std::chrono::seconds{1}}; !stop.requested(); beat.wait([&] { return stop.requested(); })) {
    service.step();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("map-server cannot run: {}", error.what());
  return EXIT_FAILURE;
}
