#pragma once

#include <string>

#include "services/common/time.hpp"

namespace tandem {

/// What the service manager (systemd, sd_notify(3)) is told of this process: that it is ready, that it still turns, and
/// how it is. Nothing happens where no manager asked for it.
class ServiceManager {
 public:
  /// From the service's own loop, some times a second, so that a loop that hangs falls silent and the manager's
  /// watchdog ends the process. `ready` may wait for hardware; once said, it stays said. `status` is for people.
  void step(bool ready, const std::string& status, Time now);

 private:
  Time next_sign_{};
  bool ready_ = false;
  std::string status_;
};

}  // namespace tandem
