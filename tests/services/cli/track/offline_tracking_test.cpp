#include "services/cli/track/offline_tracking.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/recorder/carmen_import.hpp"
#include "services/recorder/core/carmen_log.hpp"
#include "services/recorder/core/text_log.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::cli {
namespace {

TrackingRun track(const std::string& log_text, const std::string& name, const std::vector<Annotation>& truth) {
  const test::TemporaryFolder folder;
  const auto file = folder / "people.mcap";
  recorder::write_recording(file, [&](mcap::Writer& writer) {
    recorder::write_carmen(parse_text_log(log_text, name, {}), "robot1", writer);
  });
  mcap::Reader recording{mcap::file_source(file), file.string()};
  return track_offline(recording, {}, truth, [](double) { return true; });
}

TEST(OfflineTracking, ReadsAnnotationsInTheOrderOfTheirTimes) {
  const auto annotations = parse_annotations("# x\nSCAN 0 1 2\nPERSON 2.5 b 1.0 -2.0\nPERSON 1.5 a 0.5 0.25\n", "log");
  ASSERT_EQ(annotations.size(), 2u);
  EXPECT_EQ(annotations[0].id, "a");
  EXPECT_EQ(annotations[1].position_in_laser, Eigen::Vector2d(1.0, -2.0));
  EXPECT_THROW((void)parse_annotations("PERSON 1.0 a 2.0\n", "log"), std::runtime_error);
}

/// One person walks past at 1 m/s, 2 m ahead of a laser with nothing else before it.
TEST(OfflineTracking, FollowsOneWhoWalksPast) {
  std::string log = "# SCAN_GEOMETRY angle_min -1.5 angle_increment 0.01 n 301 range_min 0.1 range_max 10.0\n";
  std::vector<Annotation> truth;
  for (int i = 0; i < 30; ++i) {
    const double time_s = 0.1 * i;
    const Eigen::Vector2d person{2.0, -1.5 + time_s};
    log += "SCAN " + std::to_string(time_s);
    for (int beam = 0; beam < 301; ++beam) {
      const double bearing = -1.5 + 0.01 * beam;
      double range = 0.0;
      for (const double side : {-0.15, 0.15}) {
        const Eigen::Vector2d leg = person + Eigen::Vector2d{0.0, side};
        const double off = leg.norm() * std::sin(bearing - std::atan2(leg.y(), leg.x()));
        if (std::abs(off) < 0.06) range = leg.norm() - std::sqrt(0.06 * 0.06 - off * off);
      }
      log += range > 0.0 ? " " + std::to_string(range) : std::string{" nan"};
    }
    log += "\n";
    if (i >= 5) truth.push_back({Time{} + from_seconds(time_s + 0.05), "walker", person + Eigen::Vector2d{0.0, 0.05}});
  }
  const TrackingRun run = track(log, "log", truth);
  EXPECT_EQ(run.scan_ms.size(), 30u);
  EXPECT_EQ(*run.people.recall(), 1.0);
  EXPECT_LT(*run.people.median_m(), 0.1);
  EXPECT_EQ(run.people.false_per_moment(), 0.0);
  EXPECT_EQ(run.named, 1u);
  EXPECT_EQ(run.followed, run.to_follow);
}

/// A robot that follows one person outdoors, without odometry (docs/tracking.md says what is not good enough yet).
TEST(OfflineTracking, SeesTheAnnotatedPersonOutdoors) {
  TANDEM_NEEDS_DATA("people")
  const auto file = test::data_folder() / "people" / "person_following_outdoor_1_first240s.txt.gz";
  const std::string log = carmen::read_log_file(file);
  const TrackingRun run = track(log, "outdoor", parse_annotations(log, "outdoor"));
  EXPECT_EQ(run.people.annotations(), 1811u);
  EXPECT_GT(*run.people.recall(), 0.95);
  EXPECT_LT(*run.people.median_m(), 0.15);
}

}  // namespace
}  // namespace tandem::cli
