#include "services/planner/core/srs/reward_world.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

/// Three sources in a row with pools of 1, and an event.
RewardWorld row() {
  RewardSource event;
  event.id = "event";
  event.pool = 1.0;
  return world_of({"x", "y"}, {disc_source("a", {0, 0}, 1, 1, 1), disc_source("b", {5, 0}, 1, 1, 1),
                               disc_source("c", {10, 0}, 1, 1, 1), event});
}

std::string problem_after(const std::function<void(RewardWorld&)>& edit) {
  RewardWorld world = row();
  edit(world);
  const auto problem = problem_of(world);
  return problem ? problem->where + ": " + problem->what : "";
}

TEST(RewardWorld, NamesACircleOfStrictRelations) {
  RewardWorld world = row();
  EXPECT_FALSE(add_relation(world, strict("a", "b")));
  EXPECT_FALSE(add_relation(world, strict("b", "c")));
  const auto problem = add_relation(world, strict("c", "a"));

  ASSERT_TRUE(problem);
  EXPECT_NE(problem->what.find("a => b => c => a"), std::string::npos) << problem->what;
  EXPECT_EQ(world.relations.size(), 2u);
}

TEST(RewardWorld, ACircleOfSoftRelationsIsAnExclusion) {
  RewardWorld world = row();
  EXPECT_FALSE(add_relation(world, soft("a", "b")));
  EXPECT_FALSE(add_relation(world, soft("b", "a")));
}

TEST(RewardWorld, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(problem_after([](RewardWorld&) {}), "");
  const std::vector<std::pair<std::function<void(RewardWorld&)>, std::string>> faults{
      {[](RewardWorld& w) { w.sources[1].id = "a"; }, "sources[1]: id"},
      {[](RewardWorld& w) {
         w.sources[1].boundary = Disc{{0, 0}, 0.0};
       },
       "sources[1]: boundary"},
      {[](RewardWorld& w) {
         w.sources[1].boundary = Attached{"z", Disc{{0, 0}, 1.0}};
       },
       "sources[1]: boundary"},
      {[](RewardWorld& w) { w.sources[1].pool = -1.0; }, "sources[1]: pool"},
      {[](RewardWorld& w) { w.sources[1].pool = 0.0; }, "sources[1]: pool"},
      {[](RewardWorld& w) { w.sources[1].targets = {"z"}; }, "sources[1]: targets"},
      {[](RewardWorld& w) {
         w.sources[1].tempers = {{"x", -1.0, 1.0}};
       },
       "sources[1]: tempers: x"},
      {[](RewardWorld& w) {
         w.sources[1].outside = {RatioShape::Ramp, 1, -1, 1, {}};
       },
       "sources[1]: outside"},
      {[](RewardWorld& w) { w.relations = {strict("a", "z")}; }, "relations[0]: to"},
      {[](RewardWorld& w) { w.relations = {strict("a", "a")}; }, "relations[0]"},
      {[](RewardWorld& w) { w.relations = {soft("a", "b", {"z"})}; }, "relations[0]: agents"},
      {[](RewardWorld& w) { w.relations = {codependent("a", "b", 1.5)}; }, "relations[0]: coupling"},
      {[](RewardWorld& w) {
         w.relations = {soft("a", "b"), soft("a", "b")};
       },
       "relations[1]"},
      {[](RewardWorld& w) {
         w.relations = {codependent("a", "b", 0.5), codependent("b", "a", 0.5)};
       },
       "relations[1]"},
      {[](RewardWorld& w) {
         w.sources[0].pool = std::numeric_limits<double>::infinity();
         w.relations = {strict("a", "b")};
       },
       "relations[0]: trigger"},
      {[](RewardWorld& w) {
         w.groups = {{"g", {"a", "b"}, 1.0}};
       },
       "groups[0]: members"},
      {[](RewardWorld& w) {
         w.unawareness = {{"x", {"z"}}};
       },
       "knowledge: x"},
      {[](RewardWorld& w) {
         w.agents = {"x", "x"};
       },
       "agents"},
  };
  for (const auto& [edit, where] : faults) {
    const std::string problem = problem_after(edit);
    EXPECT_TRUE(problem.starts_with(where + ": ")) << where << " / " << problem;
  }
}

TEST(RewardWorld, ARemovedSourceTakesItsRelationsAlong) {
  RewardWorld world = row();
  world.relations = {strict("a", "b"), soft("b", "c"), soft("a", "event")};
  world.unawareness = {{"x", {"b"}}};
  EXPECT_TRUE(remove_source(world, "b"));
  EXPECT_EQ(world.relations, std::vector<Relation>{soft("a", "event")});
  EXPECT_FALSE(problem_of(world));
  EXPECT_EQ(world.version, 1u);
  EXPECT_FALSE(remove_source(world, "b"));
  EXPECT_EQ(world.version, 1u);
}

TEST(RewardWorld, AnEditThatWouldBreakItChangesNothing) {
  RewardWorld world = row();
  const RewardWorld before = world;
  EXPECT_TRUE(add_source(world, disc_source("a", {0, 0}, 1, 1)));
  EXPECT_EQ(world, before);
  EXPECT_FALSE(add_source(world, disc_source("d", {0, 0}, 1, 1)));
  EXPECT_EQ(world.version, 1u);
  EXPECT_FALSE(add_relation(world, soft("d", "a")));
  EXPECT_TRUE(remove_relation(world, RelationKind::Soft, "d", "a"));
  EXPECT_EQ(world.version, 3u);
}

}  // namespace
}  // namespace tandem
