#include <spdlog/spdlog.h>

#include <cstdlib>

#include "robot/camera/camera_service.hpp"
#include "services/bus/bus_clock.hpp"
#include "services/common/service_options.hpp"
#include "services/common/stop_signal.hpp"

int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options =
      parse_service_options(argc, argv, "camera", "Finds the searched objects in the robot's camera pictures.");
  const auto site = load_config<SiteConfig>(options.site_file());
  const auto config = load_config<CameraConfig>(options.config_file());

  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);  // quiet: what FFmpeg meets is said by us, once
  const StopSignal stop;
  bus::Bus bus{bus::host_domain(site, "camera")};
  const auto mission = bus::make_clock(options.clock, bus);
  SteadyClock timer;  // the camera keeps no mission time
  CameraService service{config, site, bus, timer, *mission};
  spdlog::info("camera ready: source={} domain={}", config.source, site.host_domain);

  while (!stop.requested()) service.step();  // waits for the camera
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("camera cannot run: {}", error.what());
  return EXIT_FAILURE;
}
