#include "services/recorder/core/message_table.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

using Cells = std::vector<std::string>;

constexpr const char* kIdl = R"(module m {
  enum Colour { RED, GREEN };
  struct Point { double x; /* wide */ // [m]
  };
  struct S {
    string name;
    boolean good;
    Point at;
    sequence<Point> way;
    short pair[2];
    Colour colour;
    sequence<octet> picture;
  };
};)";

MessageTable table() {
  return *MessageTable::of(*idl::parse(kIdl), "m::S");
}

/// CDR, little-endian: name "ab", true, at 1.5, way 2 and 3, pair -1 and 7, GREEN, three octets.
const mcap::Bytes kMessage{0,    1,    0, 0,                        // encapsulation
                           3,    0,    0, 0, 'a', 'b', 0,           // name
                           1,                                       // good
                           0,    0,    0, 0, 0,   0,   0xF8, 0x3F,  // at.x = 1.5
                           2,    0,    0, 0, 0,   0,   0,    0,     // two points; doubles lie at multiples of 8
                           0,    0,    0, 0, 0,   0,   0x00, 0x40,  // 2
                           0,    0,    0, 0, 0,   0,   0x08, 0x40,  // 3
                           0xFF, 0xFF, 7, 0,                        // pair
                           1,    0,    0, 0,                        // GREEN
                           3,    0,    0, 0, 9,   9,   9};

TEST(MessageTable, NamesColumnsAsTheIdlDoes) {
  EXPECT_EQ(table().columns(),
            (Cells{"name", "good", "at.x [m]", "way.x [m]", "pair[0]", "pair[1]", "colour", "picture.size"}));
  EXPECT_FALSE(MessageTable::of(*idl::parse(kIdl), "m::T"));
}

TEST(MessageTable, PutsEachValueIntoItsColumn) {
  EXPECT_EQ(table().row_of(kMessage), (Cells{"ab", "true", "1.5", "2 3", "-1", "7", "GREEN", "3"}));
}

TEST(MessageTable, AnEmptySequenceIsAnEmptyCell) {
  const auto small =
      *MessageTable::of(*idl::parse("struct P { double x; }; struct S { sequence<P> way; octet last; };"), "S");
  EXPECT_EQ(small.row_of(mcap::Bytes{0, 1, 0, 0, 0, 0, 0, 0, 5}), (Cells{"", "5"}));
}

TEST(MessageTable, ReadsBigEndianToo) {
  const auto small = *MessageTable::of(*idl::parse("struct S { long a; };"), "S");
  EXPECT_EQ(small.row_of(mcap::Bytes{0, 0, 0, 0, 0, 0, 1, 2}), Cells{"258"});
}

TEST(MessageTable, WhatIsCutShortHasNoRow) {
  for (std::size_t length = 0; length < kMessage.size(); ++length) {
    EXPECT_FALSE(table().row_of(mcap::ByteView{kMessage}.first(length))) << length;
  }
}

}  // namespace
}  // namespace tandem::recorder
