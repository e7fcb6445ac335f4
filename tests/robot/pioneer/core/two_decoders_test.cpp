// The driver's decoder and one that only walks the tables of the protocol agree on a million random packets.
#include <gtest/gtest.h>

#include "robot/pioneer/core/config_packet.hpp"
#include "robot/pioneer/core/sip.hpp"
#include "services/common/random.hpp"
#include "tests/robot/pioneer/core/table_decoder.hpp"

namespace tandem::pioneer {
namespace {

constexpr std::uint64_t kSeed = 20;
using Fields = TableDecoder::Fields;

template <typename Value>
void put(Fields& fields, const std::string& name, const Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    fields[name] = value;
  } else {
    fields[name] = std::to_string(value);
  }
}
template <typename Value>
void put(Fields& fields, const std::string& name, const std::optional<Value>& value) {
  if (value) put(fields, name, *value);
}

Fields fields_of(const Sip& sip) {
  Fields fields;
  put(fields, "x", sip.x);
  put(fields, "y", sip.y);
  put(fields, "heading", sip.heading);
  put(fields, "left", sip.left_velocity);
  put(fields, "right", sip.right_velocity);
  put(fields, "battery", sip.battery);
  put(fields, "stall_low", sip.rear_bumpers * 2 + (sip.left_stalled ? 1 : 0));
  put(fields, "stall_high", sip.front_bumpers * 2 + (sip.right_stalled ? 1 : 0));
  put(fields, "control", sip.control);
  put(fields, "flags", sip.flags);
  put(fields, "compass", sip.compass);
  put(fields, "sonars", sip.sonar.size());
  for (std::size_t i = 0; i < sip.sonar.size(); ++i) {
    put(fields, "number" + std::to_string(i), sip.sonar[i].number);
    put(fields, "range" + std::to_string(i), sip.sonar[i].range);
  }
  put(fields, "gripper", sip.gripper_state);
  put(fields, "analog_port", sip.analog_port);
  put(fields, "analog", sip.analog);
  put(fields, "digital_in", sip.digital_in);
  put(fields, "digital_out", sip.digital_out);
  put(fields, "battery_x10", sip.battery_x10);
  put(fields, "charge", sip.charge_state);
  put(fields, "turn_rate", sip.turn_rate_x10);
  put(fields, "faults", sip.fault_flags);
  put(fields, "lateral", sip.lateral_velocity);
  put(fields, "temperature", sip.temperature_c);
  put(fields, "charge_state", sip.state_of_charge);
  put(fields, "time_us", sip.controller_time_us);
  put(fields, "flags3", sip.flags3);
  return fields;
}

/// What a robot of any age may send: a body of random bytes, cut anywhere, with few enough sonars to fit.
Bytes random_body(Rng& rng) {
  Bytes body(19 + rng.index(60));
  for (auto& byte : body) byte = static_cast<std::uint8_t>(rng.bits());
  body[18] = static_cast<std::uint8_t>(rng.index(20));
  return body;
}

TEST(TwoDecoders, AgreeOnAMillionStandardPackets) {
  Rng rng{kSeed};
  int whole = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Packet sent{static_cast<std::uint8_t>(0x32 + rng.index(2)), random_body(rng)};
    const Bytes bytes = framed(sent);
    const auto by_table = TableDecoder::unframed(bytes);
    PacketReceiver receiver;
    receiver.push(bytes, Time{});
    const auto packet = receiver.next();
    ASSERT_TRUE(by_table && packet) << "seed " << kSeed << " packet " << i;
    const auto sip = decode_sip(*packet);
    const Fields expected = TableDecoder::sip(by_table->body);
    const bool complete = expected.contains("sonars") &&
                          (expected.at("sonars") == "0" ||
                           expected.contains("range" + std::to_string(std::stoi(expected.at("sonars")) - 1)));
    ASSERT_EQ(sip.has_value(), complete) << "seed " << kSeed << " packet " << i;
    if (sip) {
      ++whole;
      ASSERT_EQ(fields_of(*sip), expected) << "seed " << kSeed << " packet " << i;
    }
  }
  EXPECT_GT(whole, 300'000);
}

TEST(TwoDecoders, AgreeOnWhatIsAPacket) {
  Rng rng{kSeed};
  int packets = 0;
  for (int i = 0; i < 200'000; ++i) {
    Bytes bytes = framed({static_cast<std::uint8_t>(rng.bits()), Bytes(rng.index(40), 0x5A)});
    if (rng.index(2) == 0) bytes[2 + rng.index(bytes.size() - 2)] ^= static_cast<std::uint8_t>(rng.index(4));
    const auto by_table = TableDecoder::unframed(bytes);
    PacketReceiver receiver;
    receiver.push(bytes, Time{});
    const auto packet = receiver.next();
    if (bytes.size() == bytes[2] + 3u) {
      ASSERT_EQ(packet.has_value(), by_table.has_value()) << "seed " << kSeed << " packet " << i;
    }
    if (!packet || !by_table) continue;
    ++packets;
    ASSERT_EQ(packet->number, by_table->type);
    ASSERT_EQ(packet->body, by_table->body);
  }
  EXPECT_GT(packets, 100'000);
}

TEST(TwoDecoders, AgreeOnConfigPacketsOfAnyLength) {
  Rng rng{kSeed};
  for (int i = 0; i < 100'000; ++i) {
    Bytes body(rng.index(kMaxBody));
    for (auto& byte : body) byte = static_cast<std::uint8_t>(rng.index(3) == 0 ? 0 : rng.bits());
    const auto config = decode_config({packet_type::kConfig, body});
    ASSERT_TRUE(config);
    Fields expected = TableDecoder::config(body);
    const auto number = [&](const char* name) { return expected.contains(name) ? std::stol(expected[name]) : 0; };
    ASSERT_EQ(config->type, expected["type"]);
    ASSERT_EQ(config->subtype, expected["subtype"]);
    ASSERT_EQ(config->name, expected["name"]);
    ASSERT_EQ(config->sip_cycle_ms, number("sipcycle"));
    ASSERT_EQ(config->watchdog_ms, number("watchdog"));
    ASSERT_EQ(config->acceleration, number("transaccel"));
    ASSERT_EQ(config->deceleration, number("transdecel"));
    ASSERT_EQ(config->has_gyro, number("gyro"));
    ASSERT_EQ(config->drift_factor, number("drift"));
    ASSERT_EQ(config->firmware_version, expected["firmware"]);
    ASSERT_EQ(config->kinematics_delay_ms, number("kindelay"));
    ASSERT_EQ(config->lateral_deceleration, number("latdecel"));
    ASSERT_EQ(config->shutdown_temperature_c, number("hightemp"));
    ASSERT_EQ(config->bootloader_version, expected["bootloader"]);
    ASSERT_EQ(config->config_flags, number("configflags"));
    ASSERT_EQ(config->gyro_firmware, number("gyrofw"));
  }
}

TEST(TwoDecoders, AgreeOnAStreamFedByteByByteWithNoiseAndLoseTwoFramesAtMostForEachDamage) {
  Rng rng{kSeed};
  PacketReceiver receiver;
  Time now{std::chrono::seconds{1}};
  int found = 0;
  int sent = 0;
  int damages = 0;
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes = framed({0x32, random_body(rng)});
    ++sent;
    if (rng.index(20) == 0) {
      ++damages;
      bytes[rng.index(bytes.size())] ^= static_cast<std::uint8_t>(1 + rng.index(255));
    }
    for (const std::uint8_t byte : bytes) {
      receiver.push(std::span{&byte, 1}, now);
      now += std::chrono::microseconds{260};  // 38400 baud
      while (receiver.next()) ++found;
    }
    now += std::chrono::milliseconds{101};  // frames come apart from each other
    receiver.push({}, now);
  }
  EXPECT_GE(found, sent - 2 * damages);
  EXPECT_LE(found, sent);
}

}  // namespace
}  // namespace tandem::pioneer
