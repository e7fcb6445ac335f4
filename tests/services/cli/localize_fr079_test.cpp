#include <gtest/gtest.h>

#include <optional>
#include <span>

#include "services/cli/offline_localization.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/recorder/carmen_import.hpp"
#include "services/recorder/core/carmen_log.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::cli {
namespace {

/// fr079 as a recording in a file that goes with the test.
class Recording {
 public:
  explicit Recording(const std::string& log) {
    const std::string path = (test::data_folder() / log.substr(0, 5) / log).string();
    const auto events = carmen::parse_log(carmen::read_log_file(path), path);
    recorder::write_recording(file_, [&](mcap::Writer& writer) { recorder::write_carmen(events, "robot1", writer); });
  }

  [[nodiscard]] OfflineResult localized(const OccupancyGrid& map, const LocalizationConfig& config,
                                        const std::optional<Kidnapping>& kidnapping = {}) const {
    mcap::Reader reader{mcap::file_source(file_), file_};
    return localize_offline(reader, map, {.config = config, .kidnapping = kidnapping}, [](double) { return true; });
  }
  [[nodiscard]] std::optional<Kidnapping> kidnapping(double seconds, std::span<const TimedPose> truth) const {
    mcap::Reader reader{mcap::file_source(file_), file_};
    return kidnapping_at(reader, Time{from_seconds(seconds)}, truth, 1);
  }

 private:
  test::TemporaryFolder folder_;
  std::string file_ = (folder_ / "log.mcap").string();
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

class LocalizeFr079AfterAKidnapping : public ::testing::TestWithParam<double> {};

TEST_P(LocalizeFr079AfterAKidnapping, FindsTheRobotAgainAndIsNeverWronglyOk) {
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
  const auto kidnapping = recording.kidnapping(GetParam(), truth);
  ASSERT_TRUE(kidnapping);
  const Pose2 from = pose_at(truth, kidnapping->lifted_at).value();
  const Pose2 to = pose_at(truth, kidnapping->put_down_at).value();
  EXPECT_GE((to.position() - from.position()).norm(), 3.0);
  EXPECT_EQ(recording.kidnapping(5000.0, truth), std::nullopt);  // long after the end

  const OfflineResult result = recording.localized(map, config, kidnapping);

  const auto after = std::span{result.poses}.subspan(result.before_kidnapping);
  const auto way_m = std::span{result.way_m}.subspan(result.before_kidnapping);
  const Recovery recovery = recovery_of(after, way_m, kidnapping->put_down_at, truth, 0.0);
  ASSERT_TRUE(recovery.flagged_s);
  EXPECT_LE(*recovery.flagged_s, 2.0);
  ASSERT_TRUE(recovery.recovered_m);
  EXPECT_LE(*recovery.recovered_m - way_m.front(), 10.0);
  EXPECT_EQ(recovery.ok_but_wrong, 0U);
}

// At 100, 250, 500 and 600 s it is put down where much looks alike: only the scan before tells.
INSTANTIATE_TEST_SUITE_P(AtSeconds, LocalizeFr079AfterAKidnapping, ::testing::Values(60.0, 100.0, 250.0, 500.0, 600.0));

}  // namespace
}  // namespace tandem::cli
