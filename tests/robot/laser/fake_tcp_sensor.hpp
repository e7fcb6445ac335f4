#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <utility>

#include "tests/robot/laser/fake_sensor.hpp"

namespace tandem {

/// A FakeSensor behind a real TCP socket; it lives by being stepped from the test's own thread.
class FakeTcpSensor {
 public:
  FakeTcpSensor() { listen(); }
  ~FakeTcpSensor() { unplug(); }
  FakeTcpSensor(const FakeTcpSensor&) = delete;
  FakeTcpSensor& operator=(const FakeTcpSensor&) = delete;

  FakeSensor sensor;
  bool mute = false;     ///< Hears, but says nothing.
  std::string greeting;  ///< What a new connection gets first.

  [[nodiscard]] std::string device() const { return "tcp://127.0.0.1:" + std::to_string(port_); }

  /// Accepts, answers, and sends one scan if it streams.
  void step() {
    if (listener_ < 0) return;
    if (connection_ < 0 && is_readable(listener_)) {
      connection_ = ::accept(listener_, nullptr, nullptr);
      send(greeting);
    }
    if (connection_ < 0) return;
    if (is_readable(connection_)) {
      std::array<char, 1024> buffer;
      const ssize_t count = ::recv(connection_, buffer.data(), buffer.size(), 0);
      if (count <= 0) return hang_up();
      send(sensor.answer({buffer.data(), static_cast<std::size_t>(count)}));
    }
    timestamp_ms_ = (timestamp_ms_ + 100) & 0xFFFFFF;
    range_mm_ = 2001 - range_mm_;  // 1000 and 1001 in turn: a sensor that is alive
    send(sensor.scan(timestamp_ms_, range_mm_));
  }
  void hang_up() {
    if (connection_ >= 0) ::close(std::exchange(connection_, -1));
  }
  /// Nothing answers at this address any more, until listen().
  void unplug() {
    hang_up();
    if (listener_ >= 0) ::close(std::exchange(listener_, -1));
  }
  void listen() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port_);
    socklen_t size = sizeof address;
    ::bind(listener_, reinterpret_cast<sockaddr*>(&address), size);
    ::listen(listener_, 4);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }

 private:
  static bool is_readable(int descriptor) {
    pollfd watched{.fd = descriptor, .events = POLLIN, .revents = 0};
    return ::poll(&watched, 1, 0) > 0;
  }
  void send(const std::string& bytes) {
    if (!mute && connection_ >= 0 && !bytes.empty()) ::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  int listener_ = -1;
  int connection_ = -1;
  std::uint16_t port_ = 0;
  std::uint32_t range_mm_ = 1000;
  std::uint32_t timestamp_ms_ = 0xFFFF00;  // about to wrap
};

}  // namespace tandem
