#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace tandem {

/// An IP camera that shows one JPEG twenty times a second, on a thread of its own: who opens it waits for its answer.
class MjpegServer {
 public:
  /// Port 0: a free one.
  explicit MjpegServer(std::vector<std::uint8_t> jpeg, std::uint16_t port = 0)
      : jpeg_(std::move(jpeg)), listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int on = 1;
    ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    socklen_t size = sizeof address;
    ::bind(listener_, reinterpret_cast<sockaddr*>(&address), size);
    ::listen(listener_, 4);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread{[this] { serve(); }};
  }
  ~MjpegServer() {
    ended_ = true;
    thread_.join();
    ::close(listener_);
  }
  MjpegServer(const MjpegServer&) = delete;
  MjpegServer& operator=(const MjpegServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string address() const { return "http://127.0.0.1:" + std::to_string(port_) + "/stream.mjpeg"; }

 private:
  void serve() {
    while (!ended_) {
      pollfd watched{.fd = listener_, .events = POLLIN, .revents = 0};
      if (::poll(&watched, 1, 20) <= 0) continue;
      const int connection = ::accept(listener_, nullptr, nullptr);
      bool is_open = send(connection, "HTTP/1.1 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=b\r\n\r\n");
      const std::string picture = "--b\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(jpeg_.size()) +
                                  "\r\n\r\n" + std::string(jpeg_.begin(), jpeg_.end()) + "\r\n";
      while (is_open && !ended_) {
        is_open = send(connection, picture);
        ::poll(nullptr, 0, 50);  // its period
      }
      ::close(connection);
    }
  }
  static bool send(int connection, const std::string& bytes) {
    return ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
  }

  std::vector<std::uint8_t> jpeg_;
  int listener_;
  std::uint16_t port_ = 0;
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

}  // namespace tandem
