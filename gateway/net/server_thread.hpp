#pragma once
// Private to the translation unit that knows Boost, as boost_net.hpp is.

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "gateway/net/http_messages.hpp"
#include "gateway/net/open_socket.hpp"
#include "gateway/net/page_files.hpp"

namespace tandem::net {

inline constexpr std::uint16_t kTooSlow = 4008;
inline constexpr std::uint16_t kGoingAway = 1001;

/// The thread of an HttpsServer, and what lives on it.
class HttpsServer::Server {
 public:
  Server(const Options& options, const Certificate& certificate, const std::vector<Asset>& assets,
         Gatekeeper& gatekeeper);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::vector<SocketEvent> take();
  bool wait(std::chrono::milliseconds timeout);

  /// Does `action` to the socket, on the thread, if it is still open then.
  template <typename Action>
  void with_socket(SocketId id, Action action) {
    asio::post(io_, [this, id, action = std::move(action)]() mutable {
      if (const auto found = sockets_.find(id); found != sockets_.end()) action(*found->second);
    });
  }

 private:
  /// Counts a connection for as long as it lives.
  struct Counted {
    Counted(Server& server, std::string from) : owner(server), address(std::move(from)) {
      ++owner.total_;
      ++owner.count_[address];
    }
    ~Counted() {
      --owner.total_;
      if (--owner.count_[address] == 0) owner.count_.erase(address);
    }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    Server& owner;
    std::string address;
  };

  void set_up_tls(const Certificate& certificate);
  void listen();
  asio::awaitable<void> accept_all();
  asio::awaitable<void> serve(tcp::socket tcp_socket, std::string address);
  asio::awaitable<void> run_socket(TlsStream stream, Request request, std::string session);
  Admission admission_of(const HttpRequest& request, const Request& raw);
  HttpResponse answer_to(const HttpRequest& request);
  /// False when the phone has sent more than anybody took.
  bool put(SocketEvent event);

  Options options_;
  Gatekeeper& gatekeeper_;
  PageFiles pages_;
  std::uint16_t port_ = 0;
  std::size_t total_ = 0;
  std::map<std::string, std::size_t> count_;
  SocketId last_id_ = 0;
  bool ending_ = false;
  std::mutex mutex_;  ///< guards the next two
  std::vector<SocketEvent> events_;
  std::map<SocketId, std::size_t> unread_;
  std::condition_variable arrived_;  ///< an event
  asio::io_context io_{1};           ///< what follows lives in it
  ssl::context tls_;
  tcp::acceptor acceptor_;
  std::map<SocketId, std::shared_ptr<OpenSocket>> sockets_;  ///< shared by the two coroutines of a socket
  std::thread thread_;
};

}  // namespace tandem::net
