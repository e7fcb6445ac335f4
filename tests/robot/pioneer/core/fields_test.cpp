#include "robot/pioneer/core/fields.hpp"

#include <gtest/gtest.h>

namespace tandem::pioneer {
namespace {

TEST(Fields, AreLittleEndianAndTextsEndWithZero) {
  Bytes bytes;
  FieldWriter write{bytes};
  write(std::int16_t{-2});
  write(std::string{"ab"});
  write(std::uint32_t{0x01020304});

  EXPECT_EQ(bytes, (Bytes{0xFE, 0xFF, 'a', 'b', 0, 4, 3, 2, 1}));
}

TEST(Fields, AreReadAsTheyWereWritten) {
  const Bytes bytes{0xFE, 0xFF, 'a', 'b', 0, 4, 3, 2, 1};
  FieldReader read{bytes};
  std::int16_t number = 0;
  std::string text;
  std::uint32_t word = 0;
  read(number);
  read(text);
  read(word);

  EXPECT_EQ(number, -2);
  EXPECT_EQ(text, "ab");
  EXPECT_EQ(word, 0x01020304U);
  EXPECT_FALSE(read.ended());
}

TEST(Fields, AFieldBehindTheEndKeepsItsValueAndSoDoAllAfterIt) {
  const Bytes bytes{1, 2, 3};
  FieldReader read{bytes};
  std::uint32_t word = 42;
  std::uint8_t byte = 7;
  std::optional<std::uint8_t> maybe;
  read(word);
  read(byte);  // although one byte would have been there
  read(maybe);

  EXPECT_EQ(word, 42U);
  EXPECT_EQ(byte, 7);
  EXPECT_FALSE(maybe);
  EXPECT_TRUE(read.ended());
}

TEST(Fields, ATextWithoutItsZeroEndsWithTheBytes) {
  const Bytes bytes{'a', 'b'};
  FieldReader read{bytes};
  std::string text;
  read(text);
  EXPECT_EQ(text, "ab");
  read(text);
  EXPECT_TRUE(read.ended());
}

TEST(Fields, AfterTheFirstAbsentOneNoneIsWritten) {
  Bytes bytes;
  FieldWriter write{bytes};
  write(std::optional<std::uint8_t>{1});
  write(std::optional<std::uint8_t>{});
  write(std::optional<std::uint8_t>{3});
  EXPECT_EQ(bytes, Bytes{1});
}

}  // namespace
}  // namespace tandem::pioneer
