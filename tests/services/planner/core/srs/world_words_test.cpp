#include "services/planner/core/srs/world_words.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tandem {
namespace {

/// Each word once, each value once: then reading undoes writing.
template <typename Value, std::size_t Count>
void expect_one_to_one(const Words<Value, Count>& words) {
  std::set<std::string_view> names;
  std::set<Value> values;
  for (const auto& [word, value] : words) {
    names.insert(word);
    values.insert(value);
    EXPECT_EQ(word_of(words, value), word);
  }
  EXPECT_EQ(names.size(), Count);
  EXPECT_EQ(values.size(), Count);
}

TEST(WorldWords, AreOneToOne) {
  expect_one_to_one(kSourceKindWords);
  expect_one_to_one(kFlowWords);
  expect_one_to_one(kRatioShapeWords);
  expect_one_to_one(kRelationKindWords);
  expect_one_to_one(kTriggerWords);
}

TEST(WorldWords, AValueWithoutAWordHasNone) {
  constexpr Words<RatioShape, 1> kOne{{{"ramp", RatioShape::Ramp}}};
  EXPECT_EQ(word_of(kOne, RatioShape::Ramp), "ramp");
  EXPECT_EQ(word_of(kOne, RatioShape::Constant), "");
}

}  // namespace
}  // namespace tandem
