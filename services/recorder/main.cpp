#include <spdlog/spdlog.h>

#include <cstdlib>

#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"
#include "services/recorder/recorder_service.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "recorder", "Records every topic of this host into an MCAP file");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<recorder::RecorderConfig>(options.config_file());

  bus::Bus bus{bus::host_domain(site, "recorder", options.lockstep ? bus::Pace::Lockstep : bus::Pace::RealTime)};
  const Time now = bus.clock().now();
  const std::filesystem::path file = recorder::recording_path(config, now);
  recorder::RecorderService service{config, site, file, recorder::config_attachments(options.config_folder, now), bus};
  spdlog::info("recorder ready: file={} domain={}", file.string(), site.host_domain);

  const StopSignal stop;
  while (!stop.requested()) service.step();
  spdlog::info("recorder ends: {}", service.finish());
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("recorder cannot run: {}", error.what());
  return EXIT_FAILURE;
}
