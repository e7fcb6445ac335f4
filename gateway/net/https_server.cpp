#include "gateway/net/https_server.hpp"

#include <netinet/tcp.h>

#include <atomic>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "gateway/net/boost_net.hpp"
#include "gateway/net/out_queue.hpp"

namespace tandem::net {
namespace {

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "manifest-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
constexpr std::uint16_t kTooSlow = 4008;
constexpr std::uint16_t kGoingAway = 1001;

std::string text_of(beast::string_view view) {
  return {view.data(), view.size()};
}

HttpRequest plain(const Request& request, const std::string& address) {
  return {.method = text_of(request.method_string()),
          .target = text_of(request.target()),
          .host = text_of(request[http::field::host]),
          .origin = text_of(request[http::field::origin]),
          .cookie = text_of(request[http::field::cookie]),
          .content_type = text_of(request[http::field::content_type]),
          .body = request.body(),
          .remote_address = address};
}

Response response_to(const Request& request, const HttpResponse& answer) {
  Response response{static_cast<http::status>(answer.status), request.version()};
  response.set(http::field::content_type, answer.content_type);
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy", kContentPolicy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Permissions-Policy", "geolocation=(), camera=(), microphone=(), screen-wake-lock=(self)");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  if (!answer.set_cookie.empty()) response.set(http::field::set_cookie, answer.set_cookie);
  response.keep_alive(request.keep_alive() && answer.status < 400);
  response.body() = answer.body;
  response.prepare_payload();
  return response;
}

HttpResponse plain_error(int status, const std::string& text) {
  return {status, "text/plain", text + "\n", ""};
}

}  // namespace

/// A WebSocket that is open, and what waits to be sent on it. Lives on the server's thread.
struct Socket {
  Socket(WebSocket stream, const ServerLimits& limits)
      : web_socket(std::move(stream)),
        queue(limits.queued_messages, limits.queued_bytes),
        wake(web_socket.get_executor(), asio::steady_timer::time_point::max()) {}

  void ask_to_close(std::uint16_t code, const std::string& reason) {
    if (close_code == 0) {
      close_code = code;
      close_reason = reason.substr(0, 120);
    }
    wake.cancel();
  }

  WebSocket web_socket;
  OutQueue queue;
  asio::steady_timer wake;  ///< cancelled when there is something to write
  std::uint16_t close_code = 0;
  std::string close_reason;
  std::string session;
};

class HttpsServer::Server {
 public:
  Server(const Options& options, const Certificate& certificate, const std::vector<Asset>& assets,
         Gatekeeper& gatekeeper)
      : options_(options), gatekeeper_(gatekeeper), tls_(ssl::context::tls_server), acceptor_(io_) {
    for (const auto& asset : assets) assets_.emplace(asset.path, &asset);
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
          if (immutable(request.target)) {
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

  const Asset* asset_at(std::string target) const {
    if (const auto query = target.find('?'); query != std::string::npos) target.erase(query);
    if (target == "/" || target == "/p") target = "/index.html";
    const auto found = assets_.find(target);
    return found == assets_.end() ? nullptr : found->second;
  }

  bool immutable(const std::string& target) const {
    const Asset* asset = asset_at(target);
    return asset != nullptr && asset->immutable;
  }

  HttpResponse answer_to(const HttpRequest& request) {
    if (auto refusal = gatekeeper_.refusal(request)) return *refusal;
    if (request.method == "POST") return gatekeeper_.post(request);
    if (request.method != "GET" && request.method != "HEAD") return plain_error(405, "only GET and POST");
    const Asset* asset = asset_at(request.target);
    if (asset == nullptr) return plain_error(404, "there is no such page");
    return {200, std::string{asset->content_type}, std::string{request.method == "GET" ? asset->content : ""}, ""};
  }

  asio::awaitable<void> run_socket(TlsStream stream, Request request, std::string session) {
    beast::get_lowest_layer(stream).expires_never();
    const auto socket = std::make_shared<Socket>(WebSocket{std::move(stream)}, options_.limits);  // reader and writer
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
    asio::co_spawn(io_, write_all(socket), asio::detached);
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

  /// Writes what waits, one frame at a time; ends the connection when a frame does not leave within the deadline.
  asio::awaitable<void> write_all(std::shared_ptr<Socket> socket) {
    asio::steady_timer deadline{io_};
    while (socket->close_code == 0) {
      std::optional<Frame> frame = socket->queue.take();
      if (!frame) {
        co_await socket->wake.async_wait(kAwait);
        continue;
      }
      socket->web_socket.binary(frame->binary);
      arm(deadline, socket);
      const auto [error, count] = co_await socket->web_socket.async_write(asio::buffer(frame->data), kAwait);
      deadline.cancel();
      if (error) co_return;
    }
    if (!socket->web_socket.is_open()) co_return;
    arm(deadline, socket);
    const websocket::close_reason reason{static_cast<websocket::close_code>(socket->close_code), socket->close_reason};
    co_await socket->web_socket.async_close(reason, kAwait);
    deadline.cancel();
  }

  void arm(asio::steady_timer& deadline, const std::shared_ptr<Socket>& socket) {
    deadline.expires_after(options_.limits.write);
    deadline.async_wait([socket](error_code error) {
      if (!error) beast::get_lowest_layer(socket->web_socket).cancel();
    });
  }

  /// False when the phone has sent more than anybody took.
  bool put(SocketEvent event) {
    const std::lock_guard lock{mutex_};
    if (event.kind == SocketEvent::Kind::Text && ++unread_[event.socket] > options_.limits.unread_messages) {
      return false;
    }
    events_.push_back(std::move(event));
    return true;
  }

  Options options_;
  Gatekeeper& gatekeeper_;
  std::map<std::string, const Asset*, std::less<>> assets_;
  std::uint16_t port_ = 0;
  std::size_t total_ = 0;
  std::map<std::string, std::size_t> count_;
  SocketId last_id_ = 0;
  bool ending_ = false;
  std::mutex mutex_;  ///< guards the next two
  std::vector<SocketEvent> events_;
  std::map<SocketId, std::size_t> unread_;
  asio::io_context io_{1};  ///< what follows lives in it
  ssl::context tls_;
  tcp::acceptor acceptor_;
  std::map<SocketId, std::shared_ptr<Socket>> sockets_;  ///< shared by the two coroutines of a socket
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

void HttpsServer::send(SocketId socket, std::string text) {
  server_->with_socket(socket, [text = std::move(text)](Socket& open) mutable {
    if (!open.queue.push({false, std::move(text)})) open.ask_to_close(kTooSlow, "slow");
    open.wake.cancel();
  });
}

void HttpsServer::send_latest(SocketId socket, const std::string& topic, std::string data, bool binary) {
  server_->with_socket(socket, [topic, binary, data = std::move(data)](Socket& open) mutable {
    open.queue.set_latest(topic, {binary, std::move(data)});
    open.wake.cancel();
  });
}

void HttpsServer::close(SocketId socket, std::uint16_t code, const std::string& reason) {
  server_->with_socket(socket, [code, reason](Socket& open) { open.ask_to_close(code, reason); });
}

}  // namespace tandem::net
