#include "services/simulator/wire/pseudo_terminal.hpp"

#include <fcntl.h>
#include <stdlib.h>  // NOLINT: posix_openpt
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "services/simulator/wire/line_rate.hpp"

namespace tandem::simulator {
namespace {

int opened_master(const std::string& config_key) {
  const int descriptor = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (descriptor < 0 || ::grantpt(descriptor) != 0 || ::unlockpt(descriptor) != 0) {
    throw std::runtime_error("cannot open a pseudo terminal: " + std::generic_category().message(errno) +
                             "; is /dev/pts mounted? An empty " + config_key + " in simulator.toml does without");
  }
  return descriptor;
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::filesystem::path& link, const std::string& config_key)
    : link_(link), connection_(opened_master(config_key)) {
  path_ = ::ptsname(connection_.descriptor());
  client_end_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  ::tcgetattr(client_end_, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(client_end_, TCSANOW, &settings);
  std::error_code error;
  if (std::filesystem::is_symlink(link_, error)) std::filesystem::remove(link_, error);
  std::filesystem::create_symlink(path_, link_, error);
  if (error) {
    ::close(client_end_);
    throw std::runtime_error("cannot make the link " + link_.string() + " to " + path_ + ": " + error.message() +
                             "; see " + config_key + " in simulator.toml");
  }
}

PseudoTerminal::~PseudoTerminal() {
  ::close(client_end_);
  std::error_code error;
  if (std::filesystem::read_symlink(link_, error) == path_) std::filesystem::remove(link_, error);
}

int PseudoTerminal::line_rate() const {
  return simulator::line_rate(client_end_);
}

}  // namespace tandem::simulator
