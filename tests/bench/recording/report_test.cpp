#include "bench/recording/report.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(RecordingReport, SaysOfEachTargetWhetherItIsMet) {
  const std::vector<RecordingRow> rows{{"at most 15 % of a core", "7.0 %", true}, {"0 lost", "3 lost", false}};
  const std::string report = recording_report(rows, {"2026-01-02", "abc", "a machine", "./run bench recording"});
  EXPECT_NE(report.find("| at most 15 % of a core | 7.0 % | met |\n"), std::string::npos);
  EXPECT_NE(report.find("| 0 lost | 3 lost | **missed** |\n"), std::string::npos);
  EXPECT_NE(report.find("2026-01-02, commit abc, a machine"), std::string::npos);
}

}  // namespace
}  // namespace tandem::bench
