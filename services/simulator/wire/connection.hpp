#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tandem::simulator {

/// An open descriptor to a client: never blocks. What the client does not take yet is kept, up to a limit.
class Connection {
 public:
  /// A client that lets more than `most_waiting` bytes pile up is gone, as seen from here.
  explicit Connection(int descriptor, std::size_t most_waiting = 256 * 1024);
  Connection(Connection&& other) noexcept;
  Connection& operator=(Connection&& other) noexcept;
  ~Connection() { close(); }

  /// All that has come. Closes itself once the client has left.
  [[nodiscard]] std::vector<std::uint8_t> read();
  void write(std::span<const std::uint8_t> bytes);
  void write(std::string_view text);
  /// Sends what waits, as far as the client takes it.
  void flush();
  void close();

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
  std::size_t most_waiting_;
  std::vector<std::uint8_t> waiting_;
};

}  // namespace tandem::simulator
