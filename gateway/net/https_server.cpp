#include "gateway/net/https_server.hpp"

#include <utility>

#include "gateway/net/server_thread.hpp"

namespace tandem::net {

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
