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
  EXPECT_FALSE(exchange.is_asked_for({{"laptop1", ""}}));  // we have none either
  exchange.own_is("a");
  EXPECT_FALSE(exchange.is_asked_for({}));
  EXPECT_FALSE(exchange.is_asked_for({{"laptop1", "a"}}));
  EXPECT_FALSE(exchange.is_asked_for({{"laptop1", "b"}}));  // it keeps its own
  EXPECT_TRUE(exchange.is_asked_for({{"laptop1", "a"}, {"robot1", ""}}));
}

TEST(MapExchange, AMapThatWasBroughtIsNotSentOn) {
  MapExchange exchange{kStart, seconds{5}};
  exchange.brought_is("b");
  EXPECT_FALSE(exchange.is_asked_for({{"laptop1", ""}}));
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

TEST(MapExchange, MapsThatDifferForLongAreNamed) {
  const std::vector<HeldMap> others{{"laptop2", "a"}, {"laptop1", "b"}};
  MapExchange exchange{kStart, seconds{5}};
  exchange.own_is("a");
  EXPECT_FALSE(exchange.other_map(others, kStart));
  EXPECT_FALSE(exchange.other_map(others, kStart + seconds{5}));
  const auto other = exchange.other_map(others, kStart + seconds{6});
  ASSERT_TRUE(other);
  EXPECT_EQ(other->host, "laptop1");
  EXPECT_EQ(other->sha256, "b");
}

TEST(MapExchange, HostsThatWereGivenTheSameMapOneAfterTheOtherAreNot) {
  MapExchange exchange{kStart, seconds{5}};
  exchange.own_is("a");
  EXPECT_FALSE(exchange.other_map({{"laptop1", "b"}}, kStart));
  exchange.own_is("b");
  EXPECT_FALSE(exchange.other_map({{"laptop1", "b"}}, kStart + seconds{4}));
  EXPECT_FALSE(exchange.other_map({{"laptop1", "c"}}, kStart + seconds{8}));  // the time counts anew
}

TEST(MapExchange, AHostWithoutAMapDiffersFromNobody) {
  MapExchange exchange{kStart, seconds{5}};
  EXPECT_FALSE(exchange.other_map({{"laptop1", "b"}}, kStart));
  EXPECT_FALSE(exchange.other_map({{"laptop1", "b"}}, kStart + seconds{20}));
  exchange.own_is("a");
  EXPECT_FALSE(exchange.other_map({{"laptop1", ""}}, kStart + seconds{40}));
  EXPECT_FALSE(exchange.other_map({{"laptop1", ""}}, kStart + seconds{60}));
}

}  // namespace
}  // namespace tandem
