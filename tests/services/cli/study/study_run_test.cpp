#include "services/cli/study/study_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "services/cli/command.hpp"
#include "services/common/file_io.hpp"
#include "tests/services/experiment/core/episode/room_scenario.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

/// A study of a few short episodes in a hall, in a folder of its own.
class StudyRun : public testing::Test {
 protected:
  void SetUp() override {}

  static StudyPlan plan(std::uint64_t episodes, unsigned threads) {
    StudyPlan plan{
        .scenario = experiment::hall_scenario(), .map = experiment::hall_map(), .team = experiment::quick_team()};
    plan.episodes = episodes;
    plan.threads = threads;
    return plan;
  }
  static experiment::StudySettings settings(const std::string& human = "obedient") {
    return {.scenario = "hall", .planner = "any", .human = human, .seed = 1, .rollouts = 5, .config_hash = "x"};
  }
  /// What the file holds after a run that was ended after `enough` episodes.
  std::string run(const std::string& name, const StudyPlan& plan, std::uint64_t enough = 1000) {
    StudyFile file(settings(), folder_ / name);
    play_study(plan, file, [&](std::uint64_t finished) { return finished < enough; });
    return read_file(folder_ / name);
  }

  test::TemporaryFolder folder_;
};

TEST_F(StudyRun, OneThreadAndTwoGiveTheSameFile) {
  const std::string one = run("one", plan(6, 1));
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 7);  // settings and six episodes
  EXPECT_EQ(run("two", plan(6, 2)), one);
}

TEST_F(StudyRun, ARunThatGoesOnGivesTheFileOfOneRun) {
  const std::string whole = run("whole", plan(6, 1));
  const std::string part = run("parts", plan(6, 1), 2);
  EXPECT_LT(part.size(), whole.size());
  EXPECT_EQ(run("parts", plan(6, 1)), whole);
}

TEST_F(StudyRun, MoreEpisodesGoOnBehindThoseThatAreThere) {
  (void)run("a", plan(2, 1));
  EXPECT_EQ(run("a", plan(5, 1)), run("b", plan(5, 1)));
}

TEST_F(StudyRun, AHalfWrittenLineIsPlayedAgain) {
  const std::string whole = run("whole", plan(3, 1));
  write_file_atomically(folder_ / "torn", whole.substr(0, whole.size() - 40));
  EXPECT_EQ(run("torn", plan(3, 1)), whole);
}

TEST_F(StudyRun, AnotherStudysFileIsRefused) {
  (void)run("a", plan(1, 1));
  EXPECT_THROW(StudyFile(settings("own"), folder_ / "a"), WrongUse);
}

TEST_F(StudyRun, WhatFailsInAThreadIsThrown) {
  StudyPlan wrong = plan(4, 2);
  wrong.human = "nobody";
  StudyFile file(settings("nobody"));
  EXPECT_THROW(play_study(wrong, file, [](std::uint64_t) { return true; }), std::invalid_argument);
}

TEST_F(StudyRun, EveryPlanMayHaveATimeInsteadOfRollouts) {
  StudyPlan timed = plan(2, 1);
  timed.team.planner.rollouts = 1'000'000;
  timed.budget_ms = 1.0;
  StudyFile file(settings());
  play_study(timed, file, [](std::uint64_t) { return true; });
  EXPECT_EQ(file.episodes(1, 2).size(), 2U);
}

}  // namespace
}  // namespace tandem::cli
