#include "gateway/net/open_socket.hpp"

namespace tandem::net {
namespace {

void arm(asio::steady_timer& deadline, std::chrono::milliseconds patience, const std::shared_ptr<OpenSocket>& socket) {
  deadline.expires_after(patience);
  deadline.async_wait([socket](error_code error) {
    if (!error) beast::get_lowest_layer(socket->web_socket).cancel();
  });
}

}  // namespace

void OpenSocket::ask_to_close(std::uint16_t code, const std::string& reason) {
  if (close_code == 0) {
    close_code = code;
    close_reason = reason.substr(0, 120);
  }
  wake.cancel();
}

asio::awaitable<void> write_all(std::shared_ptr<OpenSocket> socket, std::chrono::milliseconds patience) {
  asio::steady_timer deadline{socket->web_socket.get_executor()};
  while (socket->close_code == 0) {
    std::optional<Frame> frame = socket->queue.take();
    if (!frame) {
      co_await socket->wake.async_wait(kAwait);
      continue;
    }
    socket->web_socket.binary(frame->binary);
    arm(deadline, patience, socket);
    const auto [error, count] = co_await socket->web_socket.async_write(asio::buffer(frame->data), kAwait);
    deadline.cancel();
    if (error) co_return;
  }
  if (!socket->web_socket.is_open()) co_return;
  arm(deadline, patience, socket);
  const websocket::close_reason reason{static_cast<websocket::close_code>(socket->close_code), socket->close_reason};
  co_await socket->web_socket.async_close(reason, kAwait);
  deadline.cancel();
}

}  // namespace tandem::net
