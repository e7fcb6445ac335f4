#include "robot/pioneer/core/extra_packets.hpp"

#include <cassert>

#include "robot/pioneer/core/fields.hpp"

namespace tandem::pioneer {
namespace {

template <typename Value>
void write_counted(FieldWriter& write, const std::vector<Value>& values) {
  assert(values.size() <= 0xFF);
  write(static_cast<std::uint8_t>(values.size()));
  for (const Value value : values) write(value);
}

template <typename Value>
void read_counted(FieldReader& read, std::vector<Value>& values) {
  std::uint8_t count = 0;
  read(count);
  for (int i = 0; i < count && !read.ended(); ++i) read(values.emplace_back());
}

}  // namespace

Packet encode_encoders(const EncoderPacket& encoders) {
  Packet packet{packet_type::kEncoder, {}};
  FieldWriter write{packet.body};
  write(encoders.left_ticks);
  write(encoders.right_ticks);
  return packet;
}

std::optional<EncoderPacket> decode_encoders(const Packet& packet) {
  if (packet.number != packet_type::kEncoder) return std::nullopt;
  EncoderPacket encoders;
  FieldReader read{packet.body};
  read(encoders.left_ticks);
  read(encoders.right_ticks);
  if (read.ended()) return std::nullopt;
  return encoders;
}

Packet encode_io(const IoPacket& io) {
  Packet packet{packet_type::kIo, {}};
  FieldWriter write{packet.body};
  write_counted(write, io.digital_in);
  write_counted(write, io.digital_out);
  write_counted(write, io.analog);
  return packet;
}

std::optional<IoPacket> decode_io(const Packet& packet) {
  if (packet.number != packet_type::kIo) return std::nullopt;
  IoPacket io;
  FieldReader read{packet.body};
  read_counted(read, io.digital_in);
  read_counted(read, io.digital_out);
  read_counted(read, io.analog);
  if (read.ended()) return std::nullopt;
  return io;
}

Packet encode_gyro(const std::vector<GyroReading>& readings) {
  Packet packet{packet_type::kGyro, {}};
  FieldWriter write{packet.body};
  write(static_cast<std::uint8_t>(readings.size()));
  for (const auto& reading : readings) {
    write(reading.rate);
    write(reading.temperature);
  }
  return packet;
}

std::optional<std::vector<GyroReading>> decode_gyro(const Packet& packet) {
  if (packet.number != packet_type::kGyro) return std::nullopt;
  std::vector<GyroReading> readings;
  FieldReader read{packet.body};
  std::uint8_t count = 0;
  read(count);
  for (int i = 0; i < count && !read.ended(); ++i) {
    GyroReading& reading = readings.emplace_back();
    read(reading.rate);
    read(reading.temperature);
  }
  if (read.ended()) return std::nullopt;
  return readings;
}

}  // namespace tandem::pioneer
