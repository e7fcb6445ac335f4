#include "services/cli/report/episode_reader.hpp"

#include <gtest/gtest.h>

#include "services/cli/study/study_run.hpp"
#include "services/experiment/core/report/report.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/services/cli/report/scripted_recording.hpp"
#include "tests/services/experiment/core/episode/room_scenario.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

class EpisodeReader : public testing::Test {
 protected:
  static std::vector<experiment::EpisodeLog> read(const std::filesystem::path& file) {
    mcap::Reader recording{mcap::file_source(file.string()), file.string()};
    return read_episodes(recording, file.stem().string(), [](double) { return true; });
  }

  test::TemporaryFolder folder_;
};

TEST_F(EpisodeReader, ReadsAScriptedSearch) {
  const auto file = folder_ / "one.mcap";
  recorder::write_recording(file, [](mcap::Writer& writer) { test::write_scripted_search(writer, "s1", 1.7e9); });
  const auto logs = read(file);
  ASSERT_EQ(logs.size(), 1U);
  const auto& log = logs.front();
  EXPECT_EQ(log.name, "one");
  EXPECT_EQ(log.code, "s1");
  EXPECT_TRUE(log.found());
  EXPECT_EQ(log.found_by, "human1");
  EXPECT_NEAR(log.duration_s, 120.0, 1e-6);
  EXPECT_EQ(log.presses.size(), 13U) << "each once, however often it was told";
  EXPECT_NEAR(log.presses.front().time_s, -3.0, 1e-6);
  ASSERT_EQ(log.plans.size(), 5U) << "each standing once";
  EXPECT_EQ(log.plans[1].state, experiment::PlanAt::State::Accepted);
  EXPECT_EQ(log.plans[0].paths.size(), 2U);
  EXPECT_DOUBLE_EQ(log.plans[0].lower_bound_s, 70.0);
  EXPECT_EQ(log.beliefs.size(), 13U);
  EXPECT_EQ(log.fields.at("ease"), "6");
  EXPECT_EQ(log.fields.at("reminder"), "toast");
  EXPECT_FALSE(log.fields.contains("layer belief"));
  ASSERT_TRUE(log.map);
  EXPECT_EQ(log.map->width(), 50);
  ASSERT_TRUE(log.object_in_map);
  EXPECT_DOUBLE_EQ(log.object_in_map->x(), 3.0);
}

TEST_F(EpisodeReader, ItsNumbersAreThoseOfTheScript) {
  const auto file = folder_ / "one.mcap";
  recorder::write_recording(file, [](mcap::Writer& writer) { test::write_scripted_search(writer, "s1", 1.7e9); });
  const auto report = experiment::make_report(read(file), {});
  const auto& rows = report.groups[0].my_pose;
  EXPECT_NEAR(rows[0].rate.per_min, 7.0, 1e-6);
  EXPECT_NEAR(rows[0].rate.within, 6.0 / 7.0, 1e-9);
  EXPECT_NEAR(rows[1].rate.per_min, 7.0 / 1.5, 1e-6);
  EXPECT_NEAR(rows[3].rate.per_min, 4.0, 1e-6);
  EXPECT_NEAR(rows[3].rate.within, 0.75, 1e-9);
  const auto& metrics = report.episodes[0];
  EXPECT_NEAR(metrics.explored.value(), 0.8, 1e-9);
  EXPECT_NEAR(metrics.explored_robot.value(), 0.5, 1e-9);
  EXPECT_NEAR(metrics.explored_human.value(), 0.3, 1e-9);
  EXPECT_EQ(metrics.plans, 3);
  EXPECT_EQ(metrics.rejected, 1);
  EXPECT_EQ(metrics.stop_count, 2);
  EXPECT_NEAR(metrics.teammate.mean_m, 1.0, 1e-6);
  EXPECT_NEAR(metrics.passers_by.nearest_m, std::hypot(1.0, 1.5), 0.01) << "the teammate is no passer-by";
  const auto shares = experiment::role_shares(read(file)[0]);
  EXPECT_NEAR(shares[0], 50.0 / 120.0, 1e-6);
  EXPECT_NEAR(shares[1], 30.0 / 120.0, 1e-6);
  EXPECT_NEAR(shares[2], 40.0 / 120.0, 1e-6);
}

