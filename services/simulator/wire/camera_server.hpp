#pragma once

#include <string>
#include <vector>

#include "services/simulator/core/simulation.hpp"
#include "services/simulator/wire/tcp_listener.hpp"

namespace tandem::simulator {

/// The simulated camera as an IP camera: MJPEG over HTTP at /stream.mjpeg. Draws only while somebody watches.
class CameraServer {
 public:
  CameraServer(const std::string& address, std::uint16_t port, Duration period, Time now);

  void receive();
  /// Sends the next picture if it is due; a client that has not taken the last one misses it.
  void step(const Simulation& simulation, Time now);
  void add_descriptors(std::vector<int>& descriptors) const;
  [[nodiscard]] std::uint16_t port() const { return listener_.port(); }

 private:
  struct Client {
    Connection connection;
    std::string request;  ///< What has come of its HTTP request.
    bool watching = false;
  };

  static void answer(Client& client);

  TcpListener listener_;
  Duration period_;
  Time next_;
  std::vector<Client> clients_;
};

/// `picture` as a JPEG file.
[[nodiscard]] std::vector<std::uint8_t> jpeg_of(const Picture& picture);

}  // namespace tandem::simulator
