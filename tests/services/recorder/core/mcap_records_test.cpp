#include "services/recorder/core/mcap_records.hpp"

#include <gtest/gtest.h>

namespace tandem::mcap {
namespace {

TEST(McapRecords, BeginWithOpcodeAndLengthInLittleEndian) {
  Bytes bytes;
  append(bytes, DataEnd{0x01020304});
  EXPECT_EQ(bytes, (Bytes{0x0F, 4, 0, 0, 0, 0, 0, 0, 0, 4, 3, 2, 1}));
}

TEST(McapRecords, ComeBackAsTheyWere) {
  Bytes bytes;
  append(bytes, Channel{3, 2, "scan", "cdr", {{"host", "robot1"}}});
  const auto channel = parse<Channel>(ByteView{bytes}.subspan(kRecordHead));

  ASSERT_TRUE(channel);
  EXPECT_EQ(channel->id, 3);
  EXPECT_EQ(channel->schema_id, 2);
  EXPECT_EQ(channel->topic, "scan");
  EXPECT_EQ(channel->message_encoding, "cdr");
  EXPECT_EQ(channel->metadata.at("host"), "robot1");
}

TEST(McapRecords, ARecordCutShortAnywhereIsNone) {
  Bytes bytes;
  append(bytes, Channel{3, 2, "scan", "cdr", {{"host", "robot1"}}});
  const ByteView content = ByteView{bytes}.subspan(kRecordHead);
  for (std::size_t size = 0; size < content.size(); ++size) EXPECT_FALSE(parse<Channel>(content.first(size))) << size;
}

TEST(McapRecords, TheChecksumIsThatOfZlibAndCanBeContinued) {
  const Bytes digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc32_of(digits), 0xCBF43926U);  // the check value of CRC-32
  EXPECT_EQ(crc32_of(ByteView{digits}.subspan(4), crc32_of(ByteView{digits}.first(4))), 0xCBF43926U);
}

}  // namespace
}  // namespace tandem::mcap
