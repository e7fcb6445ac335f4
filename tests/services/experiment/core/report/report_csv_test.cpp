#include "services/experiment/core/report/report_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tandem::experiment {
namespace {

EpisodeLog episode() {
  EpisodeLog log;
  log.name = "first, \"quoted\"";
  log.code = "s1";
  log.fields = {{"condition", "app"}};
  log.outcome = "found";
  log.found_by = "human1";
  log.duration_s = 12.3456;
  log.plans = {{.time_s = 1.0, .id = "p1"}};
  log.beliefs = {{.time_s = 0.0, .explored = 0.5, .explored_robot = 0.25}};
  return log;
}

TEST(ReportCsv, QuotesAndLeavesOutWhatIsNotKnown) {
  const std::vector<EpisodeLog> episodes{episode()};
  const std::string csv = episodes_csv(episodes, make_report(episodes, {}));
  EXPECT_EQ(csv.substr(0, csv.find('\n')).substr(0, 52), "recording,session,condition,outcome,found_by,found,t");
  const std::string row = csv.substr(csv.find('\n') + 1);
  EXPECT_TRUE(row.starts_with("\"first, \"\"quoted\"\"\",s1,app,found,human1,1,12.3456,0.5,0.25,0,")) << row;
  EXPECT_EQ(std::ranges::count(row, '\n'), 1);
}

TEST(ReportCsv, HasARowPerGroupAndMoment) {
  auto other = episode();
  other.fields["condition"] = "none";
  other.duration_s = 4.0;
  const std::vector<EpisodeLog> episodes{episode(), other};
  const auto report = make_report(episodes, {.by = "condition"});
  const std::string progress = progress_csv(report);
  EXPECT_EQ(std::ranges::count(progress, '\n'), 1 + 3 + 1) << progress;  // head; 0, 5, 10 s of 12.3; 0 s of 4
  EXPECT_NE(progress.find("app,5,1,0.25,0.5,1,0,0,0\n"), std::string::npos) << progress;
  EXPECT_EQ(std::ranges::count(my_pose_csv(report), '\n'), 1 + 2 * 4);
  const std::string comparisons = comparisons_csv(report);
  EXPECT_EQ(std::ranges::count(comparisons, '\n'), 1 + static_cast<std::ptrdiff_t>(measures().size()));
}

}  // namespace
}  // namespace tandem::experiment
