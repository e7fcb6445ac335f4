#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string output;
};

/// What `tandem study ARGUMENTS` prints, with the scenarios of the sources.
Outcome study(const std::string& arguments) {
  Outcome outcome;
  const std::string command = TANDEM_BINARY_DIR "/bin/tandem study --config " TANDEM_SOURCE_DIR "/config " + arguments;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

const std::string kQuick = "--scenario quick --rollouts 5 ";

class StudyCommand : public testing::Test {
 protected:
  void SetUp() override {}
  [[nodiscard]] std::string to(const std::string& name) const { return "--output " + (folder_ / name).string() + " "; }
  [[nodiscard]] std::string content(const std::string& name) const { return read_file(folder_ / name); }

  test::TemporaryFolder folder_;
};

TEST_F(StudyCommand, EqualSeedsPrintEqualJsonOnAnyNumberOfThreads) {
  const Outcome one = study(kQuick + "--episodes 3 --seed 4 --threads 1 --json");
  ASSERT_EQ(one.code, 0);
  const auto json = nlohmann::json::parse(one.output);
  EXPECT_EQ(json.at("episodes").size(), 3U);
  EXPECT_EQ(json.at("episodes").at(0).at("seed"), 4);
  EXPECT_EQ(json.at("human"), "obedient");
  EXPECT_EQ(study(kQuick + "--episodes 3 --seed 4 --threads 2 --json").output, one.output);
}

TEST_F(StudyCommand, ItsFilesSayWhatItPrints) {
  const Outcome json = study(kQuick + to("a") + "--episodes 2 --human own --json");
  EXPECT_EQ(json.output, content("a/study.json"));
  EXPECT_EQ(study(kQuick + to("a") + "--episodes 2 --human own --csv").output, content("a/study.csv"));
}

TEST_F(StudyCommand, WhatCtrlCEndsGoesOn) {
  ASSERT_EQ(study(kQuick + to("whole") + "--episodes 12 > /dev/null").code, 0);
  // Ends by SIGINT as soon as there is an episode in the file.
  const std::string file = (folder_ / "parts" / "episodes.jsonl").string();
  const std::string interrupt = "2> /dev/null & pid=$!; until [ \"$(cat " + file +
                                " 2> /dev/null | wc -l)\" -gt 1 ]; do :; done; kill -INT $pid; wait $pid";
  const Outcome ended = study(kQuick + to("parts") + "--episodes 12 --threads 1 " + interrupt);
  EXPECT_TRUE(ended.code == 130 || ended.code == 0) << ended.code;  // 0: it was faster
  ASSERT_EQ(study(kQuick + to("parts") + "--episodes 12 > /dev/null").code, 0);
  for (const char* name : {"episodes.jsonl", "study.json", "study.csv"}) {
    EXPECT_EQ(content(std::string{"parts/"} + name), content(std::string{"whole/"} + name)) << name;
  }
}

TEST_F(StudyCommand, WrongUseIsToldInOneLineAndEndsWithTwo) {
  const Outcome human = study("--human obediant 2>&1");
  EXPECT_EQ(human.code, 2);
  EXPECT_NE(human.output.find("obedient, late, own, stubborn, random, announces"), std::string::npos) << human.output;
  const Outcome scenario = study("--scenario brll 2>&1");
  EXPECT_EQ(scenario.code, 2);
  EXPECT_NE(scenario.output.find("brl"), std::string::npos) << scenario.output;
  EXPECT_EQ(study("--planner nobody 2>&1").code, 2);
  EXPECT_EQ(study("--json --csv 2>&1").code, 2);
  EXPECT_EQ(study("--rollouts 5 --budget-ms 5 2>&1").code, 2);
  ASSERT_EQ(study(kQuick + to("a") + "--episodes 1 > /dev/null").code, 0);
  EXPECT_EQ(study(kQuick + to("a") + "--episodes 1 --human own 2>&1").code, 2);  // another study is there
}

}  // namespace
}  // namespace tandem::cli
