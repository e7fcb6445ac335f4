#include "robot/pioneer/core/packet.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem::pioneer {
namespace {

constexpr Time kStart{std::chrono::seconds{1000}};
constexpr auto kMillisecond = std::chrono::milliseconds{1};

std::vector<Packet> packets_in(PacketReceiver& receiver) {
  std::vector<Packet> packets;
  while (auto packet = receiver.next()) packets.push_back(*packet);
  return packets;
}

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(Packet, EncodesTheVectorsOfTheProtocol) {
  EXPECT_EQ(command(Command::Pulse), (Bytes{0xFA, 0xFB, 0x03, 0x00, 0x00, 0x00}));
  EXPECT_EQ(command(Command::Open), (Bytes{0xFA, 0xFB, 0x03, 0x01, 0x00, 0x01}));
  EXPECT_EQ(command(Command::Close), (Bytes{0xFA, 0xFB, 0x03, 0x02, 0x00, 0x02}));
  EXPECT_EQ(command(Command::Open, 1), (Bytes{0xFA, 0xFB, 0x06, 0x01, 0x3B, 0x01, 0x00, 0x02, 0x3B}));
  EXPECT_EQ(command(Command::Enable, 1), (Bytes{0xFA, 0xFB, 0x06, 0x04, 0x3B, 0x01, 0x00, 0x05, 0x3B}));
  EXPECT_EQ(command(Command::Velocity, 300), (Bytes{0xFA, 0xFB, 0x06, 0x0B, 0x3B, 0x2C, 0x01, 0x37, 0x3C}));
  EXPECT_EQ(command(Command::Velocity, -300), (Bytes{0xFA, 0xFB, 0x06, 0x0B, 0x1B, 0x2C, 0x01, 0x37, 0x1C}));
  EXPECT_EQ(command(Command::TurnRate, 30), (Bytes{0xFA, 0xFB, 0x06, 0x15, 0x3B, 0x1E, 0x00, 0x33, 0x3B}));
  EXPECT_EQ(command(Command::Sonar, 1), (Bytes{0xFA, 0xFB, 0x06, 0x1C, 0x3B, 0x01, 0x00, 0x1D, 0x3B}));
  EXPECT_EQ(command(Command::Config), (Bytes{0xFA, 0xFB, 0x03, 0x12, 0x00, 0x12}));
  EXPECT_EQ(command(Command::Stop), (Bytes{0xFA, 0xFB, 0x03, 0x1D, 0x00, 0x1D}));
  EXPECT_EQ(command(Command::EmergencyStop), (Bytes{0xFA, 0xFB, 0x03, 0x37, 0x00, 0x37}));
  EXPECT_EQ(packed_command(Command::WheelVelocities, 0xF6, 0x0A),
            (Bytes{0xFA, 0xFB, 0x06, 0x20, 0x3B, 0x0A, 0xF6, 0x2B, 0x31}));
}

TEST(Packet, DecodesWhatItEncodes) {
  PacketReceiver receiver;
  receiver.push(joined({command(Command::Velocity, -300), command(Command::Pulse), command(Command::Enable, 1)}),
                kStart);
  const auto packets = packets_in(receiver);

  ASSERT_EQ(packets.size(), 3u);
  EXPECT_EQ(decode_command(packets[0])->integer_or(0), -300);
  EXPECT_EQ(decode_command(packets[1])->integer_or(7), 7);  // has no argument
  EXPECT_EQ(decode_command(packets[2])->integer_or(0), 1);
}

TEST(Packet, ReadsPackedBytesWithEitherSign) {
  const Packet positive{32, {0x3B, 0x0A, 0xF6}};
  const Packet negative{32, {0x1B, 0xF6, 0x09}};  // 65536 - 0xF60A = 0x09F6

  EXPECT_EQ(decode_command(positive)->packed_bytes(), 0xF60A);
  EXPECT_EQ(decode_command(negative)->packed_bytes(), 0xF60A);
}

TEST(Packet, RefusesAnArgumentOfUnknownTypeOrCutShort) {
  EXPECT_FALSE(decode_command({11, {0x77, 1, 0}}));
  EXPECT_FALSE(decode_command({11, {0x3B, 1}}));
  EXPECT_FALSE(decode_command({3, {0x2B, 5, 'a'}}));
  EXPECT_EQ(std::get<std::string>(decode_command({3, {0x2B, 2, 'a', 'b'}})->argument), "ab");
}

TEST(Packet, CarriesTheIdentityOfTheRobot) {
  const Identity identity{"Tibi", "Pioneer", "p2at"};

  EXPECT_EQ(decode_identity(encode_identity(identity)), identity);
  EXPECT_FALSE(decode_identity({packet_type::kSync2, {'a', 0}}));
  EXPECT_FALSE(decode_identity({packet_type::kSync1, {'a', 0, 'b', 0, 'c', 0}}));
}

TEST(PacketReceiver, FindsAPacketThatComesOneByteAtATime) {
  PacketReceiver receiver;
  const Bytes bytes = command(Command::Velocity, 300);
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
    receiver.push(std::span{bytes}.subspan(i, 1), kStart + kMillisecond * static_cast<int>(i));
    EXPECT_FALSE(receiver.next());
  }
  receiver.push(std::span{bytes}.last(1), kStart + kMillisecond * 8);

