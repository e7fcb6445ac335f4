#include <spdlog/spdlog.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "robot/link/byte_link.hpp"
#include "robot/link/device.hpp"
#include "robot/pioneer/base_config.hpp"
#include "robot/pioneer/core/standstill.hpp"
#include "services/common/service_options.hpp"

// What the service manager runs when tandem-base has died: it can no longer stop the wheels, and the controller's own
// watchdog may take two seconds.
int main(int argc, char** argv) try {
  using namespace tandem;
  const ServiceOptions options = parse_service_options(
      argc, argv, "base-stop", "Makes the robot's controller stand still, in place of a tandem-base that has died.");
  const auto config = load_config<BaseConfig>(options.config_folder / "base.toml");

  // The rate that was in use is not known; at a wrong one the bytes are noise, which the controller drops.
  const bool is_serial = std::holds_alternative<SerialDevice>(parse_device(config.device));
  const std::vector<double> rates = is_serial ? config.baud_rates : std::vector{0.0};
  bool sent = false;
  std::string failure;
  for (const double rate : rates) {
    LinkOptions line;
    line.baud_rate = static_cast<int>(rate);
    line.connect_timeout = std::chrono::milliseconds{100};
    auto opened = open_byte_link(config.device, line);
    if (opened.link && opened.link->write(pioneer::standstill_commands())) {
      opened.link->set_baud_rate(line.baud_rate);  // returns once all bytes are out
      sent = true;
    } else {
      failure = opened.link ? opened.link->failure() : opened.failure;
    }
  }
  if (!sent) throw std::runtime_error(failure);
  spdlog::warn("told the controller at {} to stand still", config.device);
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  spdlog::critical("base-stop cannot stop the robot: {}; its firmware's watchdog does", error.what());
  return EXIT_FAILURE;
}
