#include "gateway/net/server_thread.hpp"

#include <netinet/tcp.h>

#include <stdexcept>

namespace tandem::net {
namespace {

/// Small kernel buffers, or a phone that reads nothing goes unnoticed for many seconds.
void tune(tcp::socket& socket) {
  error_code ignored;
  socket.set_option(tcp::no_delay{true}, ignored);
  socket.set_option(asio::socket_base::send_buffer_size{32 * 1024}, ignored);
  const int timeout_ms = 10'000;
  setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_USER_TIMEOUT, &timeout_ms, sizeof timeout_ms);
}

}  // namespace

HttpsServer::Server::Server(const Options& options, const Certificate& certificate, const std::vector<Asset>& assets,
                            Gatekeeper& gatekeeper)
    : options_(options), gatekeeper_(gatekeeper), pages_(assets), tls_(ssl::context::tls_server), acceptor_(io_) {
  set_up_tls(certificate);
  listen();
  asio::co_spawn(io_, accept_all(), asio::detached);
  thread_ = std::thread{[this] { io_.run(); }};
}

HttpsServer::Server::~Server() {
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

std::vector<SocketEvent> HttpsServer::Server::take() {
  const std::lock_guard lock{mutex_};
  unread_.clear();
  return std::exchange(events_, {});
}

bool HttpsServer::Server::wait(std::chrono::milliseconds timeout) {
  std::unique_lock lock{mutex_};
  return arrived_.wait_for(lock, timeout, [this] { return !events_.empty(); });
}

void HttpsServer::Server::set_up_tls(const Certificate& certificate) {
  tls_.set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 | ssl::context::no_sslv3 |
                   ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
  tls_.use_certificate_chain(asio::buffer(certificate.certificate_pem));
  tls_.use_private_key(asio::buffer(certificate.private_key_pem), ssl::context::pem);
}

void HttpsServer::Server::listen() {
  error_code error;
  const tcp::endpoint endpoint{asio::ip::make_address(options_.address, error), options_.port};
  if (error) throw std::runtime_error("address " + options_.address + " is not an IP address");
  acceptor_.open(endpoint.protocol());
  acceptor_.set_option(tcp::acceptor::reuse_address{true});
  acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) {
    throw std::runtime_error("cannot listen on " + options_.address + " port " + std::to_string(options_.port) + ": " +
                             error.message() + "; end the other program or choose another port");
  }
  port_ = acceptor_.local_endpoint().port();
}

asio::awaitable<void> HttpsServer::Server::accept_all() {
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

asio::awaitable<void> HttpsServer::Server::serve(tcp::socket tcp_socket, std::string address) {
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

Admission HttpsServer::Server::admission_of(const HttpRequest& request, const Request& raw) {
  if (const auto refusal = gatekeeper_.refusal(request)) return {refusal->status, ""};
  bool offered = false;
  for (const auto& name : http::token_list{raw[http::field::sec_websocket_protocol]}) {
    offered = offered || text_of(name) == options_.subprotocol;
  }
  if (request.target != "/ws" || !offered) return {400, ""};
  return gatekeeper_.admit(request);
}

HttpResponse HttpsServer::Server::answer_to(const HttpRequest& request) {
  if (auto refusal = gatekeeper_.refusal(request)) return *refusal;
  if (request.method == "POST") return gatekeeper_.post(request);
  if (request.method != "GET" && request.method != "HEAD") return plain_error(405, "only GET and POST");
  const Asset* asset = pages_.find(request.target);
  if (asset == nullptr) return plain_error(404, "there is no such page");
  return {200, std::string{asset->content_type}, std::string{request.method == "GET" ? asset->content : ""}, ""};
}

asio::awaitable<void> HttpsServer::Server::run_socket(TlsStream stream, Request request, std::string session) {
  beast::get_lowest_layer(stream).expires_never();
  const auto socket = std::make_shared<OpenSocket>(WebSocket{std::move(stream)}, options_.limits);  // reader and writer
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

bool HttpsServer::Server::put(SocketEvent event) {
  const std::lock_guard lock{mutex_};
  if (event.kind == SocketEvent::Kind::Text && ++unread_[event.socket] > options_.limits.unread_messages) {
    return false;
  }
  events_.push_back(std::move(event));
  arrived_.notify_all();
  return true;
}

}  // namespace tandem::net
