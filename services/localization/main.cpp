#include <spdlog/spdlog.h>

#include <cstdlib>

#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/localization/localization_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "localization", "Finds the robot on the map by odometry and laser.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<LocalizationConfig>(options.config_file());

  const StopSignal stop;
  bus::Bus bus{bus::host_domain(site, "localization", options.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  const auto clock = bus::make_clock(options.clock, bus);
  LocalizationService service{config, site, bus, *clock};
  spdlog::info("localization ready: config={} domain={} seed={}", options.config_file().string(), site.host_domain,
               config.seed);

  while (!stop.requested()) {
    service.step();
    bus.wait(std::chrono::milliseconds{50});  // a scan is worked on as soon as it comes
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("localization cannot run: {}", error.what());
  return EXIT_FAILURE;
}
