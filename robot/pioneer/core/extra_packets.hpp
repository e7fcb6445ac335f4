#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/pioneer/core/packet.hpp"

namespace tandem::pioneer {

/// ENCODERpac: what the wheels have counted since the power came on; wraps.
struct EncoderPacket {
  std::int32_t left_ticks = 0;
  std::int32_t right_ticks = 0;

  friend bool operator==(const EncoderPacket&, const EncoderPacket&) = default;
};
[[nodiscard]] Packet encode_encoders(const EncoderPacket& encoders);
[[nodiscard]] std::optional<EncoderPacket> decode_encoders(const Packet& packet);

/// IOpac: digital inputs (the first byte is that of the standard packet), digital outputs, and analog values as they
/// are measured.
struct IoPacket {
  std::vector<std::uint8_t> digital_in;
  std::vector<std::uint8_t> digital_out;
  std::vector<std::uint16_t> analog;

  friend bool operator==(const IoPacket&, const IoPacket&) = default;
};
[[nodiscard]] Packet encode_io(const IoPacket& io);
/// None if `packet` is of another type or ends before its counts say.
[[nodiscard]] std::optional<IoPacket> decode_io(const Packet& packet);

/// One reading of the gyro.
struct GyroReading {
  std::uint16_t rate = 512;  ///< [0, 1023], 512 about still, less is counter-clockwise
  std::uint8_t temperature = 0;

  friend bool operator==(const GyroReading&, const GyroReading&) = default;
};
/// GYROpac: the readings since the last, 25 ms apart.
[[nodiscard]] Packet encode_gyro(const std::vector<GyroReading>& readings);
[[nodiscard]] std::optional<std::vector<GyroReading>> decode_gyro(const Packet& packet);

}  // namespace tandem::pioneer
