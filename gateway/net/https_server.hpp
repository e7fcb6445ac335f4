#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gateway/net/certificate.hpp"

namespace tandem::net {

/// A file of the web page, compiled into the program.
struct Asset {
  std::string_view path;  ///< "/assets/index-1a2b.js"
  std::string_view content_type;
  std::string_view content;
  bool immutable = false;  ///< its name carries a hash of its content
};

struct HttpRequest {
  std::string method;
  std::string target;
  std::string host;
  std::string origin;
  std::string cookie;
  std::string content_type;
  std::string body;
  std::string remote_address;
};

struct HttpResponse {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
  std::string set_cookie;  ///< empty: none
};

/// Answer to a WebSocket upgrade: 101 lets it in, anything else is the HTTP status of the refusal.
struct Admission {
  int status = 401;
  std::string session;  ///< handed back with every event of the socket
};

/// Decides who may do what. Asked on the server's own thread: implementations guard their data.
class Gatekeeper {
 public:
  virtual ~Gatekeeper() = default;
  /// Why the request is refused, whatever it asks for (wrong Host); none lets it pass.
  [[nodiscard]] virtual std::optional<HttpResponse> refusal(const HttpRequest& request) = 0;
  [[nodiscard]] virtual HttpResponse post(const HttpRequest& request) = 0;
  [[nodiscard]] virtual Admission admit(const HttpRequest& request) = 0;
};

/// The table of docs/phone.md; defaults are its numbers.
struct ServerLimits {
  std::uint32_t header_bytes = 8 * 1024;
  std::uint64_t body_bytes = 16 * 1024;
  std::size_t message_bytes = 16 * 1024;  ///< of a WebSocket message from a phone
  std::size_t connections = 64;
  std::size_t connections_per_address = 8;
  std::size_t queued_messages = 256;  ///< per phone, then it is closed with 4008
  std::size_t queued_bytes = 256 * 1024;
  std::size_t unread_messages = 512;  ///< of one phone, taken by nobody yet, then it is closed with 4008
  std::chrono::milliseconds handshake{10'000};
  std::chrono::milliseconds header{5'000};
  std::chrono::milliseconds idle{20'000};  ///< pinged after half of it
  std::chrono::milliseconds write{5'000};
};

/// Identifies a WebSocket for the life of the server.
using SocketId = std::uint64_t;

struct SocketEvent {
  enum class Kind { Opened, Text, Closed };
  Kind kind = Kind::Opened;
  SocketId socket = 0;
  std::string session;  ///< from the Gatekeeper
  std::string text;
};

/// HTTPS and WebSocket server on a thread of its own: embedded files, one place for POST, sockets with bounded queues.
///
/// Nothing here knows what the messages mean. All members may be called from any thread.
class HttpsServer {
 public:
  struct Options {
    std::string address = "0.0.0.0";
    std::uint16_t port = 0;  ///< 0: any free one
    std::string subprotocol = "tandem.v1";
    ServerLimits limits;
  };

  /// Listens at once. Throws std::runtime_error, with the port, when it is taken. `assets` and `gatekeeper` outlive it.
  HttpsServer(const Options& options, const Certificate& certificate, const std::vector<Asset>& assets,
              Gatekeeper& gatekeeper);
  ~HttpsServer();
  HttpsServer(const HttpsServer&) = delete;
  HttpsServer& operator=(const HttpsServer&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// What happened on the sockets since the last call, in order.
  [[nodiscard]] std::vector<SocketEvent> take();
  /// Sleeps until take() has something to give, or `timeout` has passed.
  bool wait(std::chrono::milliseconds timeout);

  /// A message that must arrive, in order with the others.
  void send(SocketId socket, std::string text);
  /// The newest of `topic`: replaces one that still waits.
  void send_latest(SocketId socket, const std::string& topic, std::string data, bool binary = false);
  void close(SocketId socket, std::uint16_t code, const std::string& reason);

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace tandem::net