  const auto packet = receiver.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->number, 11);
  EXPECT_EQ(packet->first_byte, kStart);
}

TEST(PacketReceiver, SkipsGarbageBeforeAPacket) {
  PacketReceiver receiver;
  receiver.push(joined({{'W', 'M', 'S', '2', '\r', 0xFA, 0xFA}, command(Command::Pulse)}), kStart);

  EXPECT_EQ(packets_in(receiver).size(), 1u);
  EXPECT_EQ(receiver.skipped_bytes(), 7u);
}

TEST(PacketReceiver, SearchesAgainRightBehindTheHeaderOfABadPacket) {
  // A count of 9 where 3 was meant swallows the start of the next packet; nothing but the bad packet may be lost.
  PacketReceiver receiver;
  Bytes corrupt = command(Command::Pulse);
  corrupt[2] = 9;
  receiver.push(joined({corrupt, command(Command::Velocity, 300), command(Command::Stop)}), kStart);
  const auto packets = packets_in(receiver);

  ASSERT_EQ(packets.size(), 2u);
  EXPECT_EQ(packets[0].number, 11);
  EXPECT_EQ(packets[1].number, 29);
  EXPECT_EQ(receiver.bad_checksums(), 1u);
}

TEST(PacketReceiver, NeverTrustsACountOutsideTheProtocol) {
  PacketReceiver receiver;
  receiver.push(joined({{0xFA, 0xFB, 0xFF}, {0xFA, 0xFB, 0x02}, command(Command::Stop)}), kStart);

  EXPECT_EQ(packets_in(receiver).size(), 1u);
}

TEST(PacketReceiver, GivesUpOnAPacketAfterASilence) {
  PacketReceiver receiver;
  receiver.push(Bytes{0xFA, 0xFB, 0x20, 0x01, 0x02}, kStart);
  EXPECT_FALSE(receiver.next());

  receiver.push(command(Command::Stop), kStart + 101 * kMillisecond);

  const auto packet = receiver.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->number, 29);
}

TEST(PacketReceiver, GarbageOnTheSerialLineIsNoCommandAndCostsAtMostTwoFrames) {
  // Random bytes, then true packets: no packet that nobody sent, and the third true one is there at the latest.
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng{seed};
    PacketReceiver receiver;
    Bytes garbage(rng.index(200));
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>(rng.index(4) == 0 ? 0xFA + rng.index(2) : rng.bits());
    receiver.push(garbage, kStart);
    const std::size_t false_packets = packets_in(receiver).size();
    EXPECT_EQ(false_packets, 0u);

    const Bytes sip_sized(90, 0x55);
    std::size_t found = 0;
    for (int i = 0; i < 6; ++i) {  // a standard packet every 100 ms, cut anywhere
      const Bytes bytes = framed({0x32, sip_sized});
      const std::size_t cut = rng.index(bytes.size());
      const Time now = kStart + kMillisecond * (150 + 100 * i);
      receiver.push(std::span{bytes}.first(cut), now);
      receiver.push(std::span{bytes}.subspan(cut), now + kMillisecond);
      for (const Packet& packet : packets_in(receiver)) {
        EXPECT_EQ(packet.number, 0x32);
        ++found;
      }
    }
    EXPECT_GE(found, 4u);
  }
}

TEST(PacketReceiver, LosesOnlyTheDamagedPacketsOfANoisyStream) {
  Rng rng{11};
  PacketReceiver receiver;
  int damaged = 0;
  int found = 0;
  Time now = kStart;
  for (int i = 0; i < 5000; ++i) {
    Bytes bytes = framed({0x32, Bytes(60, static_cast<std::uint8_t>(i))});
    if (rng.uniform() < 0.1) {
      bytes[rng.index(bytes.size())] ^= static_cast<std::uint8_t>(1u << rng.index(8));
      ++damaged;
    }
    receiver.push(bytes, now += 20 * kMillisecond);
    while (receiver.next()) ++found;
  }
  EXPECT_GE(found, 5000 - 2 * damaged);
}

}  // namespace
}  // namespace tandem::pioneer
