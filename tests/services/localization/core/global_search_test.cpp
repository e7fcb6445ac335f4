#include "services/localization/core/global_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "services/common/random.hpp"
#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

/// What a search needs of a map.
struct Place {
  explicit Place(OccupancyGrid grid)
      : map(std::move(grid)), field(map, DistanceField{map, 2.0}, {}), search(map, field) {}
  [[nodiscard]] std::vector<Eigen::Vector2d> seen_from(const Pose2& pose) const {
    return selected_endpoints(test::scan_from(map, pose, Time{}), 90, 25.0, {});
  }
  OccupancyGrid map;
  LikelihoodField field;
  GlobalSearch search;
};

/// The same room turned by half a turn looks the same.
OccupancyGrid symmetric_room() {
  OccupancyGrid room{60, 40, 0.1, {}, CellState::Free};
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 60; ++column) {
      if (row == 0 || column == 0 || row == 39 || column == 59) room.set({column, row}, CellState::Occupied);
    }
  }
  return room;
}

TEST(GlobalSearch, FindsThePlaceOfAScanAnywhereInTheRoom) {
  const Place room{test::uneven_room()};
  Rng rng{3};
  for (int i = 0; i < 20; ++i) {
    const Pose2 truth{rng.uniform(1.5, 3.8), rng.uniform(0.5, 2.8), rng.uniform(-3.0, 3.0)};
    // Half a turn of a laser may see a plain corner alone.
    std::vector<Eigen::Vector2d> endpoints = room.seen_from(truth);
    const Pose2 about{0.0, 0.0, std::numbers::pi};
    for (const Eigen::Vector2d& endpoint : room.seen_from(truth * about)) endpoints.push_back(about * endpoint);
    const auto found = room.search.candidates(endpoints, {});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR((found.front().map_from_base.position() - truth.position()).norm(), 0.0, 0.2) << "sample " << i;
    EXPECT_NEAR(turn_between(found.front().map_from_base.heading, truth.heading), 0.0, 0.1) << "sample " << i;
  }
}

TEST(GlobalSearch, FindsBothPlacesOfASymmetricRoom) {
  const Place room{symmetric_room()};
  const auto found = room.search.candidates(room.seen_from({2.0, 1.5, 0.4}), {});

  ASSERT_GE(found.size(), 2U);
  EXPECT_NEAR(found[0].score, found[1].score, 0.03);
  // (2, 1.5) and, half a turn around the centre (3, 2), (4, 2.5).
  EXPECT_NEAR((found[0].map_from_base.position() + found[1].map_from_base.position()).x(), 6.0, 0.3);
  EXPECT_NEAR((found[0].map_from_base.position() + found[1].map_from_base.position()).y(), 4.0, 0.3);
  EXPECT_NEAR(std::abs(turn_between(found[0].map_from_base.heading, found[1].map_from_base.heading)), std::numbers::pi,
              0.1);
}

TEST(GlobalSearch, FindsNothingBetterThanTheBestOfAllPoses) {
  const Place room{test::uneven_room()};
  const auto endpoints = room.seen_from({2.5, 1.2, 0.7});
  GlobalSearchOptions options;
  options.step_rad = 0.1;
  options.count = 1;

  double best = 0.0;
  const int headings = static_cast<int>(std::ceil(2.0 * std::numbers::pi / options.step_rad));
  for (int row = 0; row < room.map.height(); ++row) {
    for (int column = 0; column < room.map.width(); ++column) {
      if (!room.map.is_free({column, row})) continue;
      const Eigen::Vector2d centre = room.map.centre_in_map({column, row});
      for (int i = 0; i < headings; ++i) {
        const double heading = wrap_to_pi(2.0 * std::numbers::pi * i / headings);
        best = std::max(best, room.search.score_at({centre.x(), centre.y(), heading}, endpoints));
      }
    }
  }
  // The search rounds an end to the lattice from the base, score_at from the map: they may differ by half a cell.
  EXPECT_NEAR(room.search.candidates(endpoints, options).front().score, best, 0.03);
}

TEST(GlobalSearch, DoesNoMoreAtATimeThanItIsAllowed) {
  const Place room{test::uneven_room()};
  const auto endpoints = room.seen_from({2.5, 1.2, 0.7});
  const auto expected = room.search.candidates(endpoints, {});

  GlobalSearchRun run{room.search, endpoints, {}};
  std::size_t pieces = 0;
  for (; !run.is_done(); ++pieces) run.advance(room.search, 50);

  EXPECT_GT(pieces, 250U / 50U);  // 252 headings are begun with, at least
  ASSERT_EQ(run.candidates().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(run.candidates()[i].map_from_base, expected[i].map_from_base);
    EXPECT_EQ(run.candidates()[i].score, expected[i].score);
  }
}

TEST(GlobalSearch, FindsNothingBelowTheFloorItIsGiven) {
  const Place room{test::uneven_room()};
  const auto endpoints = room.seen_from({2.5, 1.2, 0.7});
  GlobalSearchOptions options;
  const double best = room.search.candidates(endpoints, options).front().score;

  options.floor = best;
  EXPECT_FALSE(room.search.candidates(endpoints, options).empty());
  options.floor = best + 0.01;
  EXPECT_TRUE(room.search.candidates(endpoints, options).empty());
}

TEST(GlobalSearch, TurnsWithTheMap) {
  const OccupancyGrid straight = test::uneven_room();
  const Pose2 turn{10.0, -4.0, 1.1};
  OccupancyGrid turned{straight.width(), straight.height(), straight.resolution_m(), turn};
  std::copy(straight.cells().begin(), straight.cells().end(), turned.cells().begin());
  const Place before{straight};
  const Place after{turned};
  const auto endpoints = before.seen_from({2.5, 1.2, 0.7});

  const auto a = before.search.candidates(endpoints, {});
  const auto b = after.search.candidates(endpoints, {});
  ASSERT_EQ(a.size(), b.size());
  const Pose2 expected = turn * a.front().map_from_base;
  EXPECT_NEAR((b.front().map_from_base.position() - expected.position()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(turn_between(b.front().map_from_base.heading, expected.heading), 0.0, 1e-9);
}

TEST(GlobalSearch, FindsNoPlaceWhereNoneIsFree) {
  const Place wall{test::ascii_map({"###", "###"}, 0.1)};
  const std::vector<Eigen::Vector2d> endpoints{{0.1, 0.0}};

  EXPECT_TRUE(wall.search.candidates(endpoints, {}).empty());
  EXPECT_TRUE(Place{test::uneven_room()}.search.candidates({}, {}).empty());
}

TEST(GlobalSearch, StaysWithinAnArea) {
  const Place room{symmetric_room()};
  const Pose2 truth{2.0, 1.5, 0.4};
  GlobalSearchOptions options;
  options.within = PoseArea{.centre_in_map = {2.2, 1.4, 0.3}, .half_side_m = 0.5, .half_turn_rad = 0.3};
  const auto found = room.search.candidates(room.seen_from(truth), options);
  ASSERT_EQ(found.size(), 1U);  // the other place of the symmetric room is out of it
  EXPECT_LT((found[0].map_from_base.position() - truth.position()).norm(), 0.2);
  options.within->centre_in_map = {2.0, 1.5, 2.0};
  for (const Candidate& candidate : room.search.candidates(room.seen_from(truth), options)) {
    EXPECT_LE(std::abs(turn_between(2.0, candidate.map_from_base.heading)), 0.3);
  }
}

}  // namespace
}  // namespace tandem
