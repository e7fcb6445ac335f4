// The product as a user runs it: one command, one result.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

TEST(Search, APersonAndARobotFindTheObjectTogether) {
  const TemporaryFolder folder;
  const std::string tandem = TANDEM_BINARY_DIR "/bin/tandem";
  const std::string json = (folder / "out.json").string();
  const std::string command =
      tandem + " up --simulate quick --headless --seed 1 --config " TANDEM_SOURCE_DIR "/config --output " +
      folder.path().string() + " --json " + json;

  ASSERT_EQ(std::system(command.c_str()), 0);

  const auto result = nlohmann::json::parse(read_file(json));
  EXPECT_TRUE(result.at("found"));
  EXPECT_GT(result.at("time_s"), 0.0);
  EXPECT_GT(result.at("messages"), 0);
  EXPECT_GT(result.at("explored"), 0.0);
  const std::string recording = result.at("recording");
  ASSERT_TRUE(fs::exists(recording));
  EXPECT_TRUE(fs::exists(result.at("picture").get<std::string>()));
  EXPECT_EQ(std::system((tandem + " info " + recording + " --json > " + (folder / "info.json").string()).c_str()), 0);
  EXPECT_TRUE(nlohmann::json::parse(read_file(folder / "info.json")).at("complete"));
}

TEST(Search, ALimitThatIsTooShortIsAFailureThatSaysSo) {
  const TemporaryFolder folder;
  const std::string json = (folder / "out.json").string();
  const std::string command = TANDEM_BINARY_DIR
                              "/bin/tandem up --simulate brl --headless --limit-s 2 --config " TANDEM_SOURCE_DIR
                              "/config --output " +
                              folder.path().string() + " --json " + json;

  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  const auto result = nlohmann::json::parse(read_file(json));
  EXPECT_FALSE(result.at("found"));
  EXPECT_NE(result.at("reason").get<std::string>().find("limit"), std::string::npos);
}

}  // namespace
}  // namespace tandem::test
