#include "bench/planning/srs_worlds/srs_world.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(SrsWorld, EverySeedGivesAUsableTaskOfTheSizeAskedFor) {
  bool has_kind[3] = {false, false, false};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const TaskProblem problem = random_srs_task(seed);
    EXPECT_FALSE(problem_of(problem)) << "seed " << seed;
    EXPECT_LE(problem.agents.size(), 3U);
    const auto tasks =
        std::ranges::count_if(problem.world.sources, [](const RewardSource& s) { return s.kind == SourceKind::Task; });
    EXPECT_GE(tasks, 5) << "seed " << seed;
    EXPECT_LE(tasks, 8) << "seed " << seed;
    for (const Relation& relation : problem.world.relations) has_kind[static_cast<int>(relation.kind)] = true;
  }
  EXPECT_TRUE(has_kind[0] && has_kind[1] && has_kind[2]);
}

TEST(SrsWorld, EqualSeedsGiveEqualTasks) {
  EXPECT_EQ(random_srs_task(7).world, random_srs_task(7).world);
  EXPECT_FALSE(random_srs_task(7).world == random_srs_task(8).world);
}

}  // namespace
}  // namespace tandem::bench
