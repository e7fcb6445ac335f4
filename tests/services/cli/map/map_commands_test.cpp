#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/recorder/carmen_import.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/services/map_builder/ring.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

struct Outcome {
  int code = -1;
  std::string output;
};

Outcome run(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((TANDEM_BINARY_DIR "/bin/tandem map " + arguments).c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// A folder of its own with the recording of a drive in it, gone at the end.
class MapCommands : public testing::Test {
 protected:
  void SetUp() override {
    const auto ring = test::drive_around(6.0, 0.03);
    std::vector<carmen::Event> events;
    for (std::size_t i = 0; i < ring.scans.size(); ++i) {
      const double time_s = to_seconds(ring.scans[i].time.time_since_epoch());
      events.emplace_back(carmen::Odometry{.time_s = time_s, .odom_from_base = ring.odometry[i].odom_from_base});
      events.emplace_back(carmen::Scan{.time_s = time_s,
                                       .angle_min_rad = ring.scans[i].angle_min_rad,
                                       .angle_increment_rad = ring.scans[i].angle_increment_rad,
                                       .ranges_m = ring.scans[i].ranges_m});
    }
    recorder::write_recording(path("drive.mcap"),
                              [&](mcap::Writer& writer) { recorder::write_carmen(events, "robot1", writer); });
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{folder_.path()}) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  test::TemporaryFolder folder_;
};

TEST_F(MapCommands, ARecordingBecomesAMapThatCanBeCheckedAndLoaded) {
  const Outcome built = run("build " + path("drive.mcap") + " -o " + path("a.yaml") + " --svg " + path("a.svg") +
                            " --trajectory " + path("a.txt") + " --json");
  ASSERT_EQ(built.code, 0);
  const auto report = nlohmann::json::parse(built.output);
  EXPECT_EQ(report.at("scans"), 25);
  EXPECT_EQ(report.at("complete"), true);
  EXPECT_TRUE(report.at("relations_m").is_null());
  EXPECT_GT(report.at("peak_mb"), 1.0);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.pgm", "a.svg", "a.txt", "a.yaml", "drive.mcap"}));
  const OccupancyGrid map = load_map(path("a.yaml"));
  EXPECT_TRUE(map.is_free(map.cell_at({0.0, 0.0})));  // where the robot started

  const Outcome checked = run("check " + path("a.yaml") + " --json");
  EXPECT_EQ(checked.code, 0);
  EXPECT_EQ(nlohmann::json::parse(checked.output).at("ok"), true);
}

TEST_F(MapCommands, TheSameRecordingGivesTheSameBytesWhateverTheSeed) {
  ASSERT_EQ(run("build " + path("drive.mcap") + " -o " + path("a.yaml") + " --seed 1 2>&1").code, 0);
  ASSERT_EQ(run("build " + path("drive.mcap") + " -o " + path("b.yaml") + " --seed 2 2>&1").code, 0);
  EXPECT_EQ(read_file(path("a.pgm")), read_file(path("b.pgm")));
}

TEST_F(MapCommands, ATruthGivesFigures) {
  write_file_atomically(path("truth.relations"), "10.0 14.0 2.0 0 0 0 0 0\n");
  const Outcome built =
      run("build " + path("drive.mcap") + " -o " + path("a.yaml") + " --truth " + path("truth.relations") + " --json");
  ASSERT_EQ(built.code, 0);
  EXPECT_LT(nlohmann::json::parse(built.output).at("relations_m"), 0.05);  // 2 m in 4 s, straight on
}

TEST_F(MapCommands, ATruncatedRecordingGivesTheMapOfWhatIsLeft) {
  const std::string whole = read_file(path("drive.mcap"));
  write_file_atomically(path("cut.mcap"), whole.substr(0, whole.size() * 9 / 10));
  const Outcome built = run("build " + path("cut.mcap") + " -o " + path("a.yaml") + " --json 2>/dev/null");
  if (built.code == 0) {
    EXPECT_GT(nlohmann::json::parse(built.output).at("scans"), 0);
  } else {  // everything was in one chunk
    EXPECT_EQ(built.code, 1);
    EXPECT_FALSE(std::filesystem::exists(path("a.yaml")));
  }
}

TEST_F(MapCommands, ARecordingWithoutScansIsRefusedByName) {
  recorder::write_recording(path("empty.mcap"), [](mcap::Writer&) {});
  const Outcome outcome = run("build " + path("empty.mcap") + " -o " + path("a.yaml") + " 2>&1");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output, "tandem: " + path("empty.mcap") + ": no map can be built from it: it holds no scans\n");
  EXPECT_FALSE(std::filesystem::exists(path("a.yaml")));
}

TEST_F(MapCommands, WrongUseIsToldBeforeTheWork) {
  EXPECT_EQ(run("2>&1").code, 2);
  EXPECT_EQ(run("build " + path("drive.mcap") + " 2>&1").code, 2);
  EXPECT_EQ(run("build " + path("drive.mcap") + " -o " + path("a.pgm") + " 2>&1").code, 2);
  EXPECT_EQ(run("build " + path("drive.mcap") + " -o " + path("none/a.yaml") + " 2>&1").code, 2);
  EXPECT_EQ(run("build " + path("none.mcap") + " -o " + path("a.yaml") + " 2>&1").code, 1);
  EXPECT_EQ(run("check " + path("none.yaml") + " 2>&1").code, 1);
  EXPECT_EQ(files(), std::vector<std::string>{"drive.mcap"});
}

TEST_F(MapCommands, AMapOfWrongScaleFailsTheCheckAndSaysWhy) {
  ASSERT_EQ(run("build " + path("drive.mcap") + " -o " + path("a.yaml") + " 2>&1").code, 0);
  std::string yaml = read_file(path("a.yaml"));
  const std::size_t at = yaml.find("resolution: ");
  yaml.replace(at, yaml.find('\n', at) - at, "resolution: 0.002");
  write_file_atomically(path("a.yaml"), yaml);
  const Outcome checked = run("check " + path("a.yaml") + " 2>&1");
  EXPECT_EQ(checked.code, 1);
  EXPECT_NE(checked.output.find("fault: too_small"), std::string::npos);
  EXPECT_NE(checked.output.find("measure a wall"), std::string::npos);
}

TEST_F(MapCommands, HelpHasAnExample) {
  for (const char* command : {"build", "check"}) {
    EXPECT_NE(run(std::string{command} + " --help").output.find("Example: tandem map "), std::string::npos);
  }
}

}  // namespace
}  // namespace tandem::cli
