#include "bench/paths/report.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

PathRecord record(std::uint64_t seed, const std::string& planner, double budget_ms, double length_m) {
  return {"S1u", seed, planner, budget_ms, 20.0, length_m, 10.0};
}

TEST(PathsReport, ShowsMeanRatiosAndHowManyHaveAWay) {
  const std::vector<PathRecord> records{record(1, "ours, shortest", 1.0, 10.1), record(2, "ours, shortest", 3.0, 10.3),
                                        record(1, "OMPL RRTstar", 10.0, 0.0),   record(2, "OMPL RRTstar", 10.0, 14.0),
                                        record(1, "OMPL RRTstar", 50.0, 12.0),  record(2, "OMPL RRTstar", 50.0, 11.0),
                                        record(1, "OMPL BITstar", 10.0, 0.0),   record(2, "OMPL BITstar", 10.0, 0.0),
                                        record(1, "OMPL BITstar", 50.0, 10.0),  record(2, "OMPL BITstar", 50.0, 10.0)};
  const auto files = paths_report(records, {"today", "c0ffee", "a machine", "./run bench paths"});
  const std::string& text = files.at("REPORT.md");
  EXPECT_NE(text.find("| ours, shortest | 20.0 | 2.000 | 1.020 | 1.030 |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| OMPL RRTstar | 1/2, 1.400 | 1.150 |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| OMPL BITstar | 0/2 | 1.000 |\n"), std::string::npos) << text;
  EXPECT_TRUE(files.contains("S1u.svg"));
}

TEST(PathsReport, SaysThatOmplIsNotThere) {
  const std::vector<PathRecord> records{record(1, "ours, shortest", 1.0, 10.1)};
  const auto files = paths_report(records, {"today", "c0ffee", "a machine", "./run bench paths"});
  EXPECT_NE(files.at("REPORT.md").find("its part was not run"), std::string::npos);
}

}  // namespace
}  // namespace tandem::bench
