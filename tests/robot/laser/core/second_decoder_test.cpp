#include "tests/robot/laser/core/second_decoder.hpp"

#include <gtest/gtest.h>

#include "robot/laser/core/cola_scan.hpp"
#include "robot/laser/core/lms_message.hpp"
#include "robot/laser/core/scip.hpp"
#include "services/common/random.hpp"

namespace tandem {
namespace {

using second::Numbers;

constexpr int kPackets = 1'000'000;
constexpr int kLeastGood = kPackets / 4;  // both read these; about half of the packets are damaged

std::uint32_t below(Rng& rng, std::uint32_t count) {
  return static_cast<std::uint32_t>(rng.bits() % count);
}

/// Half of the packets as they are, the others with some bytes changed, lost or added.
template <typename Packet>
void damage(Packet& packet, Rng& rng) {
  if (below(rng, 2) == 0) return;
  for (std::uint32_t i = 1 + below(rng, 3); i > 0 && !packet.empty(); --i) {
    const auto at = packet.begin() + below(rng, static_cast<std::uint32_t>(packet.size()));
    const auto byte = static_cast<typename Packet::value_type>(rng.bits());
    switch (below(rng, 4)) {
      case 0:
        packet.erase(at);
        break;
      case 1:
        packet.insert(at, byte);
        break;
      case 2:
        *at = *(packet.begin() + below(rng, static_cast<std::uint32_t>(packet.size())));  // likelier to make sense
        break;
      default:
        *at = byte;
    }
  }
}

TEST(SecondDecoder, AgreesWithTheDriverOnScipReplies) {
  Rng rng{1};
  int good = 0;
  const std::array<std::string, 6> commands{"MD", "MS", "ME", "GD", "GS", "GE"};
  for (int i = 0; i < kPackets; ++i) {
    scip::ScanData scan{.timestamp_ms = below(rng, 1U << 24)};
    scan.request = {.command = commands[below(rng, 6)], .first_step = static_cast<int>(below(rng, 900))};
    scan.request.last_step = scan.request.first_step + static_cast<int>(below(rng, 20));
    scan.request.cluster = static_cast<int>(below(rng, 4));
    for (std::size_t k = scip::value_count(scan.request); k > 0; --k) {
      scan.ranges_mm.push_back(below(rng, 1U << 12));
      if (scan.request.command[1] == 'E') scan.intensities.push_back(below(rng, 1U << 18));
    }
    std::string packet = scip::bytes_of(scan);
    damage(packet, rng);

    scip::ReplyParser parser;
    const auto replies = parser.take({reinterpret_cast<const std::uint8_t*>(packet.data()), packet.size()});
    const auto first = second::scip_scan(packet);
    if (replies.size() == 1 && parser.damaged() == 0 && packet.ends_with("\n\n") &&
        packet.find("\n\n") + 2 == packet.size()) {
      const auto read = scip::parse_scan(replies[0]);
      ASSERT_EQ(read.has_value(), first.has_value()) << packet;
      if (!read) continue;
      ++good;
      Numbers numbers{read->timestamp_ms};
      for (std::size_t k = 0; k < read->ranges_mm.size(); ++k) {
        numbers.push_back(read->ranges_mm[k]);
        if (!read->intensities.empty()) numbers.push_back(read->intensities[k]);
      }
      ASSERT_EQ(numbers, *first) << packet;
    } else {
      ASSERT_FALSE(first) << packet;
    }
  }
  EXPECT_GT(good, kLeastGood);
}

TEST(SecondDecoder, AgreesWithTheDriverOnLmsTelegrams) {
  Rng rng{2};
  int good = 0;
  for (int i = 0; i < kPackets; ++i) {
    lms::ScanData scan{.millimetres = below(rng, 2) == 0, .values = std::vector<std::uint16_t>(1 + below(rng, 8))};
    for (auto& value : scan.values) value = static_cast<std::uint16_t>(rng.bits());
    scan.status = static_cast<std::uint8_t>(rng.bits());
    lms::Payload payload = lms::payload_of(scan);
    payload.insert(payload.end() - 1, below(rng, 3), std::uint8_t{0x55});
    if (below(rng, 4) == 0) damage(payload, rng);  // with a good CRC
    if (payload.empty()) continue;
    const std::string text = lms::bytes_of(lms::kFromLaser, payload);
    std::vector<std::uint8_t> packet{text.begin(), text.end()};
    damage(packet, rng);

    lms::TelegramReader reader{lms::kFromLaser};
    const auto events = reader.take(packet);
    std::optional<lms::ScanData> read;
    if (events.size() == 1 && events[0].payload.size() + 6 == packet.size()) read = lms::parse_scan(events[0].payload);
    const auto first = second::lms_scan(packet);
    ASSERT_EQ(read.has_value(), first.has_value()) << "packet " << i;
    if (!read) continue;
    ++good;
    Numbers numbers{read->millimetres ? 1 : 0, read->status};
    numbers.insert(numbers.end(), read->values.begin(), read->values.end());
    ASSERT_EQ(numbers, *first) << "packet " << i;
  }
  EXPECT_GT(good, kLeastGood);
}

TEST(SecondDecoder, AgreesWithTheDriverOnColaTelegrams) {
  Rng rng{3};
  int good = 0;
  for (int i = 0; i < kPackets; ++i) {
    cola::ScanData scan{.status = static_cast<int>(below(rng, 6)), .telegram_count = below(rng, 0x10000)};
    scan.scan_time_us = static_cast<std::uint32_t>(rng.bits());
    scan.send_time_us = static_cast<std::uint32_t>(rng.bits());
    scan.frequency_centihz = below(rng, 10'000);
    for (std::uint32_t k = below(rng, 3); k > 0; --k) {
      cola::Channel channel{.name = k == 2 ? "DIST1" : "RSSI1",
                            .angle_step = static_cast<std::int32_t>(below(rng, 9999))};
      channel.start_angle = static_cast<std::int32_t>(rng.bits());
      for (std::uint32_t v = below(rng, 5); v > 0; --v)
        channel.values.push_back(static_cast<std::uint16_t>(rng.bits() & 0x1FF));
      scan.channels.push_back(std::move(channel));
    }
    std::string text = cola::text_of(scan, below(rng, 2) == 0 ? "sSN" : "sRA");
    damage(text, rng);

    const auto read = cola::parse_scan(text);
    const auto first = second::cola_scan(text);
    ASSERT_EQ(read.has_value(), first.has_value()) << text;
    if (!read) continue;
    ++good;
    Numbers numbers{read->status,       read->telegram_count, read->scan_count,
                    read->scan_time_us, read->send_time_us,   read->frequency_centihz};
    for (const auto& channel : read->channels) {
      numbers.push_back(channel.start_angle);
      numbers.push_back(channel.angle_step);
      numbers.push_back(static_cast<std::int64_t>(channel.values.size()));
      numbers.insert(numbers.end(), channel.values.begin(), channel.values.end());
    }
    ASSERT_EQ(numbers, *first) << text;
  }
  EXPECT_GT(good, kLeastGood);
}

}  // namespace
}  // namespace tandem
