#include "gateway/net/https_server.hpp"

#include <netinet/tcp.h>

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "gateway/net/http_messages.hpp"
#include "gateway/net/open_socket.hpp"
#include "gateway/net/page_files.hpp"

namespace tandem::net {
namespace {

constexpr std::uint16_t kTooSlow = 4008;
constexpr std::uint16_t kGoingAway = 1001;

}  // namespace

class HttpsServer::Server {
 public:
  Server(const Options& options, const Certificate& certificate, const std::vector<Asset>& assets,
         Gatekeeper& gatekeeper)
      : options_(options), gatekeeper_(gatekeeper), pages_(assets), tls_(ssl::context::tls_server), acceptor_(io_) {
    set_up_tls(certificate);
    listen();
    asio::co_spawn(io_, accept_all(), asio::detached);
    thread_ = std::thread{[this] { io_.run(); }};
  }

  ~Server() {
    asio::post(io_, [this] {
      error_code ignored;
      acceptor_.close(ignored);
      ending_ = true;
      for (auto& [id, socket] : sockets_) socket->ask_to_close(kGoingAway, "gateway ends");
      if (sockets_.empty()) io_.stop();
      auto patience = std::make_shared<asio::steady_timer>(io_, std::chrono::milliseconds{300});
      patience->async_wait([this, patience](error_code) { io_.stop(); });
    });
    thread_.join();
    sockets_.clear();
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }

  std::vector<SocketEvent> take() {
    const std::lock_guard lock{mutex_};
    unread_.clear();
    return std::exchange(events_, {});
  }

  bool wait(std::chrono::milliseconds timeout) {
    std::unique_lock lock{mutex_};
    return arrived_.wait_for(lock, timeout, [this] { return !events_.empty(); });
  }

  template <typename Action>
  void with_socket(SocketId id, Action action) {
    asio::post(io_, [this, id, action = std::move(action)]() mutable {
      if (const auto found = sockets_.find(id); found != sockets_.end()) action(*found->second);
    });
  }

 private:
  void set_up_tls(const Certificate& certificate) {
    tls_.set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 | ssl::context::no_sslv3 |
                     ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
    tls_.use_certificate_chain(asio::buffer(certificate.certificate_pem));
    tls_.use_private_key(asio::buffer(certificate.private_key_pem), ssl::context::pem);
  }

