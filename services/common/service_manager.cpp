#include "services/common/service_manager.hpp"

#include <systemd/sd-daemon.h>

namespace tandem {
namespace {

/// Well within the shortest watchdog of our units, one second.
constexpr Duration kSignPeriod = std::chrono::milliseconds{200};

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

void ServiceManager::step(bool ready, const std::string& status, Time now) {
  std::string notice;
  if (ready && !ready_) {
    ready_ = true;
    notice += "READY=1\n";
  }
  if (now >= next_sign_) {
    next_sign_ = now + kSignPeriod;
    notice += "WATCHDOG=1\n";
  }
  if (status != status_) {
    status_ = status;
    notice += "STATUS=" + one_line(status) + "\n";
  }
  if (!notice.empty()) sd_notify(0, notice.c_str());
}

}  // namespace tandem
