#include <gtest/gtest.h>

#include "services/cli/offline_localization.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/recorder/carmen_import.hpp"
#include "services/recorder/core/carmen_log.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::cli {
namespace {

/// fr079 as a recording in a file that goes with the test.
class Recording {
 public:
  explicit Recording(const std::string& log) : file_(testing::TempDir() + "localize_" + log.substr(0, 5) + ".mcap") {
    std::filesystem::remove(file_);
    const std::string path = (test::data_folder() / log.substr(0, 5) / log).string();
    const auto events = carmen::parse_log(carmen::read_log_file(path), path);
    recorder::write_recording(file_, [&](mcap::Writer& writer) { recorder::write_carmen(events, "robot1", writer); });
  }
  ~Recording() { std::filesystem::remove(file_); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  [[nodiscard]] OfflineResult localized(const OccupancyGrid& map, const LocalizationConfig& config) const {
    mcap::Reader reader{mcap::file_source(file_), file_};
    return localize_offline(reader, map, {.config = config, .kidnap_s = {}}, [](double) { return true; });
  }

 private:
  std::string file_;
};

TEST(LocalizeFr079, FollowsTheRobotThroughWheelsThatMissMetres) {
  TANDEM_NEEDS_DATA("fr079/fr079.odomscan.txt.gz");
  const auto data = test::data_folder();
  const OccupancyGrid map = load_map(data / "maps/fr079_even.yaml");
  const std::string truth_file = (data / "fr079/fr079.reference.txt").string();
  const auto truth = parse_trajectory(carmen::read_log_file(truth_file), truth_file);
  const Pose2& first = truth.front().map_from_base;
  LocalizationConfig config;
  config.scans = "odd";
  config.start = {first.x, first.y, first.heading};
  const Recording recording{"fr079.odomscan.txt.gz"};

  const OfflineResult result = recording.localized(map, config);

  const TrajectoryErrors errors = errors_of(result.poses, truth, 0.0, {{180.0, 206.0}, {300.0, 360.0}, {396.0, 405.0}});
  EXPECT_EQ(errors.compared, 2395U);
  EXPECT_LT(errors.rmse_kept_m, 0.08);
  EXPECT_LT(errors.rmse_m, 0.10);
  EXPECT_LE(errors.lost_share, 0.005);
}

}  // namespace
}  // namespace tandem::cli
