#include "services/bus/stop_reasons.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tandem::bus {
namespace {

TEST(StopReasons, HaveWordsOfTheirOwn) {
  std::set<std::string> words;
  for (std::uint32_t i = msg::STOP_NONE; i <= msg::STOP_TWO_COMMANDERS; ++i) {
    words.insert(words_of(static_cast<msg::StopReason>(i)));
  }
  EXPECT_EQ(words.size(), msg::STOP_TWO_COMMANDERS + 1u);
  EXPECT_FALSE(words.contains("unknown reason"));
}

}  // namespace
}  // namespace tandem::bus
