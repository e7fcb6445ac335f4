#include "services/bus/core/rtps_message.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "tests/support/rtps_datagram.hpp"

namespace tandem::bus {
namespace {

using test::RtpsDatagram;
using Bytes = RtpsDatagram::Bytes;
using Kind = RtpsSubmessage::Kind;

constexpr std::array<std::uint8_t, 12> kRelay{1, 15, 7};
const Bytes kPayload{0, 1, 0, 0, 42, 0, 0, 0};
const Bytes kKeyHash{0x70, 0, 16, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
const Bytes kEnd{1, 0, 0, 0};

Bytes joined(Bytes first, const Bytes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(RtpsMessage, SaysWhatEachSubmessageTellsOfSamplesInEitherOrderOfBytes) {
  for (const auto order : {RtpsDatagram::Order::LittleEndian, RtpsDatagram::Order::BigEndian}) {
    RtpsDatagram datagram{kRelay, order};
    datagram.between({0, 0, 3, 2}, {0, 0, 4, 7});
    datagram.data(5, kPayload).heartbeat(2, 5).gap(3, 4).answer(6, 33).data_fragment(6, 2, 8, 12);
    const auto said = submessages_of(datagram.bytes());
    ASSERT_TRUE(said);
    struct Row {
      Kind kind;
      std::int64_t first;
      std::int64_t last;
    };
    const Row rows[] = {
        {Kind::Sample, 5, 5}, {Kind::Available, 2, 5}, {Kind::Gap, 3, 4}, {Kind::Answer, 6, 39}, {Kind::Sample, 6, 6}};
    ASSERT_EQ(said->size(), std::size(rows));
    for (std::size_t i = 0; i < std::size(rows); ++i) {
      EXPECT_EQ((*said)[i].kind, rows[i].kind) << i;
      EXPECT_EQ((*said)[i].first, rows[i].first) << i;
      EXPECT_EQ((*said)[i].last, rows[i].last) << i;
      EXPECT_EQ((*said)[i].source, kRelay) << i;
      EXPECT_EQ((*said)[i].writer, (EntityId{0, 0, 3, 2})) << i;
      EXPECT_EQ((*said)[i].reader, (EntityId{0, 0, 4, 7})) << i;
    }
  }
}

TEST(RtpsMessage, NumbersHaveSixtyFourBits) {
  const auto said = submessages_of(RtpsDatagram{}.data(0x1'0000'0002, kPayload).data(-1, kPayload).bytes());
  ASSERT_TRUE(said && said->size() == 2);
  EXPECT_EQ((*said)[0].first, 0x1'0000'0002);
  EXPECT_EQ((*said)[1].first, -1);
}

TEST(RtpsMessage, ASourceThatIsNamedHoldsForWhatFollows) {
  const Bytes named{0, 0, 0, 0, 2, 3, 1, 15, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9};
  const auto said =
      submessages_of(RtpsDatagram{kRelay}.data(1, kPayload).submessage(0x0c, 0, named).data(2, kPayload).bytes());
  ASSERT_TRUE(said && said->size() == 2);
  EXPECT_EQ((*said)[0].source, kRelay);
  EXPECT_EQ((*said)[1].source, (ParticipantId{9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9}));
}

TEST(RtpsMessage, WhatIsWellFormedIsRead) {
  const std::pair<const char*, Bytes> rows[] = {
      {"a header alone", RtpsDatagram{}.bytes()},
      {"parameters and a payload", RtpsDatagram{}.data(1, joined(joined(kKeyHash, kEnd), kPayload), 0x06).bytes()},
      {"parameters alone", RtpsDatagram{}.data(1, joined(kKeyHash, kEnd), 0x02).bytes()},
      {"a last submessage that is not padded", RtpsDatagram{}.data(1, {0, 1, 0, 0, 42}).bytes()},
      {"a last submessage of no length", joined(RtpsDatagram{}.data(1, kPayload).submessage(0x30, 0, {}).bytes(), {1})},
      {"no time", RtpsDatagram{}.submessage(0x09, 0x02, {}).data(1, kPayload).bytes()},
      {"padding", RtpsDatagram{}.submessage(0x01, 0, {}).data(1, kPayload).bytes()},
      {"another vendor's submessage", RtpsDatagram{}.submessage(0x80, 0, {1, 2, 3, 4}).bytes()},
      {"encrypted submessages", RtpsDatagram{}.submessage(0x31, 0, Bytes(20)).submessage(0x30, 0, Bytes(12)).bytes()},
      {"an answer that asks for nothing", RtpsDatagram{}.answer(1, 0).bytes()},
      {"the last piece, which is shorter", RtpsDatagram{}.data_fragment(1, 2, 1000, 1001).bytes()},
  };
  for (const auto& [what, bytes] : rows) EXPECT_TRUE(submessages_of(bytes)) << what;
}

TEST(RtpsMessage, WhatIsMalformedIsNot) {
  Bytes newer = RtpsDatagram{}.bytes();
  newer[4] = 3;
  Bytes far_payload = RtpsDatagram{}.data(1, kPayload).bytes();
  far_payload[20 + 4 + 2] = 200;  // octets to the content
  Bytes near_payload = RtpsDatagram{}.data(1, kPayload).bytes();
  near_payload[20 + 4 + 2] = 12;
  const std::pair<const char*, Bytes> rows[] = {
      {"nothing", {}},
      {"noise", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24}},
      {"another version", newer},
      {"half a submessage's header", joined(RtpsDatagram{}.bytes(), {0x15, 1})},
      {"a length beyond the end", joined(RtpsDatagram{}.bytes(), {0x15, 1, 200, 0, 1, 2, 3, 4})},
      {"a sample without a number", RtpsDatagram{}.submessage(0x15, 0, {0, 0, 16, 0, 0, 0, 0, 0}).bytes()},
      {"a payload behind the end", far_payload},
      {"a payload inside the header", near_payload},
      {"payload and key", RtpsDatagram{}.data(1, kPayload, 0x0c).bytes()},
      {"parameters without end", RtpsDatagram{}.data(1, kKeyHash, 0x02).bytes()},
      {"a parameter beyond the end", RtpsDatagram{}.data(1, {0x50, 0, 40, 0, 1, 0, 0, 0}, 0x02).bytes()},
      {"a short key", RtpsDatagram{}.data(1, {0x70, 0, 4, 0, 1, 1, 1, 1, 1, 0, 0, 0}, 0x02).bytes()},
      {"a set that is too large", RtpsDatagram{}.answer(1, 257).bytes()},
      {"a heartbeat cut short", RtpsDatagram{}.submessage(0x07, 0, Bytes(24)).bytes()},
      {"a time cut short", RtpsDatagram{}.submessage(0x09, 0, {1, 2, 3, 4}).bytes()},
      {"a destination cut short", RtpsDatagram{}.submessage(0x0e, 0, {1, 2, 3, 4}).bytes()},
      {"a source cut short", RtpsDatagram{}.submessage(0x0c, 0, Bytes(16)).bytes()},
      {"the piece before the first", RtpsDatagram{}.data_fragment(1, 0, 8, 12).bytes()},
      {"a piece behind the last", RtpsDatagram{}.data_fragment(1, 3, 8, 12).bytes()},
      {"pieces of nothing", RtpsDatagram{}.data_fragment(1, 1, 0, 12).bytes()},
      {"a piece of a gigabyte", RtpsDatagram{}.data_fragment(1, 1, 8, 1U << 30).bytes()},
  };
  for (const auto& [what, bytes] : rows) EXPECT_FALSE(submessages_of(bytes)) << what;
}

TEST(RtpsMessage, NoMutationAndNoCutIsReadBeyondItsEnd) {
  const Bytes whole = RtpsDatagram{}
                          .data(1, joined(joined(kKeyHash, kEnd), kPayload), 0x06)
                          .heartbeat(1, 2)
                          .gap(1, 3)
                          .answer(4, 64)
                          .data_fragment(5, 1, 16, 100)
                          .bytes();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    std::ignore = submessages_of(std::span{whole}.first(length));
  }
  Rng rng{3};
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes = whole;
    for (std::size_t changes = 1 + rng.index(4); changes > 0; --changes) {
      bytes[rng.index(bytes.size())] = rng.index(3) == 0 ? 0xff : static_cast<std::uint8_t>(rng.bits());
    }
    // A copy of just its size: the sanitizers see a byte that is read behind it.
    const auto said = submessages_of(Bytes{bytes});
    EXPECT_TRUE(!said || said->size() <= bytes.size() / 4) << "seed 3, mutation " << i;
  }
}

}  // namespace
}  // namespace tandem::bus
