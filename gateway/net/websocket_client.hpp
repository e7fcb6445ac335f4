#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gateway/net/pairing_link.hpp"

namespace tandem::net {

/// A phone without a screen: pairs over HTTPS with a link, then talks over a WebSocket, on a thread of its own.
///
/// The certificate is trusted because its fingerprint stands in the link, and only then. A lost connection is opened
/// again with the session's cookie, every `retry` until it works. All members may be called from any thread.
class WebSocketClient {
 public:
  enum class State {
    Connecting,  ///< pairing, or opening the socket, or waiting before the next try
    Connected,
    Refused,  ///< for good: wrong fingerprint, used or expired token, unknown session
  };
  struct Options {
    std::string subprotocol = "tandem.v1";
    std::chrono::milliseconds retry{1'000};
    std::chrono::milliseconds timeout{10'000};  ///< of each step of pairing and opening
  };

  explicit WebSocketClient(PairingLink link) : WebSocketClient(std::move(link), Options{}) {}
  WebSocketClient(PairingLink link, Options options);
  ~WebSocketClient();
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  [[nodiscard]] State state() const;
  /// What went wrong last, for people; empty when nothing did.
  [[nodiscard]] std::string reason() const;
  /// Counts openings of the socket: what was sent before the last one may be lost and is to be sent again.
  [[nodiscard]] std::uint64_t connections() const;

  /// Sleeps until something above or below is not as it was when this last returned, or `timeout` has passed.
  bool wait(std::chrono::milliseconds timeout);

  /// Sends `text` if connected; false (and nothing sent) if not.
  bool send(std::string text);
  /// Text messages that came since the last call, in order.
  [[nodiscard]] std::vector<std::string> take();
  /// Binary messages (the belief grid) that came since the last call.
  [[nodiscard]] std::vector<std::string> take_binary();

 private:
  class Client;
  std::unique_ptr<Client> client_;
};

}  // namespace tandem::net
