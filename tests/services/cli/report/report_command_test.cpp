#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/services/cli/report/scripted_recording.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

struct Outcome {
  int code = -1;
  std::string output;  ///< both streams
};

Outcome tandem(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((TANDEM_BINARY_DIR "/bin/tandem " + arguments + " 2>&1").c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

class ReportCommand : public testing::Test {
 protected:
  std::string scripted(const std::string& name) {
    const auto file = folder_ / name;
    recorder::write_recording(file, [&](mcap::Writer& writer) { test::write_scripted_search(writer, name, 1.7e9); });
    return file.string() + " ";
  }

  test::TemporaryFolder folder_;
};

TEST_F(ReportCommand, WritesThePageAndTheTables) {
  const std::string page = (folder_ / "page.html").string();
  const Outcome made = tandem("report " + scripted("a.mcap") + scripted("b.mcap") + "-o " + page + " --csv " +
                              (folder_ / "tables").string());
  ASSERT_EQ(made.code, 0) << made.output;
  EXPECT_NE(made.output.find("2 episodes, found in 2"), std::string::npos) << made.output;
  EXPECT_TRUE(read_file(page).starts_with("<!doctype html>"));
  EXPECT_NE(read_file(folder_ / "tables/my_pose.csv").find("all,60,2,7,0,0.857143,10,\n"), std::string::npos);
  for (const char* table : {"episodes.csv", "progress.csv", "comparisons.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / ("tables/" + std::string{table}))) << table;
  }
}

TEST_F(ReportCommand, WhatBothHostsRecordedCountsOnce) {
  for (const char* name : {"laptop.mcap", "robot.mcap"}) {
    recorder::write_recording(folder_ / name,
                              [](mcap::Writer& writer) { test::write_scripted_search(writer, "P07", 1.7e9); });
  }
  const Outcome made = tandem("report " + folder_.path().string() + " --json");
  ASSERT_EQ(made.code, 0) << made.output;
  EXPECT_EQ(nlohmann::json::parse(made.output)["episodes"].size(), 1U);
}

TEST_F(ReportCommand, TakesAFolder) {
  (void)scripted("a.mcap");
  (void)scripted("b.mcap");
  const Outcome made = tandem("report " + folder_.path().string() + " --json");
  ASSERT_EQ(made.code, 0) << made.output;
  EXPECT_EQ(nlohmann::json::parse(made.output)["episodes"].size(), 2U);
}

TEST_F(ReportCommand, SaysWhatFieldsThereAre) {
  const Outcome wrong = tandem("report " + scripted("a.mcap") + "--by gender");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.output.find("condition, ease, expert, mode, reminder"), std::string::npos) << wrong.output;
}

TEST_F(ReportCommand, WithoutASessionIsAnErrorThatSaysSo) {
  const auto file = folder_ / "empty.mcap";
  recorder::write_recording(file, [](mcap::Writer&) {});
  const Outcome none = tandem("report " + file.string());
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.output.find("no session ran"), std::string::npos) << none.output;
}

TEST_F(ReportCommand, OfAStudyGivesTheStudysNumbers) {
  const std::string folder = (folder_ / "study").string();
  const Outcome study = tandem("study --config " TANDEM_SOURCE_DIR
                               "/config --scenario quick --rollouts 5 --episodes 3 --record --output " +
                               folder);
  ASSERT_EQ(study.code, 0) << study.output;
  const Outcome made = tandem("report " + folder + "/recordings --json");
  ASSERT_EQ(made.code, 0) << made.output;
  const auto report = nlohmann::json::parse(made.output);
  const auto told = nlohmann::json::parse(read_file(folder + "/study.json"));
  ASSERT_EQ(report["episodes"].size(), told["episodes"].size());
  for (std::size_t i = 0; i < report["episodes"].size(); ++i) {
    const auto& values = report["episodes"][i]["values"];
    EXPECT_NEAR(values["time_s"].get<double>(), told["episodes"][i]["time_s"].get<double>(), 0.01);
    EXPECT_NEAR(values["explored"].get<double>(), told["episodes"][i]["explored"].get<double>(), 0.001);
    EXPECT_EQ(values["plans"], told["episodes"][i]["plans"]);
  }
}

}  // namespace
}  // namespace tandem::cli
