#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

struct Outcome {
  int code = -1;
  std::string output;  ///< standard output, then standard error where it is asked for
};

Outcome run(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((TANDEM_BINARY_DIR "/bin/tandem " + arguments).c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// A folder of its own with a small log in it, gone at the end.
class RecordingCommands : public testing::Test {
 protected:
  void SetUp() override {
    std::string ranges;
    for (int i = 0; i < 180; ++i) ranges += " 2.5";
    write("log.txt", "O 1.0 0 0 0\nS 1.0 0 0 0 180" + ranges + "\nS 1.5 1 0 0 180" + ranges + "\n");
  }
  void write(const std::string& name, const std::string& text) const { write_file_atomically(folder_ / name, text); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  test::TemporaryFolder folder_;
};

TEST_F(RecordingCommands, AnImportedLogIsWhatInfoSays) {
  ASSERT_EQ(run("import carmen " + path("log.txt") + " -o " + path("a.mcap") + " 2>&1").code, 0);
  const Outcome info = run("info --json " + path("a.mcap"));
  EXPECT_EQ(info.code, 0);
  const auto json = nlohmann::json::parse(info.output);
  EXPECT_EQ(json.at("complete"), true);
  const auto& odometry = json.at("topics").at(0);
  EXPECT_EQ(odometry.at("topic"), "odometry");
  EXPECT_EQ(odometry.at("type"), "tandem::msg::Odometry");
  EXPECT_EQ(odometry.at("count"), 2);
  EXPECT_EQ(odometry.at("rate_hz"), 2.0);  // 0.5 s apart
  EXPECT_EQ(odometry.at("first_time_ns"), 1'000'000'000);
  EXPECT_EQ(json.at("topics").at(1).at("count"), 2);
}

TEST_F(RecordingCommands, ABadLineOfALogIsNamedAndLeavesNoFile) {
  write("bad.txt", "O 1.0 0 0 0\nO 2.0 zero 0 0\n");
  const Outcome outcome = run("import carmen " + path("bad.txt") + " -o " + path("a.mcap") + " 2>&1");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output, "tandem: " + path("bad.txt") + ":2: \"zero\" is not a number\n");
  EXPECT_FALSE(std::filesystem::exists(path("a.mcap")));
  EXPECT_FALSE(std::filesystem::exists(path("a.mcap.part")));
}

TEST_F(RecordingCommands, ARecordingCutShortIsOpenedAndSaidNotToBeComplete) {
  ASSERT_EQ(run("import carmen " + path("log.txt") + " -o " + path("a.mcap") + " 2>&1").code, 0);
  const std::string whole = read_file(path("a.mcap"));
  write("cut.mcap", whole.substr(0, whole.size() - 30));
  const Outcome info = run("info --json " + path("cut.mcap") + " 2>&1");
  EXPECT_EQ(info.code, 0);
  const auto json = nlohmann::json::parse(info.output);
  EXPECT_EQ(json.at("complete"), false);
  EXPECT_EQ(json.at("messages"), 4);
}

TEST_F(RecordingCommands, ARecoveredRecordingIsCompleteAndWhatWasDamagedIsNamed) {
  ASSERT_EQ(run("import carmen " + path("log.txt") + " -o " + path("a.mcap") + " 2>&1").code, 0);
  const std::string whole = read_file(path("a.mcap"));
  write("cut.mcap", whole.substr(0, whole.size() - 30));
  EXPECT_EQ(run("recover " + path("cut.mcap") + " -o " + path("b.mcap") + " 2>&1").output,
            path("b.mcap") + ": 4 messages; nothing was damaged\n");
  EXPECT_EQ(nlohmann::json::parse(run("info --json " + path("b.mcap")).output).at("complete"), true);

  std::string damaged = whole;
  damaged[damaged.size() - 60] ^= 0x01;  // in the summary, which is not needed
  write("damaged.mcap", damaged);
  const Outcome outcome = run("recover " + path("damaged.mcap") + " -o " + path("b.mcap") + " 2>&1");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output.find("tandem: " + path("damaged.mcap") + ": byte "), 0U) << outcome.output;
  EXPECT_EQ(nlohmann::json::parse(run("info --json " + path("b.mcap")).output).at("messages"), 4);
}

TEST_F(RecordingCommands, WhatIsNoRecordingIsRefusedByName) {
  const Outcome outcome = run("info " + path("log.txt") + " 2>&1");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output, "tandem: " + path("log.txt") + ": is not a recording (no MCAP file)\n");
}

TEST_F(RecordingCommands, WrongUseExitsWithTwo) {
  EXPECT_EQ(run("2>&1").code, 2);
  EXPECT_EQ(run("no-such-command 2>&1").code, 2);
  EXPECT_EQ(run("info 2>&1").code, 2);
  EXPECT_EQ(run("replay --rate fast " + path("a.mcap") + " 2>&1").code, 2);
}

TEST_F(RecordingCommands, HelpHasAnExampleAndVersionTheContract) {
  for (const char* command : {"record", "replay", "info", "import carmen", "topics"}) {
    const Outcome help = run(std::string{command} + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_NE(help.output.find("Example: tandem "), std::string::npos) << command;
  }
  const Outcome version = run("--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_NE(version.output.find("contract"), std::string::npos);
}

}  // namespace
}  // namespace tandem::cli
