#include <spdlog/spdlog.h>

#include <cstdlib>
#include <exception>
#include <iostream>

#include "gateway/server/gateway_service.hpp"
#include "gateway/server/qr_code.hpp"
#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"

using namespace tandem;

int main(int argc, char** argv) try {
  const ServiceOptions options = parse_service_options(
      argc, argv, "gateway", "Serves the phone page and carries messages between phones and robot");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<gateway::GatewayConfig>(options.config_file());

  bus::Bus bus{bus::host_domain(site, "gateway")};
  const auto mission_clock = bus::make_clock(options.clock, bus);
  SteadyClock machine_clock;
  gateway::GatewayService service{config, site, bus, *mission_clock, machine_clock};
  spdlog::info("gateway ready: port={} domain={}", service.port(), site.host_domain);
  if (config.print_qr_code) {
    std::cout << gateway::qr_code(service.participant_link()) << service.participant_link() << "\n"
              << "Scan it with the phone, or open the link. It works once, for five minutes.\n"
              << std::flush;
  }

  const StopSignal stop;
  for (Metronome beat{machine_clock, from_seconds(0.05)}; !stop.requested();
       beat.wait([&] { return stop.requested(); })) {
    service.step();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("gateway cannot run: {}", error.what());
  return EXIT_FAILURE;
}
