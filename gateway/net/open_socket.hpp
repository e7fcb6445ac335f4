#pragma once
// Private to the translation unit that knows Boost, as boost_net.hpp is.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "gateway/net/boost_net.hpp"
#include "gateway/net/https_server.hpp"
#include "gateway/net/out_queue.hpp"

namespace tandem::net {

/// A WebSocket that is open, and what waits to be sent on it. Lives on the server's thread.
struct OpenSocket {
  OpenSocket(WebSocket stream, const ServerLimits& limits)
      : web_socket(std::move(stream)),
        queue(limits.queued_messages, limits.queued_bytes),
        wake(web_socket.get_executor(), asio::steady_timer::time_point::max()) {}

  /// Closes it once what is being written has left; the first code counts.
  void ask_to_close(std::uint16_t code, const std::string& reason);

  WebSocket web_socket;
  OutQueue queue;
  asio::steady_timer wake;  ///< cancelled when there is something to write
  std::uint16_t close_code = 0;
  std::string close_reason;
  std::string session;
};

/// Writes what waits, one frame at a time; ends the connection when a frame does not leave within `patience`.
asio::awaitable<void> write_all(std::shared_ptr<OpenSocket> socket, std::chrono::milliseconds patience);

}  // namespace tandem::net
