#include "bench/planning/records/run_record.hpp"

#include <gtest/gtest.h>

#include "bench/planning/records/json_lines.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::bench {
namespace {

RunRecord a_record() {
  RunRecord record;
  record.key = {"S1u", 7, "greedy15", "200ms", 1};
  record.expected_time_s = 78.25;
  record.distance_m = {60.0, 90.5};
  record.finished = true;
  return record;
}

TEST(RunRecord, ReadsBackAsItWasWritten) {
  const RunRecord record = from_line<RunRecord>(to_line(a_record()));
  EXPECT_EQ(record.key, a_record().key);
  EXPECT_DOUBLE_EQ(record.expected_time_s, 78.25);
  EXPECT_EQ(record.distance_m, (std::vector<double>{60.0, 90.5}));
  EXPECT_TRUE(record.finished);
}

TEST(RunRecord, IsOneLine) {
  EXPECT_EQ(to_line(a_record()).find('\n'), std::string::npos);
}

TEST(RunRecord, RefusesWhatIsNone) {
  EXPECT_THROW((void)from_line<RunRecord>("{}"), ConfigError);
  EXPECT_THROW((void)from_line<RunRecord>("nonsense"), ConfigError);
}

TEST(RunRecord, ALineThatWasCutOffIsLeftOut) {
  const test::TemporaryFolder folder;
  const auto file = folder / "runs.jsonl";
  write_file_atomically(file, to_line(a_record()) + "\n" + to_line(a_record()).substr(0, 20));
  EXPECT_EQ(read_lines<RunRecord>(file).size(), 1U);
  EXPECT_TRUE(read_lines<RunRecord>(folder / "absent").empty());
}

TEST(RunRecord, NamesABudget) {
  EXPECT_EQ(budget_label({.cpu_ms = 50.0}), "50ms");
  EXPECT_EQ(budget_label({.rollouts = 500}), "500rollouts");
}

}  // namespace
}  // namespace tandem::bench
