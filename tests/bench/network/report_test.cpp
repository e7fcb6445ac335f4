#include "bench/network/report.hpp"

#include <gtest/gtest.h>

#include "bench/planning/records/json_lines.hpp"

namespace tandem::bench {
namespace {

NetworkRecord map_record(const std::string& whose, int run, double ms) {
  return {{"map300", whose, "loss20", run}, {{"ms", ms}, {"sent_kB", 400.0}}};
}

TEST(NetworkReport, ShowsTheMedianWithItsSpreadAndWhatNeverCame) {
  const std::vector<NetworkRecord> records{map_record("ours", 1, 2100.0), map_record("ours", 2, 2300.0),
                                           map_record("ours", 3, 2900.0), map_record("default", 1, kNever)};
  const std::string report = network_report(records, {"today", "abc", "a machine", "a command"}).at("REPORT.md");
  EXPECT_NE(report.find("| ms | ours | 2300 (2100 to 2900) |"), std::string::npos) << report;
  EXPECT_NE(report.find("| ms | default | never |"), std::string::npos) << report;
}

TEST(NetworkReport, CountsMeasurementsThatFailed) {
  const std::vector<NetworkRecord> records{map_record("ours", 1, 2100.0), {{"map300", "ours", "loss20", 2}, {}}};
  const std::string report = network_report(records, {}).at("REPORT.md");
  EXPECT_NE(report.find("1 of 2 measurements failed"), std::string::npos) << report;
}

TEST(NetworkReport, ATargetIsMetByTheMedianOrMissed) {
  const auto row_of = [](const std::vector<NetworkRecord>& records) {
    const std::string text = network_targets(records);
    const auto begin = text.find("| C1: 300 kB up to");
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  EXPECT_TRUE(row_of({map_record("ours", 1, 2100.0)}).ends_with("| yes |"));
  EXPECT_TRUE(row_of({map_record("ours", 1, 3100.0)}).ends_with("| **no** |"));
  EXPECT_TRUE(row_of({map_record("default", 1, 2100.0)}).ends_with("| not measured |"));
}

NetworkRecord stops_record(int run, double stops, double without_plan, double driven_h) {
  return {{"false_stops", "ours", "loss30+bursts", run},
          {{"false_stops", stops}, {"without_plan", without_plan}, {"driven_h", driven_h}}};
}

TEST(NetworkReport, TellsOfEachTableInHowManyRunsItWasMade) {
  const NetworkRecord failed{{"map300", "ours", "loss20", 3}, {}};
  const std::string text = network_report({map_record("ours", 1, 1.0), map_record("ours", 2, 1.0), failed,
                                           map_record("default", 1, 1.0), stops_record(1, 0.0, 0.0, 0.1)},
                                          {})
                               .at("REPORT.md");
  EXPECT_NE(text.find("as it lies in memory. 1 to 2 runs."), std::string::npos) << text;
  EXPECT_NE(text.find("this machine's. 1 run."), std::string::npos) << text;
}

TEST(NetworkReport, AddsUpFalseStopsAndHoursOfAllRuns) {
  const auto report_of = [](const std::vector<NetworkRecord>& records) {
    return network_report(records, {}).at("REPORT.md");
  };
  const std::string some = report_of({stops_record(1, 1.0, 0.0, 0.5), stops_record(2, 0.0, 2.0, 1.0)});
  EXPECT_NE(some.find("3.0 false stops in 1.5 h of driving, 2.0 an hour."), std::string::npos) << some;
  EXPECT_NE(some.find("| 1.0 | 2.0 | – | **no** |"), std::string::npos) << some;
  const std::string none = report_of({stops_record(1, 0.0, 0.0, 0.5)});
  EXPECT_NE(none.find("0 false stops in 0.500 h of driving: less than 6.0 an hour"), std::string::npos) << none;
}

TEST(NetworkReport, ARecordComesBackAsItWas) {
  const auto record = map_record("ours", 3, 2100.5);
  const auto read = from_line<NetworkRecord>(to_line(record));
  EXPECT_EQ(read.key, record.key);
  EXPECT_EQ(read.figures, record.figures);
}

}  // namespace
}  // namespace tandem::bench
