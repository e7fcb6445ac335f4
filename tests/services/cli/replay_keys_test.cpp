#include "services/cli/replay_keys.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

using recorder::ReplayWish;

TEST(ReplayKeys, SpacePausesAndGoesOn) {
  ReplayKeys keys;
  EXPECT_EQ(keys.wish_after(""), ReplayWish::Play);
  EXPECT_EQ(keys.wish_after(" "), ReplayWish::Pause);
  EXPECT_EQ(keys.wish_after(""), ReplayWish::Pause);
  EXPECT_EQ(keys.wish_after(" "), ReplayWish::Play);
}

TEST(ReplayKeys, EachPointIsOneStepAndPauses) {
  ReplayKeys keys;
  EXPECT_EQ(keys.wish_after(".."), ReplayWish::Step);
  EXPECT_TRUE(keys.is_paused());
  EXPECT_EQ(keys.wish_after(""), ReplayWish::Step);
  EXPECT_EQ(keys.wish_after(""), ReplayWish::Pause);
  EXPECT_EQ(keys.wish_after(". "), ReplayWish::Play);  // and none is left over
  EXPECT_EQ(keys.wish_after(" "), ReplayWish::Pause);
}

TEST(ReplayKeys, QEnds) {
  ReplayKeys keys;
  EXPECT_EQ(keys.wish_after("xq"), ReplayWish::End);
}

}  // namespace
}  // namespace tandem::cli
