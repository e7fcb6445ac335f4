#include "services/experiment/core/report/report.hpp"

#include <gtest/gtest.h>

namespace tandem::experiment {
namespace {

EpisodeLog episode_with(double duration_s, const std::string& condition, const std::string& who, double rating) {
  EpisodeLog log;
  log.duration_s = duration_s;
  log.outcome = "found";
  log.fields = {{"condition", condition}, {"who", who}, {"ease", std::to_string(rating)}};
  for (double time_s = 5.0; time_s <= duration_s; time_s += condition == "app" ? 5.0 : 15.0) {
    log.presses.push_back({time_s, "my_pose", std::nullopt});
  }
  return log;
}

std::vector<EpisodeLog> study() {
  return {episode_with(100.0, "app", "ann", 6.0), episode_with(130.0, "none", "ann", 3.0),
          episode_with(120.0, "app", "bob", 7.0), episode_with(140.0, "none", "bob", 2.0),
          episode_with(110.0, "app", "cid", 5.0), episode_with(150.0, "none", "cid", 4.0)};
}

const Comparison& named(const std::vector<Comparison>& comparisons, const std::string& name) {
  const auto found = std::ranges::find(comparisons, name, &Comparison::measure);
  EXPECT_NE(found, comparisons.end()) << name;
  return *found;
}

TEST(Report, WithoutAFieldIsOneGroup) {
  const auto report = make_report(study(), {});
  ASSERT_EQ(report.groups.size(), 1U);
  EXPECT_EQ(report.groups[0].name, "all");
  EXPECT_EQ(report.groups[0].episodes.size(), 6U);
  EXPECT_EQ(report.groups[0].found, 6U);
  EXPECT_TRUE(named(report.measures, "time_s").pairs.empty());
}

TEST(Report, GroupsByAFieldAndComparesThem) {
  const auto report = make_report(study(), {.by = "condition"});
  ASSERT_EQ(report.groups.size(), 2U);
  EXPECT_EQ(report.groups[0].name, "app");
  EXPECT_EQ(report.groups[1].episodes, (std::vector<std::size_t>{1, 3, 5}));
  const auto& duration = named(report.measures, "time_s");
  EXPECT_DOUBLE_EQ(duration.groups[0].mean, 110.0);
  EXPECT_DOUBLE_EQ(duration.groups[1].mean, 140.0);
  EXPECT_DOUBLE_EQ(duration.groups[1].deviation, 10.0);
  EXPECT_NEAR(duration.anova.f, 1350.0 / 100.0, 1e-9);  // between 6 * 15^2 with 1, within 400 with 4
  ASSERT_EQ(duration.pairs.size(), 1U);
  EXPECT_EQ(duration.pairs[0].pairs, 0U);
  EXPECT_GT(duration.pairs[0].effect.g, 0.0);
}

// Differences 30, 20, 40 s: of 8 ways two are as far from 0.
TEST(Report, ComparesInPairsWhoBelongTogether) {
  const auto report = make_report(study(), {.by = "condition", .pair = "who"});
  const auto& duration = named(report.measures, "time_s");
  EXPECT_EQ(duration.pairs[0].pairs, 3U);
  EXPECT_DOUBLE_EQ(duration.pairs[0].p, 0.25);
}

TEST(Report, AnswersThatAreNumbersAreQuestions) {
  const auto report = make_report(study(), {.by = "condition", .pair = "who"});
  ASSERT_EQ(report.questions.size(), 1U);
  EXPECT_EQ(report.questions[0].measure, "ease");
  EXPECT_DOUBLE_EQ(report.questions[0].groups[0].mean, 6.0);
  EXPECT_DOUBLE_EQ(report.questions[0].groups[1].mean, 3.0);
}

TEST(Report, MatchesThresholdsToABaseline) {
  const auto report = make_report(study(), {.by = "condition", .threshold_s = 10.0, .baseline = "app"});
  EXPECT_DOUBLE_EQ(report.groups[0].matching_threshold_s, 5.0);   // all within: its longest
  EXPECT_DOUBLE_EQ(report.groups[1].matching_threshold_s, 15.0);  // all needed
}

TEST(Report, NamesWhatThereIsWhenAskedForAFieldThatIsNot) {
  try {
    (void)make_report(study(), {.by = "gender"});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string{error.what()}.find("condition, ease, who"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)make_report(study(), {.by = "condition", .baseline = "nobody"}), std::invalid_argument);
}

TEST(Report, WhoDidNotAnswerIsAGroupOfTheirOwn) {
  auto episodes = study();
  episodes[0].fields.erase("who");
  const auto report = make_report(episodes, {.by = "who"});
  EXPECT_EQ(report.groups[0].name, "(none)");
  EXPECT_EQ(report.groups.size(), 4U);
}

}  // namespace
}  // namespace tandem::experiment
