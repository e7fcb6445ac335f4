#include "services/common/stop_signal.hpp"

#include <csignal>

namespace tandem {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

void remember(int) {
  stop_requested = 1;
}

}  // namespace

StopSignal::StopSignal() {
  struct sigaction action {};
  action.sa_handler = remember;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction hang_up {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // ignored: under nohup
  std::signal(SIGPIPE, SIG_IGN);  // a closed socket is everyday life, reported by write()
}

bool StopSignal::requested() const {
  return stop_requested != 0;
}

}  // namespace tandem
