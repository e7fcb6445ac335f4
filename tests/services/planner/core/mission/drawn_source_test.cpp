#include "services/planner/core/mission/drawn_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "services/common/random.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using Kind = SourceEdit::Kind;

const std::array<std::string, 2> kTeam{"robot", "person"};
const PlanarShape kSquare = Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};

SourceEdit edit(Kind kind, std::vector<std::string> targets = {}) {
  SourceEdit edit;
  edit.kind = kind;
  edit.source_id = "s1";
  edit.region = kSquare;
  edit.targets = std::move(targets);
  return edit;
}

TEST(DrawnSource, APlaceToAvoidCostsByTheSecond) {
  SourceEdit avoid = edit(Kind::Avoid, {"robot"});
  avoid.strength = "very";
  EXPECT_EQ(problem_of(avoid, kTeam), std::nullopt);
  const RewardSource source = drawn_source(avoid);
  EXPECT_EQ(source.id, "s1");
  EXPECT_DOUBLE_EQ(rate_at(source, {1, 1}), -3.0);
  EXPECT_DOUBLE_EQ(rate_at(source, {3, 1}), 0.0);
  EXPECT_TRUE(is_target(source, "robot"));
  EXPECT_FALSE(is_target(source, "person"));
}

TEST(DrawnSource, APlaceToGoToPaysOnce) {
  const RewardSource source = drawn_source(edit(Kind::GoTo, {"person"}));
  EXPECT_DOUBLE_EQ(rate_at(source, {1, 1}), 1.0);
  EXPECT_DOUBLE_EQ(source.pool, 1.0);
}

TEST(DrawnSource, APlaceToPassThroughPaysOnce) {
  SourceEdit through = edit(Kind::PassThrough, {"robot"});
  through.strength = "very";
  EXPECT_EQ(problem_of(through, kTeam), std::nullopt);
  const RewardSource source = drawn_source(through);
  EXPECT_DOUBLE_EQ(rate_at(source, {1, 1}), 3.0);
  EXPECT_DOUBLE_EQ(source.pool, 1.0);
  EXPECT_FALSE(is_target(source, "person"));
}

TEST(DrawnSource, WhatLiesAheadOfSomebodyCostsWhoStaysBehindThem) {
  SourceEdit behind = edit(Kind::StayBehind, {"robot"});
  behind.who = "person";
  behind.strength = "a bit";
  EXPECT_EQ(problem_of(behind, kTeam), std::nullopt);
  const RewardSource source = drawn_source(behind);
  EXPECT_EQ(source.kind, SourceKind::Interaction);
  const auto& attached = std::get<Attached>(source.boundary);
  EXPECT_EQ(attached.agent, "person");
  EXPECT_TRUE(contains(attached.shape_in_agent, {0.5, 3.0}));  // in the person's frame
  EXPECT_FALSE(contains(attached.shape_in_agent, {-0.5, 3.0}));
  EXPECT_NEAR(peak_of(source.inside), -1.0 / 3.0, 1e-9);
}

TEST(DrawnSource, OneMustBeSentOnly) {
  EXPECT_EQ(problem_of(edit(Kind::GoTo, {"person"}), kTeam), std::nullopt);
  EXPECT_TRUE(problem_of(edit(Kind::GoTo), kTeam));
  EXPECT_TRUE(problem_of(edit(Kind::GoTo, {"person", "robot"}), kTeam));
  EXPECT_TRUE(problem_of(edit(Kind::PassThrough), kTeam));
}

TEST(DrawnSource, WhatCannotBeHonouredIsRefusedWithAReason) {
  EXPECT_EQ(problem_of(edit(Kind::StayBehind), kTeam), "it is not said behind whom");
  EXPECT_EQ(problem_of(edit(Kind::Avoid, {"drone"}), kTeam), "nobody in the team is called drone");
  SourceEdit nameless = edit(Kind::Remove);
  nameless.source_id.clear();
  EXPECT_TRUE(problem_of(nameless, kTeam));
  SourceEdit vague = edit(Kind::Avoid);
  vague.strength = "somewhat";
  EXPECT_EQ(problem_of(vague, kTeam), "nobody knows how much \"somewhat\" is");
  SourceEdit endless = edit(Kind::Avoid);
  endless.region = HalfPlane{{0, 0}, {1, 0}};
  EXPECT_TRUE(problem_of(endless, kTeam));
}

TEST(DrawnSource, DiscsCoverAShapeAndLittleElse) {
  const PlanarShape triangle = Polygon{{{0, 0}, {3, 0}, {0, 4}}};
  const auto discs = covering_discs(triangle);
  ASSERT_FALSE(discs.empty());
  Rng rng{5};
  for (int i = 0; i < 2000; ++i) {
    const Vector2d point{rng.uniform(-2, 5), rng.uniform(-2, 6)};
    const bool covered = std::ranges::any_of(
        discs, [&](const BlockedDisc& disc) { return (disc.centre_in_map - point).norm() <= disc.radius_m; });
    if (contains(triangle, point)) {
      EXPECT_TRUE(covered) << point.transpose();
    } else if (signed_distance(triangle, point) > 0.5) {
      EXPECT_FALSE(covered) << point.transpose();
    }
  }
}

TEST(DrawnSource, ALargeShapeTakesFewDiscs) {
  const auto discs = covering_discs(Disc{{0, 0}, 100.0});
  EXPECT_GT(discs.size(), 100U);
  EXPECT_LT(discs.size(), 1500U);
}

}  // namespace
}  // namespace tandem
