#include "robot/laser/core/scip_encoding.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem::scip {
namespace {

TEST(ScipChecksum, IsTheLowSixBitsOfTheSumPlus0x30) {
  EXPECT_EQ(checksum("00"), 'P');
  EXPECT_EQ(checksum("99"), 'b');
  EXPECT_EQ(checksum("02"), 'R');
  EXPECT_EQ(checksum("0E"), 'e');
}

TEST(ScipNumber, IsSixBitsPerCharacterMostSignificantFirst) {
  EXPECT_EQ(encode_number(1234, 2), "CB");
  EXPECT_EQ(encode_number(5432, 3), "1Dh");
  EXPECT_EQ(encode_number(16'000'000, 4), "m2@0");
  EXPECT_EQ(decode_number("CB"), 1234u);
  EXPECT_EQ(decode_number("1Dh"), 5432u);
  EXPECT_EQ(decode_number("m2@0"), 16'000'000u);
}

TEST(ScipNumber, ComesBackFromAnyEncoding) {
  Rng rng{5};
  for (int i = 0; i < 1000; ++i) {
    const auto value = static_cast<std::uint32_t>(rng.bits() & 0x3FFFF);
    EXPECT_EQ(decode_number(encode_number(value, 3)), value);
  }
}

TEST(ScipNumber, IsNotOneWithOtherCharacters) {
  EXPECT_FALSE(decode_number(""));
  EXPECT_FALSE(decode_number("0/0"));  // '/' is just below '0'
  EXPECT_FALSE(decode_number("0p0"));  // 'p' just above 'o'
  EXPECT_FALSE(decode_number("000000"));
}

TEST(ScipDecimal, HasFixedWidthAndOnlyDigits) {
  EXPECT_EQ(decimal(44, 4), "0044");
  EXPECT_EQ(parse_decimal("0044"), 44);
  EXPECT_FALSE(parse_decimal("+044"));
  EXPECT_FALSE(parse_decimal("004 "));
  EXPECT_FALSE(parse_decimal(""));
}

}  // namespace
}  // namespace tandem::scip
