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

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string output;  ///< both streams
};

Outcome session(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((TANDEM_BINARY_DIR "/bin/tandem session " + arguments + " 2>&1").c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

class SessionCommand : public testing::Test {
 protected:
  void SetUp() override {
    record("a.mcap", {"P01"});
    record("b.mcap", {"P02"});
    record("c.mcap", {"P01", "P03"});
    write_file_atomically(folder_ / "torn.mcap", "no recording");
  }
  void record(const std::string& name, const std::vector<std::string>& codes) const {
    recorder::write_recording(folder_ / name, [&](mcap::Writer& writer) {
      double began_s = 1.7e9;
      for (const auto& code : codes) test::write_scripted_search(writer, code, began_s += 1000.0);
    });
  }
  [[nodiscard]] std::string in_folder() const { return " --folder " + folder_.path().string(); }

  test::TemporaryFolder folder_;
};

TEST_F(SessionCommand, ListsWhatRanAndNamesWhatItCannotRead) {
  const Outcome listed = session("list" + in_folder());
  EXPECT_EQ(listed.code, 0);
  EXPECT_NE(listed.output.find("torn.mcap"), std::string::npos) << listed.output;
  EXPECT_NE(listed.output.find("P03                  2023-11-14T22:46:40Z   120.0 s  found       app"),
            std::string::npos)
      << listed.output;
}

TEST_F(SessionCommand, DeletesNothingWithoutYes) {
  const Outcome asked = session("delete P02" + in_folder());
  EXPECT_EQ(asked.code, 2);
  EXPECT_NE(asked.output.find("b.mcap"), std::string::npos) << asked.output;
  EXPECT_TRUE(fs::exists(folder_ / "b.mcap"));
}

TEST_F(SessionCommand, DeletesWhatHoldsNothingElse) {
  const Outcome deleted = session("delete P02 --yes" + in_folder());
  EXPECT_EQ(deleted.code, 0) << deleted.output;
  EXPECT_FALSE(fs::exists(folder_ / "b.mcap"));
  EXPECT_TRUE(fs::exists(folder_ / "a.mcap"));
}

TEST_F(SessionCommand, LeavesRecordingsThatHoldOtherSessionsAndSaysSo) {
  const Outcome deleted = session("delete P01 --yes" + in_folder());
  EXPECT_EQ(deleted.code, 1);
  EXPECT_FALSE(fs::exists(folder_ / "a.mcap"));
  EXPECT_TRUE(fs::exists(folder_ / "c.mcap"));
  EXPECT_NE(deleted.output.find("c.mcap holds other sessions"), std::string::npos) << deleted.output;
}

TEST_F(SessionCommand, SaysWhenThereIsNoSuchSession) {
  const Outcome none = session("delete P99 --yes" + in_folder());
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.output.find("no recording of session P99"), std::string::npos) << none.output;
}

TEST_F(SessionCommand, ANameIsNoCode) {
  const Outcome wrong = session("start 'Ada Lovelace'");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.output.find("a code, never a name"), std::string::npos) << wrong.output;
}

}  // namespace
}  // namespace tandem::cli
