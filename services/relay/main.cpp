#include <spdlog/spdlog.h>

#include <cstdlib>

#include "services/common/clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/relay/relay_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "relay", "Joins this host's services to the other host over the link");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<RelayConfig>(options.config_file());

  bus::Bus host{bus::host_domain(site, "relay")};
  RelayService service{site, config, host};
  spdlog::info("relay ready: host={} role={} host_domain={} link_domain={} link_address={}", site.host, site.role,
               site.host_domain, site.link_domain, site.link_address);

  const StopSignal stop;
  SteadyClock clock;
  for (Metronome beat{clock, from_seconds(config.heartbeat_period_s)}; !stop.requested();) {
    service.step();
    beat.wait([&] { return stop.requested(); });
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("cannot run: {}", error.what());
  return EXIT_FAILURE;
}
