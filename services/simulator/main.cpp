#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdlib>

#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/simulator/simulator_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "simulator",
                            "A simulated world behind the real protocols: P2OS base, SCIP lidar, MJPEG camera, phone");
  const auto config = load_config<simulator::SimulatorConfig>(options.config_file());
  const auto site = load_config<SiteConfig>(options.site_file());
  std::signal(SIGPIPE, SIG_IGN);  // a client that leaves is everyday life

  bus::Bus bus{bus::host_domain(site, "simulator")};
  const auto clock = bus::make_clock(options.clock, bus);
  simulator::SimulatorService service{config, site, bus, *clock};
  spdlog::info("simulator ready: {} domain={}", service.description(), site.host_domain);

  const StopSignal stop;
  while (!stop.requested()) service.step();
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("simulator cannot run: {}", error.what());
  return EXIT_FAILURE;
}
