#include "services/simulator/wire/connection.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace tandem::simulator {

Connection::Connection(int descriptor, std::size_t most_waiting)
    : descriptor_(descriptor), most_waiting_(most_waiting) {
  ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) | O_NONBLOCK);
  ::fcntl(descriptor_, F_SETFD, FD_CLOEXEC);
}

Connection::Connection(Connection&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      most_waiting_(other.most_waiting_),
      waiting_(std::move(other.waiting_)) {}

Connection& Connection::operator=(Connection&& other) noexcept {
  if (this != &other) {
    close();
    descriptor_ = std::exchange(other.descriptor_, -1);
    most_waiting_ = other.most_waiting_;
    waiting_ = std::move(other.waiting_);
  }
  return *this;
}

std::vector<std::uint8_t> Connection::read() {
  std::vector<std::uint8_t> all;
  std::uint8_t chunk[4096];
  while (is_open()) {
    const auto count = ::read(descriptor_, chunk, sizeof chunk);
    if (count > 0) {
      all.insert(all.end(), chunk, chunk + count);
      if (count < static_cast<ssize_t>(sizeof chunk)) break;
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    close();
  }
  return all;
}

void Connection::write(std::span<const std::uint8_t> bytes) {
  if (!is_open() || bytes.empty()) return;
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  flush();
  if (waiting_.size() > most_waiting_) close();
}

void Connection::write(std::string_view text) {
  write(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void Connection::flush() {
  while (is_open() && !waiting_.empty()) {
    const auto count = ::write(descriptor_, waiting_.data(), waiting_.size());  // SIGPIPE is ignored in main
    if (count > 0) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + count);
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    close();
  }
}

void Connection::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  waiting_.clear();
}

}  // namespace tandem::simulator
