#include "services/tracking/core/track_score.hpp"

#include <gtest/gtest.h>

namespace tandem::tracking {
namespace {

TEST(TrackScore, CountsWhoIsFoundHowWellAndWhoIsNobody) {
  TrackScore score{0.5};
  score.add({{"a", {0.0, 0.0}}, {"b", {5.0, 0.0}}}, {{1, {0.1, 0.0}}, {2, {9.0, 0.0}}});
  score.add({{"a", {1.0, 0.0}}}, {{1, {1.3, 0.0}}});
  EXPECT_EQ(score.moments(), 2u);
  EXPECT_EQ(score.annotations(), 3u);
  EXPECT_NEAR(*score.recall(), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(*score.median_m(), 0.3, 1e-12);
  EXPECT_NEAR(score.false_per_moment(), 0.5, 1e-12);
  EXPECT_EQ(score.id_switches(), 0u);
}

TEST(TrackScore, LetsAPersonKeepTheirTrackThoughAnotherIsNearer) {
  TrackScore score{0.5};
  score.add({{"a", {0.0, 0.0}}}, {{1, {0.0, 0.0}}});
  score.add({{"a", {0.0, 0.0}}}, {{1, {0.4, 0.0}}, {2, {0.1, 0.0}}});
  EXPECT_EQ(score.id_switches(), 0u);
  score.add({{"a", {0.0, 0.0}}}, {{1, {0.6, 0.0}}, {2, {0.1, 0.0}}});
  EXPECT_EQ(score.id_switches(), 1u) << "out of the gate";
}

TEST(TrackScore, TakesEveryTrackForFalseWhereNobodyIs) {
  TrackScore score{0.5};
  score.add({}, {{1, {0.0, 0.0}}, {2, {1.0, 0.0}}});
  score.add({}, {});
  EXPECT_EQ(score.recall(), std::nullopt);
  EXPECT_EQ(score.median_m(), std::nullopt);
  EXPECT_NEAR(score.false_per_moment(), 1.0, 1e-12);
}

TEST(TrackScore, GivesEachTrackToOnePersonAlone) {
  TrackScore score{0.5};
  score.add({{"a", {0.0, 0.0}}, {"b", {0.2, 0.0}}}, {{1, {0.1, 0.0}}});
  EXPECT_NEAR(*score.recall(), 0.5, 1e-12);
}

}  // namespace
}  // namespace tandem::tracking
