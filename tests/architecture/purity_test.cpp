#include <gtest/gtest.h>

#include <regex>

#include "tests/architecture/source_tree.hpp"

namespace tandem::test {
namespace {

const std::vector<std::string> kAll{"services", "robot", "gateway", "calibration"};

bool is_core(const std::string& file) {
  if (file.find("/core/") != std::string::npos) return true;
  // These four are the shells' tools.
  const std::regex tool{"services/common/(clock|logging|service_options|stop_signal)\\."};
  return file.starts_with("services/common/") && !std::regex_search(file, tool);
}

TEST(Purity, ACoreKnowsNoMiddlewareNoLoggingNoThreadNoClockNoChance) {
  // The bus's own core is as pure as any other; who may include it says include_directions_test.
  const std::regex impure{
      "fastdds|fastrtps|spdlog|services/bus(?!/core/)|<thread>|<mutex>|std::thread|sleep_for|sleep_until|steady_clock|"
      "system_clock|random_device|mt19937|std::rand\\b|getenv"};
  for (const auto& line : lines_of_sources(kAll)) {
    if (!is_core(line.file)) continue;
    EXPECT_FALSE(std::regex_search(line.text, impure)) << line.file << ":" << line.number << ": " << line.text;
  }
}

TEST(Purity, OnlyTheClockAsksTheMachineForTheTime) {
  const std::regex asks{"(steady_clock|system_clock)::now|std::random_device|\\bsrand\\b"};
  for (const auto& line : lines_of_sources(kAll)) {
    if (line.file == "services/common/clock.cpp" || line.file.ends_with("main.cpp")) continue;
    EXPECT_FALSE(std::regex_search(line.text, asks)) << line.file << ":" << line.number << ": " << line.text;
  }
}

TEST(Purity, OnlyTheBusKnowsDds) {
  const std::regex dds{"#include <(fastdds|fastrtps|fastcdr)|\\beprosima::"};
  for (const auto& line : lines_of_sources(kAll)) {
    if (line.file.starts_with("services/bus/")) continue;
    EXPECT_FALSE(std::regex_search(line.text, dds)) << line.file << ":" << line.number << ": " << line.text;
  }
}

TEST(Purity, ATestWritesOnlyInAFolderOfItsOwn) {
  const std::regex shared{"temp_directory_path|TempDir\\(\\)|tmpnam"};
  for (const auto& line : lines_of_sources({"tests"})) {
    if (line.file == "tests/support/temporary_folder.hpp" || line.file.starts_with("tests/architecture/")) continue;
    EXPECT_FALSE(std::regex_search(line.text, shared))
        << line.file << ":" << line.number << ": " << line.text << " (see tests/support/temporary_folder.hpp)";
  }
}

}  // namespace
}  // namespace tandem::test
