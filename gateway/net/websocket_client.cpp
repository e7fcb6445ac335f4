#include "gateway/net/websocket_client.hpp"

#include <openssl/evp.h>
#include <openssl/x509.h>

#include <array>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "gateway/net/boost_net.hpp"

namespace tandem::net {
namespace {

/// First 16 hex digits of the SHA-256 of the certificate the other side showed.
std::string peer_fingerprint(TlsStream& stream) {
  X509* certificate = SSL_get1_peer_certificate(stream.native_handle());
  if (certificate == nullptr) return "";
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  const bool hashed = X509_digest(certificate, EVP_sha256(), digest.data(), &size) == 1;
  X509_free(certificate);
  std::string hex;
  for (std::size_t i = 0; hashed && i < 8; ++i) {
    hex += "0123456789abcdef"[digest[i] >> 4];
    hex += "0123456789abcdef"[digest[i] & 15];
  }
  return hex;
}

}  // namespace

class WebSocketClient::Client {
 public:
  Client(PairingLink link, Options options)
      : link_(std::move(link)), options_(std::move(options)), tls_(ssl::context::tls_client), wake_(io_), pause_(io_) {
    tls_.set_verify_mode(ssl::verify_none);  // trusted by the fingerprint in the link instead
    asio::co_spawn(io_, live(), asio::detached);
    thread_ = std::thread{[this] { io_.run(); }};
  }

  ~Client() {
    asio::post(io_, [this] {
      ending_ = true;
      wake_.cancel();
      pause_.cancel();
      auto patience = std::make_shared<asio::steady_timer>(io_, std::chrono::milliseconds{200});
      patience->async_wait([this, patience](error_code) { io_.stop(); });
    });
    thread_.join();
  }

  State state() const {
    const std::lock_guard lock{mutex_};
    return state_;
  }
  std::string reason() const {
    const std::lock_guard lock{mutex_};
    return reason_;
  }
  std::uint64_t connections() const {
    const std::lock_guard lock{mutex_};
    return connections_;
  }
  bool wait(std::chrono::milliseconds timeout) {
    std::unique_lock lock{mutex_};
    const bool changed = changed_.wait_for(lock, timeout, [this] { return changes_ != seen_changes_; });
    seen_changes_ = changes_;
    return changed;
  }
  bool send(std::string text) {
    {
      const std::lock_guard lock{mutex_};
      if (state_ != State::Connected) return false;
      outgoing_.push_back(std::move(text));
    }
    asio::post(io_, [this] { wake_.cancel(); });
    return true;
  }
  std::vector<std::string> take() {
    const std::lock_guard lock{mutex_};
    return std::exchange(texts_, {});
  }
  std::vector<std::string> take_binary() {
    const std::lock_guard lock{mutex_};
    return std::exchange(binaries_, {});
  }

 private:
  asio::awaitable<void> live() {
    while (!ending_) {
      if (cookie_.empty()) co_await pair();
      if (!cookie_.empty()) co_await converse();
      if (ending_) io_.stop();
      if (ending_ || state() == State::Refused) co_return;
      set(State::Connecting, std::nullopt);
      pause_.expires_after(options_.retry);
      co_await pause_.async_wait(kAwait);
    }
  }

  /// A TLS connection to the gateway of the link, or none.
  asio::awaitable<std::optional<TlsStream>> connected_stream() {
    tcp::resolver resolver{io_};
    const auto [resolve_error, endpoints] =
        co_await resolver.async_resolve(link_.host, std::to_string(link_.port), kAwait);
    if (resolve_error) {
      set(State::Connecting, link_.host + ": " + resolve_error.message());
      co_return std::nullopt;
    }
    std::optional<TlsStream> stream{std::in_place, beast::tcp_stream{io_}, tls_};
    beast::get_lowest_layer(*stream).expires_after(options_.timeout);
    const auto [connect_error, endpoint] = co_await beast::get_lowest_layer(*stream).async_connect(endpoints, kAwait);
    if (connect_error) {
      set(State::Connecting, "cannot connect: " + connect_error.message());
      co_return std::nullopt;
    }
    const auto [tls_error] = co_await stream->async_handshake(ssl::stream_base::client, kAwait);
    if (tls_error) {
      set(State::Connecting, "no TLS: " + tls_error.message());
      co_return std::nullopt;
    }
    if (peer_fingerprint(*stream) != link_.fingerprint) {
      set(State::Refused, "the certificate is not the one in the link");
      co_return std::nullopt;
    }
    co_return stream;
  }

  std::string authority() const { return link_.host + ":" + std::to_string(link_.port); }

  /// Trades the one-time token for a session cookie.
  asio::awaitable<void> pair() {
    std::optional<TlsStream> stream = co_await connected_stream();
    if (!stream) co_return;
    http::request<http::string_body> request{http::verb::post, "/api/pair", 11};
    request.set(http::field::host, authority());
    request.set(http::field::origin, "https://" + authority());
    request.set(http::field::content_type, "application/json");
    request.body() = R"({"token":")" + link_.token + R"("})";
    request.prepare_payload();
    const auto [write_error, written] = co_await http::async_write(*stream, request, kAwait);
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    const auto [read_error, read] = co_await http::async_read(*stream, buffer, response, kAwait);
    if (write_error || read_error) {
      set(State::Connecting, "pairing: " + (write_error ? write_error : read_error).message());
      co_return;
    }
    if (response.result_int() == 429) {
      set(State::Connecting, "pairing: too many tries, wait");
      co_return;
    }
    const beast::string_view cookie = response[http::field::set_cookie];
    if (response.result_int() != 200 || cookie.empty()) {
      set(State::Refused, "pairing was refused (" + std::to_string(response.result_int()) + ")");
      co_return;
    }
    cookie_ = std::string{cookie.substr(0, cookie.find(';'))};
  }

