// Laws of docs/srs_model.md on random worlds: T3, T20, T23, T24.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "services/common/random.hpp"
#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

/// Sources of all kinds in a square of 10 m, with tempers, relations and a group.
RewardWorld random_world(Rng& rng) {
  RewardWorld world = world_of({"a", "b", "c"}, {});
  for (int i = 0; i < 8; ++i) {
    const double per_s = rng.uniform(-2.0, 3.0);
    RewardSource source = disc_source("s" + std::to_string(i), {rng.uniform(0, 10), rng.uniform(0, 10)},
                                      rng.uniform(0.5, 4.0), per_s, std::copysign(rng.uniform(0.5, 6.0), per_s));
    if (i == 1) source.inside = {RatioShape::Ramp, 0.0, per_s, 1.0, {}};
    if (i == 2) source.boundary = Attached{"b", Disc{{1, 0}, 2.0}};
    if (i == 3) source.boundary = Between{Anchor{.agent = "c"}, Anchor{.agent = "", .point_in_map = {5, 5}}, 1.0};
    if (i == 4) source.outside = {RatioShape::Exponential, per_s, 0.0, 1.0, {}};
    if (i == 5) source.tempers = {{"a", 2.0, 1.0}, {"c", 0.5, 1.0}};
    if (i >= 6) {
      source.inside = constant_ratio(std::abs(per_s));
      source.pool = std::numeric_limits<double>::infinity();
    }
    world.sources.push_back(source);
  }
  world.relations = {strict("s0", "s1"), soft("s2", "s3"), codependent("s4", "s5", rng.uniform())};
  world.groups = {{"g", {"s6", "s7"}, rng.uniform(1.0, 4.0)}};
  return world;
}

std::vector<AgentMove> random_moves(Rng& rng) {
  std::vector<AgentMove> moves;
  for (int i = 0; i < 3; ++i) {
    moves.push_back(straight_move({rng.uniform(0, 10), rng.uniform(0, 10)}, {rng.uniform(0, 10), rng.uniform(0, 10)}));
    moves.back().to_heading_rad += rng.uniform(-1.0, 1.0);
  }
  return moves;
}

TEST(SrsProperty, T20NoPoolPaysMoreThanItHolds) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Rng rng{seed};
    const RewardWorld world = random_world(rng);
    ASSERT_FALSE(problem_of(world)) << seed;
    Course course{world};
    for (int i = 0; i < 10; ++i) course.advance(random_moves(rng), rng.uniform(0.5, 8.0));
    double from_group = 0.0;
    for (std::size_t source = 0; source < 8; ++source) {
      double paid = 0.0;
      for (std::size_t agent = 0; agent < 3; ++agent) paid += course.record().paid[source * 3 + agent];
      if (source >= 6) {
        from_group += paid;
      } else {
        EXPECT_LE(std::abs(paid), std::abs(world.sources[source].pool) + 1e-9) << seed << " " << source;
      }
    }
    EXPECT_LE(from_group, world.groups[0].pool + 1e-9) << seed;
  }
}

TEST(SrsProperty, T20TheSameCourseGivesTheSameBits) {
  Rng rng{5};
  const RewardWorld world = random_world(rng);
  const auto moves = random_moves(rng);
  Course one{world};
  Course other{world};
  EXPECT_EQ(one.advance(moves, 7.0), other.advance(moves, 7.0));
  EXPECT_EQ(one.account().state(), other.account().state());
}

TEST(SrsProperty, T3SplittingAMoveInARandomWorldChangesNothing) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng{seed};
    const RewardWorld world = random_world(rng);
    const auto moves = random_moves(rng);
    const double cut = rng.uniform(0.1, 0.9);
    Course whole{world};
    Course split{world};
    const auto expected = whole.advance(moves, 6.0);
    std::vector<AgentMove> first;
    std::vector<AgentMove> second;
    for (const auto& move : moves) {
      first.push_back(part_of(move, 0.0, cut));
      second.push_back(part_of(move, cut, 1.0));
    }
    const auto before = split.advance(first, 6.0 * cut);
    const auto after = split.advance(second, 6.0 * (1.0 - cut));
    for (std::size_t agent = 0; agent < 3; ++agent) {
      EXPECT_NEAR(before[agent] + after[agent], expected[agent], 1e-9) << seed;
    }
  }
}

TEST(SrsProperty, T20RelabellingTheAgentsChangesNothing) {
  Rng rng{3};
  const RewardWorld world = random_world(rng);
  const auto moves = random_moves(rng);
  RewardWorld relabelled = world;
  relabelled.agents = {"c", "b", "a"};
  const auto expected = Course{world}.advance(moves, 7.0);
  const auto got = Course{relabelled}.advance({moves[2], moves[1], moves[0]}, 7.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[2 - i], expected[i], 1e-9);
}

TEST(SrsProperty, T23AfterAnEditTheWorldIsAsIfItHadAlwaysBeenSo) {
  Rng rng{8};
  RewardWorld edited = random_world(rng);
  const RewardWorld before = edited;
  const auto moves = random_moves(rng);
  ASSERT_FALSE(add_source(edited, disc_source("new", {5, 5}, 9.0, 1.0, 2.0)));
  ASSERT_FALSE(add_relation(edited, strict("new", "s1")));
  EXPECT_NE((Course{edited}.advance(moves, 7.0)), (Course{before}.advance(moves, 7.0)));
  ASSERT_TRUE(remove_source(edited, "new"));
  EXPECT_EQ(edited.relations, before.relations);
  EXPECT_EQ(edited.version, before.version + 3);
  EXPECT_EQ((Course{edited}.advance(moves, 7.0)), (Course{before}.advance(moves, 7.0)));
}

TEST(SrsProperty, T24ScalingAllRewardsScalesWhatIsPaid) {
  Rng rng{21};
  const RewardWorld world = random_world(rng);
  RewardWorld scaled = world;
  constexpr double kFactor = 7.0;
  for (auto& source : scaled.sources) {
    source.inside.boundary_per_s *= kFactor;
    source.inside.far_per_s *= kFactor;
    source.outside.boundary_per_s *= kFactor;
    source.pool *= kFactor;
  }
  scaled.groups[0].pool *= kFactor;
  const auto moves = random_moves(rng);
  const auto one = Course{world}.advance(moves, 7.0);
  const auto many = Course{scaled}.advance(moves, 7.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(many[i], kFactor * one[i], 1e-8);
}

TEST(SrsProperty, T24TurningTheMapChangesNothing) {
  Rng rng{22};
  const Eigen::Vector2d origin{3, -2};
  constexpr double kTurn_rad = 0.7;
  const auto turned = [&](const Eigen::Vector2d& point) {
    return std::get<Disc>(moved(Disc{point, 1.0}, origin, kTurn_rad)).centre;
  };
  const RewardWorld world = random_world(rng);
  RewardWorld other = world;
  for (auto& source : other.sources) {
    if (auto* disc = std::get_if<Disc>(&source.boundary)) disc->centre = turned(disc->centre);
    if (auto* between = std::get_if<Between>(&source.boundary)) between->to.point_in_map = turned({5, 5});
  }
  const auto moves = random_moves(rng);
  auto turned_moves = moves;
  for (auto& move : turned_moves) {
    move.from_in_map = turned(move.from_in_map);
    move.to_in_map = turned(move.to_in_map);
    move.from_heading_rad += kTurn_rad;
    move.to_heading_rad += kTurn_rad;
  }
  const auto expected = Course{world}.advance(moves, 7.0);
  const auto got = Course{other}.advance(turned_moves, 7.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], 1e-8);
}

}  // namespace
}  // namespace tandem
