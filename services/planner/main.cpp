#include <spdlog/spdlog.h>

#include <cstdlib>
#include <exception>

#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/planner/planner_service.hpp"

namespace {
constexpr int kSecondPlanner = 3;
constexpr auto kBeat = std::chrono::milliseconds{50};
constexpr auto kListen = std::chrono::milliseconds{1500};
}  // namespace

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "planner", "Plans the common search of a robot and a person.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<PlannerConfig>(options.config_file());
  const StopSignal stop;  // SIGINT, SIGTERM

  bus::Bus bus{bus::host_domain(site, "planner", options.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  const auto clock = bus::make_clock(options.clock, bus);
  if (const std::string refusal = other_planner(site, bus, kListen); !refusal.empty()) {
    spdlog::critical("planner cannot run: {}", refusal);
    return kSecondPlanner;
  }
  const MapZones zones = load_zones_of_host(options.config_folder);
  PlannerService service{config, site, zones, bus, *clock};
  spdlog::info("planner ready: config={} domain={} seed={} hard_zones={}", options.config_file().string(),
               site.host_domain, config.seed, zones.areas.size());

  const auto stopped = [&stop] { return stop.requested(); };
  for (Metronome beat{*clock, kBeat}; !stop.requested(); beat.wait(stopped)) {
    service.step();
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("planner cannot run: {}", error.what());
  return EXIT_FAILURE;
}
