#include "services/cli/teleop/gamepad.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace tandem::cli {

Gamepad::Gamepad(std::string device)
    : descriptor_(open(device.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)), name_(std::move(device)) {
  if (descriptor_ < 0) {
    throw std::runtime_error(name_ + ": " + std::strerror(errno) +
                             "; is the gamepad plugged in, and is this user in the group input?");
  }
  std::array<char, 80> called{};
  if (ioctl(descriptor_, JSIOCGNAME(called.size() - 1), called.data()) > 0) name_ = called.data();
}

Gamepad::~Gamepad() {
  close(descriptor_);
}

std::vector<js_event> Gamepad::events() {
  std::vector<js_event> all;
  js_event event{};
  while (is_there_) {
    const ssize_t count = read(descriptor_, &event, sizeof event);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) break;
    is_there_ = count == sizeof event;
    if (is_there_) all.push_back(event);
  }
  return all;
}

}  // namespace tandem::cli