  /// Opens the WebSocket and reads until it ends.
  asio::awaitable<void> converse() {
    std::optional<TlsStream> stream = co_await connected_stream();
    if (!stream) co_return;
    beast::get_lowest_layer(*stream).expires_never();
    const auto socket = std::make_shared<WebSocket>(std::move(*stream));  // reader and writer
    socket->set_option(websocket::stream_base::timeout{options_.timeout, std::chrono::seconds{20}, true});
    socket->set_option(websocket::stream_base::decorator([this](websocket::request_type& request) {
      request.set(http::field::origin, "https://" + authority());
      request.set(http::field::cookie, cookie_);
      request.set(http::field::sec_websocket_protocol, options_.subprotocol);
    }));
    websocket::response_type response;
    const auto [error] = co_await socket->async_handshake(response, authority(), "/ws", kAwait);
    if (error) {
      const int status = static_cast<int>(response.result_int());
      const bool final = error == websocket::error::upgrade_declined && (status == 401 || status == 403);
      set(final ? State::Refused : State::Connecting, "opening the socket: " + error.message());
      co_return;
    }
    {
      const std::lock_guard lock{mutex_};
      state_ = State::Connected;
      reason_.clear();
      outgoing_.clear();
      ++connections_;
      note_change();
    }
    asio::co_spawn(io_, write_all(socket), asio::detached);
    beast::flat_buffer buffer;
    for (;;) {
      const auto [read_error, count] = co_await socket->async_read(buffer, kAwait);
      if (read_error) {
        const auto& why = socket->reason();
        set(State::Connecting, "closed: " + (why ? std::to_string(why.code) + " " + std::string{why.reason.c_str()}
                                                 : read_error.message()));
        break;
      }
      const std::lock_guard lock{mutex_};
      (socket->got_text() ? texts_ : binaries_).push_back(beast::buffers_to_string(buffer.data()));
      buffer.consume(buffer.size());
      note_change();
    }
    wake_.cancel();
  }

  asio::awaitable<void> write_all(std::shared_ptr<WebSocket> socket) {
    while (socket->is_open() && !ending_) {
      std::optional<std::string> text;
      {
        const std::lock_guard lock{mutex_};
        if (!outgoing_.empty()) {
          text = std::move(outgoing_.front());
          outgoing_.pop_front();
        }
      }
      if (!text) {
        wake_.expires_at(asio::steady_timer::time_point::max());
        co_await wake_.async_wait(kAwait);
        continue;
      }
      socket->text(true);
      const auto [error, count] = co_await socket->async_write(asio::buffer(*text), kAwait);
      if (error) co_return;
    }
    if (socket->is_open()) co_await socket->async_close(websocket::close_code::going_away, kAwait);
  }

  void set(State state, std::optional<std::string> reason) {
    const std::lock_guard lock{mutex_};
    state_ = state;
    if (reason) reason_ = std::move(*reason);
    note_change();
  }

  /// With the mutex held.
  void note_change() {
    ++changes_;
    changed_.notify_all();
  }

  PairingLink link_;
  Options options_;
  std::string cookie_;
  bool ending_ = false;
  mutable std::mutex mutex_;  ///< guards the next eight
  State state_ = State::Connecting;
  std::string reason_;
  std::uint64_t connections_ = 0;
  std::deque<std::string> outgoing_;
  std::vector<std::string> texts_;
  std::vector<std::string> binaries_;
  std::uint64_t changes_ = 0;
  std::uint64_t seen_changes_ = 0;  ///< when wait() last returned
  std::condition_variable changed_;
  asio::io_context io_{1};  ///< what follows lives in it
  ssl::context tls_;
  asio::steady_timer wake_;  ///< cancelled when there is something to write
  asio::steady_timer pause_;
  std::thread thread_;
};

WebSocketClient::WebSocketClient(PairingLink link, Options options)
    : client_(std::make_unique<Client>(std::move(link), std::move(options))) {}

WebSocketClient::~WebSocketClient() = default;

WebSocketClient::State WebSocketClient::state() const {
  return client_->state();
}
std::string WebSocketClient::reason() const {
  return client_->reason();
}
std::uint64_t WebSocketClient::connections() const {
  return client_->connections();
}
bool WebSocketClient::wait(std::chrono::milliseconds timeout) {
  return client_->wait(timeout);
}
bool WebSocketClient::send(std::string text) {
  return client_->send(std::move(text));
}
std::vector<std::string> WebSocketClient::take() {
  return client_->take();
}
std::vector<std::string> WebSocketClient::take_binary() {
  return client_->take_binary();
}

}  // namespace tandem::net
