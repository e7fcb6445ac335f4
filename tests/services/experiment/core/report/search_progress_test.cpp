#include "services/experiment/core/report/search_progress.hpp"

#include <gtest/gtest.h>

namespace tandem::experiment {
namespace {

EpisodeLog episode_with(double duration_s, std::initializer_list<std::array<double, 3>> beliefs) {
  EpisodeLog log;
  log.duration_s = duration_s;
  for (const auto& [time_s, robot, all] : beliefs) {
    log.beliefs.push_back({.time_s = time_s, .explored = all, .explored_robot = robot});
  }
  return log;
}

TEST(ExploredAt, IsWhatWasKnownByThen) {
  const auto log = episode_with(20.0, {{1.0, 0.1, 0.1}, {5.0, 0.2, 0.3}});
  EXPECT_DOUBLE_EQ(explored_at(log, 0.5).by_all, 0.0);
  EXPECT_DOUBLE_EQ(explored_at(log, 1.0).by_all, 0.1);
  EXPECT_DOUBLE_EQ(explored_at(log, 4.9).by_all, 0.1);
  EXPECT_DOUBLE_EQ(explored_at(log, 30.0).by_robot, 0.2);
  EXPECT_EQ(belief_at(log, 0.5), nullptr);
  EXPECT_DOUBLE_EQ(explored_at(log, 5.0 - 1e-9).by_all, 0.3) << "seconds of stamps are not exact";
}

TEST(ExploredLine, EndsAtTheEnd) {
  const auto line = explored_line(episode_with(12.0, {{0.0, 0.1, 0.2}, {11.0, 0.4, 0.6}}), 5.0);
  ASSERT_EQ(line.size(), 4U);  // 0, 5, 10, 12
  EXPECT_DOUBLE_EQ(line[2].by_all, 0.2);
  EXPECT_DOUBLE_EQ(line[3].time_s, 12.0);
  EXPECT_DOUBLE_EQ(line[3].by_all, 0.6);
}

TEST(MeanExplored, IsOverTheEpisodesThatGoOn) {
  const auto a = episode_with(15.0, {{0.0, 0.2, 0.4}});
  const auto b = episode_with(5.0, {{0.0, 0.4, 0.8}});
  const std::vector<const EpisodeLog*> both{&a, &b};
  const auto means = mean_explored(both, 5.0);
  ASSERT_EQ(means.size(), 3U);
  EXPECT_EQ(means[0].ongoing, 2U);
  EXPECT_DOUBLE_EQ(means[0].by_robot, 0.3);
  EXPECT_DOUBLE_EQ(means[0].by_all, 0.6);
  EXPECT_EQ(means[1].ongoing, 1U);
  EXPECT_DOUBLE_EQ(means[1].by_all, 0.4);
}

}  // namespace
}  // namespace tandem::experiment
