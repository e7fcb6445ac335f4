#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "services/common/time.hpp"

namespace tandem {

/// An open stream of bytes to a device: TCP, serial port or pseudo-terminal alike. Made by open_byte_link().
///
/// A lost link stays lost: the driver waits and opens a new one. Never throws, never blocks longer than it is told.
class ByteLink {
 public:
  /// Takes over the open, non-blocking descriptor; `name` stands in failure().
  ByteLink(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}
  ByteLink(ByteLink&& other) noexcept;
  ByteLink& operator=(ByteLink&& other) noexcept;
  ~ByteLink() { close(); }

  /// All that has come, waiting for the first byte at most `timeout`; empty when none came or the link is lost.
  [[nodiscard]] std::vector<std::uint8_t> read(Duration timeout);
  /// Sends all of `bytes`. False when the link is lost, which it also is when the device takes nothing for 200 ms.
  bool write(std::span<const std::uint8_t> bytes);
  bool write(std::string_view text);

  /// Changes the rate of a serial line once all that was written is out; nothing on a network link.
  void set_baud_rate(int baud_rate);

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  /// Why the link was lost, with the device's name; empty while it is open.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// The descriptor, for those who wait on several; -1 when closed.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  void close();

 private:
  void lose(const std::string& reason);

  int descriptor_ = -1;
  std::string name_;
  std::string failure_;
};

struct LinkOptions {
  int baud_rate = 115'200;                       ///< 8N1, no handshake; serial ports only.
  Duration connect_timeout = from_seconds(1.0);  ///< TCP only.
};

/// The link, or why there is none: names the device, what is wrong and what to do.
struct OpenedLink {
  std::optional<ByteLink> link;
  std::string failure;
};

/// Opens `device_name` ("tcp://HOST:PORT" or "/dev/..."); throws ConfigError only when the name is neither.
[[nodiscard]] OpenedLink open_byte_link(const std::string& device_name, const LinkOptions& options = {});

}  // namespace tandem
