#include "services/relay/core/map_exchange.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

using std::chrono::seconds;

constexpr Time kStart{seconds{100}};

TEST(MapExchange, AHostAsksForAMapWhenItsServerHadTimeToPublishOne) {
  const MapExchange exchange{kStart, seconds{5}};
  EXPECT_EQ(exchange.holding(kStart + seconds{4}), std::nullopt);
  EXPECT_EQ(exchange.holding(kStart + seconds{5}), "");
}

TEST(MapExchange, AHostSaysWhatItHas) {
  MapExchange exchange{kStart, seconds{5}};
  exchange.brought_is("b");
  EXPECT_EQ(exchange.holding(kStart), "b");
  exchange.own_is("a");
  EXPECT_EQ(exchange.holding(kStart), "a");
}

TEST(MapExchange, AMapIsSentOnlyToWhomHasNone) {
  MapExchange exchange{kStart, seconds{5}};
  EXPECT_FALSE(exchange.is_asked_for({""}));  // we have none either
  exchange.own_is("a");
  EXPECT_FALSE(exchange.is_asked_for({}));
  EXPECT_FALSE(exchange.is_asked_for({"a"}));
  EXPECT_FALSE(exchange.is_asked_for({"b"}));  // it keeps its own
  EXPECT_TRUE(exchange.is_asked_for({"a", ""}));
}

TEST(MapExchange, AMapThatWasBroughtIsNotSentOn) {
  MapExchange exchange{kStart, seconds{5}};
  exchange.brought_is("b");
  EXPECT_FALSE(exchange.is_asked_for({""}));
}

TEST(MapExchange, OnlyAHostWithoutItsOwnTakesAMapAndEachOnce) {
  MapExchange exchange{kStart, seconds{5}};
  EXPECT_TRUE(exchange.is_welcome("b"));
  exchange.brought_is("b");
  EXPECT_FALSE(exchange.is_welcome("b"));
  EXPECT_TRUE(exchange.is_welcome("c"));
  exchange.own_is("a");
  EXPECT_FALSE(exchange.is_welcome("c"));
}

}  // namespace
}  // namespace tandem
