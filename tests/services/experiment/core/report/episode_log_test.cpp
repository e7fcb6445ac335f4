#include "services/experiment/core/report/episode_log.hpp"

#include <gtest/gtest.h>

namespace tandem::experiment {
namespace {

EpisodeLog of_laptop() {
  EpisodeLog log;
  log.robot = "robot1";
  log.code = "P07";
  log.started_ns = 5;
  log.outcome = "found";
  log.duration_s = 60.0;
  log.fields = {{"ease", "6"}};
  log.beliefs = {{.time_s = 1.0}};
  log.robot_poses = {{0.0, {}}, {0.1, {}}};
  log.human_poses = {{0.0, {}}, {1.0, {}}, {2.0, {}}};
  log.passers_by = {{0.0, {}}, {1.0, {}}};
  return log;
}

EpisodeLog of_robot() {
  EpisodeLog log;
  log.robot = "robot1";
  log.code = "P07";
  log.started_ns = 5;
  log.robot_poses = {{0.0, {}}, {0.05, {}}, {0.1, {}}};
  log.human_poses = {{0.0, {}}};
  log.human_is_true = true;
  log.collisions = 2;
  log.base = {{0.0, 0.5, false, {}}};
  return log;
}

TEST(EpisodeLog, OfBothHostsIsOneSearch) {
  EXPECT_TRUE(is_same_search(of_laptop(), of_robot()));
  auto later = of_robot();
  later.started_ns = 6;
  EXPECT_FALSE(is_same_search(of_laptop(), later));
}

TEST(EpisodeLog, MergedKeepsWhatHoldsMoreAndWhatIsTrue) {
  for (const auto& log : {merged(of_laptop(), of_robot()), merged(of_robot(), of_laptop())}) {
    EXPECT_EQ(log.outcome, "found");
    EXPECT_DOUBLE_EQ(log.duration_s, 60.0);
    EXPECT_EQ(log.beliefs.size(), 1U);
    EXPECT_EQ(log.robot_poses.size(), 3U);
    EXPECT_EQ(log.base.size(), 1U);
    EXPECT_TRUE(log.human_is_true);
    EXPECT_EQ(log.human_poses.size(), 1U);
    EXPECT_TRUE(log.passers_by.empty()) << "the truth says that there were none";
    EXPECT_EQ(log.collisions, 2U);
    EXPECT_EQ(log.fields.at("ease"), "6");
  }
}

TEST(EpisodeLog, SaysWhatItLacks) {
  EXPECT_EQ(gaps_of(EpisodeLog{}).size(), 6U);
  EXPECT_EQ(gaps_of(of_laptop()), (std::vector<std::string>{"the person's way is as tracked",
                                                            "no base_status: stops are not known", "no map"}));
}

}  // namespace
}  // namespace tandem::experiment