  void listen() {
    error_code error;
    const tcp::endpoint endpoint{asio::ip::make_address(options_.address, error), options_.port};
    if (error) throw std::runtime_error("address " + options_.address + " is not an IP address");
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address{true});
    acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) {
      throw std::runtime_error("cannot listen on " + options_.address + " port " + std::to_string(options_.port) +
                               ": " + error.message() + "; end the other program or choose another port");
    }
    port_ = acceptor_.local_endpoint().port();
  }

  asio::awaitable<void> accept_all() {
    while (acceptor_.is_open()) {
      auto [error, socket] = co_await acceptor_.async_accept(kAwait);
      if (error == asio::error::operation_aborted || !acceptor_.is_open()) co_return;
      if (error) {  // out of file descriptors, say: give those we have time to end
        asio::steady_timer pause{io_, std::chrono::milliseconds{100}};
        co_await pause.async_wait(kAwait);
        continue;
      }
      error_code gone;
      const auto remote = socket.remote_endpoint(gone);
      if (gone) continue;
      const std::string address = remote.address().to_string();
      if (total_ >= options_.limits.connections || count_[address] >= options_.limits.connections_per_address) continue;
      tune(socket);
      asio::co_spawn(io_, serve(std::move(socket), address), asio::detached);
    }
  }

  /// Small kernel buffers, or a phone that reads nothing goes unnoticed for many seconds.
  static void tune(tcp::socket& socket) {
    error_code ignored;
    socket.set_option(tcp::no_delay{true}, ignored);
    socket.set_option(asio::socket_base::send_buffer_size{32 * 1024}, ignored);
    const int timeout_ms = 10'000;
    setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_USER_TIMEOUT, &timeout_ms, sizeof timeout_ms);
  }

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

  asio::awaitable<void> serve(tcp::socket tcp_socket, std::string address) {
    const Counted counted{*this, address};
    TlsStream stream{beast::tcp_stream{std::move(tcp_socket)}, tls_};
    beast::get_lowest_layer(stream).expires_after(options_.limits.handshake);
    const auto [handshake_error] = co_await stream.async_handshake(ssl::stream_base::server, kAwait);
    if (handshake_error) co_return;

    beast::flat_buffer buffer{options_.limits.header_bytes + options_.limits.body_bytes};
    for (bool open = true; open;) {
      http::request_parser<http::string_body> parser;
      parser.header_limit(options_.limits.header_bytes);
      parser.body_limit(options_.limits.body_bytes);
      beast::get_lowest_layer(stream).expires_after(options_.limits.header);
      const auto [read_error, count] = co_await http::async_read(stream, buffer, parser, kAwait);
      if (read_error && read_error != http::error::body_limit && read_error != http::error::header_limit &&
          read_error != http::error::buffer_overflow) {
        break;
      }
      Response response;
      if (read_error) {
        const bool header = read_error != http::error::body_limit;
        response = response_to(Request{}, plain_error(header ? 431 : 413, "too large"));
        response.keep_alive(false);
      } else {
        const HttpRequest request = plain(parser.get(), address);
        if (websocket::is_upgrade(parser.get())) {
          const Admission admission = admission_of(request, parser.get());
          if (admission.status == 101) {
            co_await run_socket(std::move(stream), parser.release(), admission.session);
            co_return;
          }
          response = response_to(parser.get(), plain_error(admission.status, "refused"));
        } else {
          response = response_to(parser.get(), answer_to(request));
          if (pages_.is_immutable(request.target)) {
            response.set(http::field::cache_control, "public, max-age=31536000, immutable");
          }
        }
      }
      open = response.keep_alive();
      const auto [write_error, written] = co_await http::async_write(stream, response, kAwait);
      if (write_error) co_return;
    }
    beast::get_lowest_layer(stream).expires_after(std::chrono::seconds{1});
    co_await stream.async_shutdown(kAwait);
  }

  Admission admission_of(const HttpRequest& request, const Request& raw) {
    if (const auto refusal = gatekeeper_.refusal(request)) return {refusal->status, ""};
    bool offered = false;
    for (const auto& name : http::token_list{raw[http::field::sec_websocket_protocol]}) {
      offered = offered || text_of(name) == options_.subprotocol;
    }
    if (request.target != "/ws" || !offered) return {400, ""};
    return gatekeeper_.admit(request);
  }

  HttpResponse answer_to(const HttpRequest& request) {
    if (auto refusal = gatekeeper_.refusal(request)) return *refusal;
    if (request.method == "POST") return gatekeeper_.post(request);
    if (request.method != "GET" && request.method != "HEAD") return plain_error(405, "only GET and POST");
    const Asset* asset = pages_.find(request.target);
    if (asset == nullptr) return plain_error(404, "there is no such page");
    return {200, std::string{asset->content_type}, std::string{request.method == "GET" ? asset->content : ""}, ""};
  }

  asio::awaitable<void> run_socket(TlsStream stream, Request request, std::string session) {
    beast::get_lowest_layer(stream).expires_never();
    const auto socket =
        std::make_shared<OpenSocket>(WebSocket{std::move(stream)}, options_.limits);  // reader and writer
    socket->session = std::move(session);
    auto& web_socket = socket->web_socket;
    web_socket.set_option(websocket::stream_base::timeout{options_.limits.handshake, options_.limits.idle, true});
    web_socket.set_option(websocket::stream_base::decorator([this](websocket::response_type& response) {
      response.set(http::field::sec_websocket_protocol, options_.subprotocol);
    }));
    web_socket.read_message_max(options_.limits.message_bytes);
    const auto [accept_error] = co_await web_socket.async_accept(request, kAwait);
    if (accept_error) co_return;

    const SocketId id = ++last_id_;
    sockets_.emplace(id, socket);
    put({SocketEvent::Kind::Opened, id, socket->session, ""});
    asio::co_spawn(io_, write_all(socket, options_.limits.write), asio::detached);
    beast::flat_buffer buffer;
    for (;;) {
      const auto [error, count] = co_await web_socket.async_read(buffer, kAwait);
      if (error) break;
      if (!web_socket.got_text()) {
        socket->ask_to_close(1003, "text only");
      } else if (!put({SocketEvent::Kind::Text, id, socket->session, beast::buffers_to_string(buffer.data())})) {
        socket->ask_to_close(kTooSlow, "too many messages");
      }
      buffer.consume(buffer.size());
    }
    sockets_.erase(id);
    socket->ask_to_close(kGoingAway, "closed");
    put({SocketEvent::Kind::Closed, id, socket->session, ""});
    if (ending_ && sockets_.empty()) io_.stop();
  }

  /// False when the phone has sent more than anybody took.
  bool put(SocketEvent event) {
    const std::lock_guard lock{mutex_};
    if (event.kind == SocketEvent::Kind::Text && ++unread_[event.socket] > options_.limits.unread_messages) {
      return false;
    }
    events_.push_back(std::move(event));
    arrived_.notify_all();
    return true;
  }

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

HttpsServer::HttpsServer(const Options& options, const Certificate& certificate, const std::vector<Asset>& assets,
                         Gatekeeper& gatekeeper)
    : server_(std::make_unique<Server>(options, certificate, assets, gatekeeper)) {}

HttpsServer::~HttpsServer() = default;

std::uint16_t HttpsServer::port() const {
  return server_->port();
}

std::vector<SocketEvent> HttpsServer::take() {
  return server_->take();
}

bool HttpsServer::wait(std::chrono::milliseconds timeout) {
  return server_->wait(timeout);
}

void HttpsServer::send(SocketId socket, std::string text) {
  server_->with_socket(socket, [text = std::move(text)](OpenSocket& open) mutable {
    if (!open.queue.push({false, std::move(text)})) open.ask_to_close(kTooSlow, "slow");
    open.wake.cancel();
  });
}

void HttpsServer::send_latest(SocketId socket, const std::string& topic, std::string data, bool binary) {
  server_->with_socket(socket, [topic, binary, data = std::move(data)](OpenSocket& open) mutable {
    open.queue.set_latest(topic, {binary, std::move(data)});
    open.wake.cancel();
  });
}

void HttpsServer::close(SocketId socket, std::uint16_t code, const std::string& reason) {
  server_->with_socket(socket, [code, reason](OpenSocket& open) { open.ask_to_close(code, reason); });
}

}  // namespace tandem::net
