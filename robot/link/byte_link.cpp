#include "robot/link/byte_link.hpp"

#include <fcntl.h>
#include <libserialport.h>
#include <linux/serial.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "robot/link/device.hpp"
#include "robot/link/line_rate.hpp"

namespace tandem {
namespace {

constexpr Duration kWriteTimeout = from_seconds(0.2);

/// Waits for `events` on the descriptor; true when something is to be said about it, also an error.
bool wait_for(int descriptor, short events, Duration timeout) {
  pollfd watched{.fd = descriptor, .events = events, .revents = 0};
  const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(timeout).count();
  return ::poll(&watched, 1, static_cast<int>(milliseconds)) > 0;
}

std::string why(int error) {
  switch (error) {
    case ECONNREFUSED:
      return "connection refused: is the device (or the simulator) running, and is the port right?";
    case ETIMEDOUT:
    case EHOSTUNREACH:
    case ENETUNREACH:
      return "no answer: check power, cable and address";
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return "no such device: is it plugged in and switched on?";
    case EACCES:
    case EPERM:
      return "permission denied: add the user to group dialout";
    case EBUSY:
      return "in use by another program";
    default:
      return std::strerror(error);
  }
}

OpenedLink not_opened(const std::string& name, const std::string& reason) {
  return {{}, name + ": " + reason};
}

/// 0, or the error number of a connect that failed or took longer than `timeout`.
int connect_within(int descriptor, const addrinfo& address, Duration timeout) {
  if (::connect(descriptor, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!wait_for(descriptor, POLLOUT, timeout)) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

OpenedLink open_tcp(const std::string& name, const TcpDevice& device, Duration timeout) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = ::getaddrinfo(device.host.c_str(), std::to_string(device.port).c_str(), &hints, &found);
      error != 0) {
    return not_opened(name, std::string{"host not found: "} + ::gai_strerror(error));
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses{found, ::freeaddrinfo};
  int error = EHOSTUNREACH;
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    ByteLink link{::socket(address->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0), name};
    if (!link.is_open()) continue;
    error = connect_within(link.descriptor(), *address, timeout);
    if (error != 0) continue;
    const int on = 1;  // a request is a few bytes and must not wait for more
    ::setsockopt(link.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return {std::move(link), {}};
  }
  return not_opened(name, why(error));
}

/// libserialport knows only ports with hardware; a pseudo-terminal needs no more than to be raw. Its other end sees the
/// rate, and a simulated device may mind it.
OpenedLink open_pseudo_terminal(const std::string& name, const std::string& path, int baud_rate) {
  ByteLink link{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC), name};
  if (!link.is_open()) return not_opened(name, why(errno));
  termios settings{};
  if (::tcgetattr(link.descriptor(), &settings) != 0) return not_opened(name, why(errno));
  ::cfmakeraw(&settings);
  if (::tcsetattr(link.descriptor(), TCSANOW, &settings) != 0) return not_opened(name, why(errno));
  link.set_baud_rate(baud_rate);
  return {std::move(link), {}};
}

/// Only libserialport's own handle: freeing it leaves the descriptor open.
using SerialPort = std::unique_ptr<sp_port, void (*)(sp_port*)>;

/// USB adapters hold bytes back for up to 16 ms unless they are told not to; one that cannot be told is as good.
void answer_at_once(int descriptor) {
  serial_struct settings{};
  if (::ioctl(descriptor, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  ::ioctl(descriptor, TIOCSSERIAL, &settings);
}

OpenedLink open_serial(const std::string& name, const std::string& path, int baud_rate) {
  sp_port* found = nullptr;
  if (sp_get_port_by_name(path.c_str(), &found) != SP_OK) return not_opened(name, "not a serial port");
  const SerialPort port{found, sp_free_port};
  if (sp_open(port.get(), SP_MODE_READ_WRITE) != SP_OK) return not_opened(name, why(sp_last_error_code()));
  int descriptor = -1;
  sp_get_port_handle(port.get(), &descriptor);
  ByteLink link{descriptor, name};
  ::ioctl(descriptor, TIOCEXCL);
  answer_at_once(descriptor);
  if (sp_set_bits(port.get(), 8) != SP_OK || sp_set_parity(port.get(), SP_PARITY_NONE) != SP_OK ||
      sp_set_stopbits(port.get(), 1) != SP_OK || sp_set_flowcontrol(port.get(), SP_FLOWCONTROL_NONE) != SP_OK ||
      sp_set_baudrate(port.get(), baud_rate) != SP_OK) {
    return not_opened(name, "cannot be set to " + std::to_string(baud_rate) + " baud");
  }
  return {std::move(link), {}};
}

bool is_pseudo_terminal(const std::string& path) {
  return path.starts_with("/dev/pts/");
}

}  // namespace

ByteLink::ByteLink(ByteLink&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      name_(std::move(other.name_)),
      failure_(std::move(other.failure_)) {}

ByteLink& ByteLink::operator=(ByteLink&& other) noexcept {
  if (this != &other) {
    close();
    descriptor_ = std::exchange(other.descriptor_, -1);
    name_ = std::move(other.name_);
    failure_ = std::move(other.failure_);
  }
  return *this;
}

void ByteLink::close() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

void ByteLink::lose(const std::string& reason) {
  close();
  failure_ = name_ + ": " + reason;
}

std::vector<std::uint8_t> ByteLink::read(Duration timeout) {
  if (!is_open() || !wait_for(descriptor_, POLLIN, timeout)) return {};
  std::vector<std::uint8_t> all;
  std::array<std::uint8_t, 4096> part;
  constexpr std::size_t kMost = 65'536;  // a device that never stops must not keep us here
  while (all.size() < kMost) {
    const ssize_t count = ::read(descriptor_, part.data(), part.size());
    if (count > 0) {
      all.insert(all.end(), part.begin(), part.begin() + count);
      continue;
    }
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) break;
    lose(count == 0 ? "closed by the other side" : why(errno));  // what came before the end is still given
    break;
  }
  return all;
}

bool ByteLink::write(std::span<const std::uint8_t> bytes) {
  while (is_open() && !bytes.empty()) {
    ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
      lose(errno == EPIPE ? "closed by the other side" : why(errno));
    } else if (!wait_for(descriptor_, POLLOUT, kWriteTimeout)) {
      lose("takes no bytes");
    }
  }
  return is_open();
}

bool ByteLink::write(std::string_view text) {
  return write(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void ByteLink::set_baud_rate(int baud_rate) {
  if (is_open() && ::isatty(descriptor_) != 0 && !set_line_rate(descriptor_, baud_rate)) {
    lose("cannot be set to " + std::to_string(baud_rate) + " baud");
  }
}

OpenedLink open_byte_link(const std::string& device_name, const LinkOptions& options) {
  const Device device = parse_device(device_name);
  if (const auto* tcp = std::get_if<TcpDevice>(&device)) return open_tcp(device_name, *tcp, options.connect_timeout);
  std::error_code none;
  const std::string path = std::filesystem::canonical(std::get<SerialDevice>(device).path, none).string();
  if (none) return not_opened(device_name, why(none.value()));
  if (is_pseudo_terminal(path)) return open_pseudo_terminal(device_name, path, options.baud_rate);
  return open_serial(device_name, path, options.baud_rate);
}

}  // namespace tandem
