#include <spdlog/spdlog.h>

#include <cstdlib>

#include "services/bus/bus_clock.hpp"
#include "services/common/config.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/tracking/tracker_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "tracker", "Follows the teammate and passers-by with the laser.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<tracking::TrackingConfig>(options.config_file());

  bus::Bus bus{bus::host_domain(site, "tracker", options.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  const auto clock = bus::make_clock(options.clock, bus);
  tracking::TrackerService service{config, site, bus, *clock};
  spdlog::info("tracker ready: robot={} domain={}", site.robot, site.host_domain);

  constexpr Duration kLongestWait = std::chrono::milliseconds{50};
  for (const StopSignal stop; !stop.requested(); bus.wait(kLongestWait)) {
    service.step();  // every sample in order: woken by arrivals, not by a beat
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("tracker cannot run: {}", error.what());
  return EXIT_FAILURE;
}
