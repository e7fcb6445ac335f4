#include "robot/laser/core/cola_telegram.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem::cola {
namespace {

std::vector<std::string> take(TelegramReader& reader, const std::string& bytes) {
  return reader.take({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

TEST(ColaTelegram, StandsBetweenStxAndEtx) {
  EXPECT_EQ(bytes_of("sRN STlms"), "\x02sRN STlms\x03");
  EXPECT_EQ(words_of("sAN SetAccessMode 1"), (Words{"sAN", "SetAccessMode", "1"}));
  EXPECT_EQ(words_of("a  b "), (Words{"a", "", "b", ""}));
}

TEST(ColaTelegram, APlainNumberIsHexadecimalASignedOneDecimal) {
  EXPECT_EQ(parse_number("1F"), 31);
  EXPECT_EQ(parse_number("+19"), 19);
  EXPECT_EQ(parse_number("-19"), -19);
  EXPECT_EQ(parse_number("FFFFFFFF"), 4'294'967'295);
  for (const auto* word : {"", "+", "-", "+-1", "G", "1G", "100000000", " 1", "0x1"})
    EXPECT_FALSE(parse_number(word)) << word;
}

TEST(ColaTelegram, AnAngleIsSigned) {
  EXPECT_EQ(parse_signed("FFF92230"), -450'000);  // -45 deg
  EXPECT_EQ(parse_signed("-450000"), -450'000);
  EXPECT_EQ(parse_signed("1388"), 5000);
  EXPECT_FALSE(parse_signed("+4294967295"));
}

TEST(ColaTelegram, AFloatIsItsBits) {
  EXPECT_EQ(parse_float("3F800000"), 1.0f);
  EXPECT_EQ(parse_float("40000000"), 2.0f);
  EXPECT_EQ(hexadecimal_float(2.0f), "40000000");
  EXPECT_FALSE(parse_float("7F800000"));  // infinite
}

TEST(ColaTelegram, SeveralMayComeInOneRead) {
  TelegramReader reader;
  EXPECT_EQ(take(reader, "\x02one\x03\x02two\x03\x02thr"), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(take(reader, "ee\x03"), std::vector<std::string>{"three"});
  EXPECT_EQ(reader.damaged(), 0u);
}

TEST(ColaTelegram, MayBeSplitAnywhere) {
  const std::string bytes = bytes_of("sSN LMDscandata 1") + bytes_of("sAN Run 1");
  for (std::size_t split = 0; split <= bytes.size(); ++split) {
    TelegramReader reader;
    auto texts = take(reader, bytes.substr(0, split));
    for (std::string& text : take(reader, bytes.substr(split))) texts.push_back(std::move(text));
    ASSERT_EQ(texts, (std::vector<std::string>{"sSN LMDscandata 1", "sAN Run 1"})) << split;
  }
}

TEST(ColaTelegram, OneWithoutAnEndIsCountedAndTheNextIsRead) {
  TelegramReader reader;
  EXPECT_EQ(take(reader, "\x02half of it\x02whole\x03"), std::vector<std::string>{"whole"});
  EXPECT_EQ(reader.damaged(), 1u);
}

TEST(ColaTelegram, IsFoundWithinTwoFramesAfterNoise) {
  Rng rng{5};
  const std::string good = bytes_of("sSN LMDscandata 1 2 3");
  for (int round = 0; round < 2000; ++round) {
    TelegramReader reader;
    std::string bytes;
    const std::size_t noise = rng.index(200);
    for (std::size_t i = 0; i < noise; ++i) bytes.push_back(static_cast<char>(rng.bits()));
    bytes += good + good;
    std::vector<std::string> texts;
    for (const char byte : bytes) {
      for (std::string& text : take(reader, std::string(1, byte))) texts.push_back(std::move(text));
    }
    ASSERT_FALSE(texts.empty()) << "round " << round;
    ASSERT_EQ(texts.back(), "sSN LMDscandata 1 2 3") << "round " << round;
  }
}

TEST(ColaTelegram, OneThatNeverEndsIsDropped) {
  TelegramReader reader;
  EXPECT_TRUE(take(reader, "\x02" + std::string(TelegramReader::kMostCharacters + 1, 'x')).empty());
  EXPECT_EQ(reader.damaged(), 1u);
  EXPECT_EQ(take(reader, "\x02good\x03"), std::vector<std::string>{"good"});
}

TEST(ColaTelegram, RecognisesTheBinaryForm) {
  TelegramReader reader;
  const std::string binary{"\x02\x02\x02\x02\x00\x00\x00\x09sAN Run\x00\x33", 18};
  EXPECT_TRUE(take(reader, binary.substr(0, 3)).empty());
  EXPECT_FALSE(reader.saw_binary());
  (void)take(reader, binary.substr(3));
  EXPECT_TRUE(reader.saw_binary());
}

}  // namespace
}  // namespace tandem::cola