TEST_F(EpisodeReader, TellsTheSessionsOfOneRecordingApart) {
  const auto file = folder_ / "two.mcap";
  recorder::write_recording(file, [](mcap::Writer& writer) {
    test::write_scripted_search(writer, "first", 1.7e9);
    test::write_scripted_search(writer, "second", 1.7e9 + 600.0);
  });
  const auto logs = read(file);
  ASSERT_EQ(logs.size(), 2U);
  EXPECT_EQ(logs[0].name, "two first");
  EXPECT_EQ(logs[1].code, "second");
  for (const auto& log : logs) {
    EXPECT_EQ(log.presses.size(), 13U);
    EXPECT_EQ(log.plans.size(), 5U);
    EXPECT_EQ(log.fields.at("expert"), "yes");
    EXPECT_NEAR(log.duration_s, 120.0, 1e-6);
  }
}

TEST_F(EpisodeReader, ARecordingWithoutASessionHasNoEpisode) {
  const auto file = folder_ / "none.mcap";
  recorder::write_recording(file, [](mcap::Writer&) {});
  EXPECT_TRUE(read(file).empty());
}

// What the study counts itself and what the report counts from the recordings are one.
TEST_F(EpisodeReader, AStudysRecordingsGiveTheStudysNumbers) {
  StudyPlan plan{
      .scenario = experiment::hall_scenario(), .map = experiment::hall_map(), .team = experiment::quick_team()};
  plan.episodes = 4;
  plan.recordings = folder_.path();
  StudyFile file{experiment::StudySettings{
      .scenario = "hall", .planner = "any", .human = "obedient", .seed = 1, .config_hash = "x"}};
  play_study(plan, file, [](std::uint64_t) { return true; });
  for (const auto& result : file.episodes(1, 4)) {
    const auto logs = read(study_recording(plan, result.seed));
    ASSERT_EQ(logs.size(), 1U);
    const auto metrics = experiment::metrics_of(logs[0]);
    EXPECT_EQ(metrics.found, result.found);
    EXPECT_NEAR(metrics.time_s, result.time_s, 0.01);
    EXPECT_NEAR(metrics.explored.value(), result.explored, 1e-4);
    EXPECT_NEAR(metrics.explored_robot.value(), result.explored_robot, 1e-4);
    EXPECT_NEAR(metrics.explored_human.value(), result.explored_human, 1e-4);
    EXPECT_EQ(metrics.plans, result.plans);
    EXPECT_EQ(logs[0].found_by, result.found_by == "robot" ? "robot1" : result.found_by.empty() ? "" : "human1");
    const auto spans = experiment::role_spans(logs[0]);
    ASSERT_EQ(spans.size(), result.roles.size());
    for (std::size_t i = 0; i < spans.size(); ++i) EXPECT_NEAR(spans[i].from_s, result.roles[i].time_s, 0.01);
    EXPECT_NEAR(metrics.human.distance_m, result.human_distance_m, 0.05 * result.human_distance_m + 0.75)
        << "half a second is missing at either end";
  }
}

TEST_F(EpisodeReader, RecordingChangesNoEpisode) {
  StudyPlan plan{
      .scenario = experiment::hall_scenario(), .map = experiment::hall_map(), .team = experiment::quick_team()};
  plan.episodes = 2;
  const experiment::StudySettings settings{
      .scenario = "hall", .planner = "any", .human = "obedient", .seed = 1, .config_hash = "x"};
  StudyFile without{settings};
  play_study(plan, without, [](std::uint64_t) { return true; });
  plan.recordings = folder_.path();
  StudyFile with{settings};
  play_study(plan, with, [](std::uint64_t) { return true; });
  EXPECT_EQ(experiment::study_csv(without.episodes(1, 2)), experiment::study_csv(with.episodes(1, 2)));
}

}  // namespace
}  // namespace tandem::cli
