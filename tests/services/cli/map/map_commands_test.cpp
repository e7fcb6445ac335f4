#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <csignal>
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
  void SetUp() override { write_drive("drive.mcap", 6.0); }
  /// The recording of a drive of `way_m`.
  void write_drive(const std::string& name, double way_m) const {
    const auto ring = test::drive_around(way_m, 0.03);
    std::vector<carmen::Event> events;
    for (std::size_t i = 0; i < ring.scans.size(); ++i) {
      const double time_s = to_seconds(ring.scans[i].time.time_since_epoch());
      events.emplace_back(carmen::Odometry{.time_s = time_s, .odom_from_base = ring.odometry[i].odom_from_base});
      events.emplace_back(carmen::Scan{.time_s = time_s,
                                       .angle_min_rad = ring.scans[i].angle_min_rad,
                                       .angle_increment_rad = ring.scans[i].angle_increment_rad,
                                       .ranges_m = ring.scans[i].ranges_m});
    }
    recorder::write_recording(path(name),
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

  /// Builds a.yaml of `recording` until standard error or a file says `sign`, and then sends `signal`.
  [[nodiscard]] Outcome broken_off(const std::string& recording, const std::string& sign,
                                   const std::string& signal) const {
    return run("build " + path(recording) + " -o " + path("a.yaml") + " 2> " + path("said") + " & pid=$!; until " +
               sign + " || ! kill -0 $pid 2> /dev/null; do :; done; kill -" + signal +
               " $pid; wait $pid 2> /dev/null; code=$?; cat " + path("said") + "; rm " + path("said") + "; exit $code");
  }
  [[nodiscard]] std::string checkpoint() const { return path("a.yaml.checkpoint"); }
  [[nodiscard]] std::string there_is_a_checkpoint() const { return "[ -e " + checkpoint() + " ]"; }
  [[nodiscard]] std::string it_goes_on() const { return "grep -q 'going on' " + path("said"); }

  test::TemporaryFolder folder_;
};

class BrokenOffMapBuild : public MapCommands {
 protected:
  void SetUp() override {
    write_drive("long.mcap", 30.0);
    ASSERT_EQ(
        run("build " + path("long.mcap") + " -o " + path("whole.yaml") + " --trajectory " + path("whole.txt")).code, 0);
  }
  /// Builds to the end, which must give the map that an undisturbed build gave; what was said.
  [[nodiscard]] std::string said_by_the_rest(const std::string& more = "") const {
    const Outcome outcome = run("build " + path("long.mcap") + " -o " + path("a.yaml") + " --trajectory " +
                                path("a.txt") + more + " 2>&1 > /dev/null");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(read_file(path("a.pgm")) == read_file(path("whole.pgm")));
    EXPECT_TRUE(read_file(path("a.txt")) == read_file(path("whole.txt")));
    EXPECT_FALSE(std::filesystem::exists(checkpoint()));
    return outcome.output;
  }
};

TEST_F(BrokenOffMapBuild, GoesOnAfterBeingKilledAndStoppedAsIfNothingHadBeen) {
  EXPECT_EQ(broken_off("long.mcap", there_is_a_checkpoint(), "KILL").code, 128 + SIGKILL);
  EXPECT_TRUE(std::filesystem::exists(checkpoint()));

  const Outcome stopped = broken_off("long.mcap", it_goes_on(), "INT");
  EXPECT_EQ(stopped.code, 130);
  EXPECT_NE(stopped.output.find("tandem: going on from " + checkpoint() + ", after "), std::string::npos)
      << stopped.output;
  EXPECT_NE(stopped.output.find(" of 121 scans, kept in " + checkpoint() + ": the same command goes on from there\n"),
            std::string::npos)
      << stopped.output;
  EXPECT_EQ(broken_off("long.mcap", it_goes_on(), "TERM").code, 130);
  EXPECT_FALSE(std::filesystem::exists(path("a.yaml")));  // a map is whole or not there

  EXPECT_EQ(said_by_the_rest().rfind("tandem: going on from ", 0), 0U);
}

TEST_F(BrokenOffMapBuild, BeginsAnewWhereItsCheckpointIsDamagedOrNotWanted) {
  ASSERT_EQ(broken_off("long.mcap", there_is_a_checkpoint(), "INT").code, 130);
  const std::string kept = read_file(checkpoint());

  std::string damaged = kept;
  damaged.back() ^= 1;
  write_file_atomically(checkpoint(), damaged);
  EXPECT_EQ(said_by_the_rest(), "tandem: " + checkpoint() + " is damaged; starting anew\n");

  write_file_atomically(checkpoint(), kept);
  EXPECT_EQ(said_by_the_rest(" --fresh"), "");
}

TEST_F(BrokenOffMapBuild, IsNeverGoneOnWithFromAnotherRecording) {
  write_drive("other.mcap", 29.0);
  ASSERT_EQ(broken_off("other.mcap", there_is_a_checkpoint(), "INT").code, 130);
  EXPECT_EQ(said_by_the_rest(), "tandem: " + checkpoint() + " is of another recording; starting anew\n");
}

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
