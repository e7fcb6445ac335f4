#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "services/recorder/carmen_import.hpp"
#include "services/recorder/core/disposed_record.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/player.hpp"
#include "services/recorder/recorder_service.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::recorder {
namespace {

using std::chrono::seconds;

/// A folder of its own, gone at the end.
class Recording : public testing::Test {
 protected:
  [[nodiscard]] bus::DomainOptions options(const std::string& name, bus::Pace pace = bus::Pace::RealTime) const {
    bus::DomainOptions options;
    options.domain = domain_[0];
    options.participant = name;
    options.pace = pace;
    return options;
  }
  /// `count` odometry samples and scans in turn, 0.1 s apart.
  [[nodiscard]] std::filesystem::path imported(int count) const {
    std::vector<carmen::Event> events;
    for (int i = 0; i < count; ++i) {
      events.push_back(carmen::Odometry{1.0 + 0.1 * i, Pose2{0.5 * i, 0.0, 0.0}});
      events.push_back(carmen::Scan{1.0 + 0.1 * i, -1.5, 0.01, {1.0F, 2.0F}});
    }
    const auto file = folder_ / "imported.mcap";
    write_recording(file, [&](mcap::Writer& writer) { write_carmen(events, "robot1", writer); });
    return file;
  }

  test::DomainLease domain_{1};
  test::TemporaryFolder folder_;
};

/// Payloads of `topic`, in order.
std::vector<mcap::Bytes> payloads(const std::filesystem::path& file, const std::string& topic) {
  mcap::Reader reader{mcap::file_source(file), file.string()};
  std::vector<mcap::Bytes> all;
  const mcap::Channel* channel = reader.channel_of(topic);
  for (std::size_t i = 0; channel != nullptr && i < reader.message_count(); ++i) {
    const auto message = reader.message_at(i);
    if (message && message->channel_id == channel->id) all.emplace_back(message->data.begin(), message->data.end());
  }
  return all;
}

TEST_F(Recording, HoldsEachSampleByteForByteAndTheEndOfAnInstance) {
  bus::Bus recorder_bus{options("recorder")};
  bus::Bus tracker{options("tracker")};
  const auto file = folder_ / "a.mcap";
  RecorderService service{
      {}, {}, file, {{0, 0, "config/site.toml", "application/toml", "host = \"r\"\n"}}, recorder_bus};
  auto teammates = tracker.writer(topic::kTeammates);
  msg::TeammateState state;
  state.agent("person1");
  state.stamp_ns(5);
  ASSERT_TRUE(bus::wait_until(tracker, seconds{10}, [&] { return teammates.raw().matched_readers() == 1; }));
  ASSERT_TRUE(teammates.write(state));
  while (payloads(file, "teammates").empty()) service.step();
  ASSERT_TRUE(teammates.dispose(state));
  const auto disposed = std::string{"teammates"} + std::string{kDisposedSuffix};
  while (payloads(file, disposed).empty()) service.step();
  (void)service.finish();

  EXPECT_EQ(payloads(file, "teammates").at(0), bus::encode<msg::TeammateStatePubSubType>(state));
  EXPECT_EQ(disposed_key(payloads(file, disposed).at(0)), bus::key_of<msg::TeammateStatePubSubType>(state));
  mcap::Reader reader{mcap::file_source(file), "a.mcap"};
  EXPECT_TRUE(reader.complete());
  EXPECT_EQ(reader.attachments().at(0).name, "config/site.toml");
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST_F(Recording, OfAReplayHoldsTheSamePayloads) {
  const auto original = imported(20);
  bus::Bus recorder_bus{options("recorder")};
  bus::Bus player_bus{options("replay")};
  const auto file = folder_ / "again.mcap";
  RecorderService service{{}, {}, file, {}, recorder_bus};
  mcap::Reader reader{mcap::file_source(original), "imported.mcap"};
  Player player{reader, player_bus, {}};
  std::atomic<bool> over = false;
  std::thread recording{[&] {
    while (!over) service.step();
  }};
  EXPECT_EQ(player.play([](double) { return true; }, {}), 40U);
  EXPECT_TRUE(bus::wait_until(player_bus, seconds{10}, [&] {  // the last is still on its way
    return payloads(file, "scan").size() == 20 && payloads(file, "odometry").size() == 20;
  }));
  over = true;
  recording.join();
  (void)service.finish();

  EXPECT_TRUE(payloads(file, "scan") == payloads(original, "scan"));
  EXPECT_TRUE(payloads(file, "odometry") == payloads(original, "odometry"));
  EXPECT_FALSE(payloads(file, "clock").empty());
}

TEST_F(Recording, InLockstepEveryScanFindsAllOdometryBeforeIt) {
  const auto file = imported(50);
  std::atomic<bool> over = false;
  // Stands for localization: the pose tells how many odometry samples had come.
  std::thread localization{[&] {
    bus::Bus bus{options("localization", bus::Pace::Lockstep)};
    auto odometry = bus.in_order(topic::kOdometry);
    auto scans = bus.in_order(topic::kScan);
    auto poses = bus.writer(topic::kRobotPose);
    double count = 0.0;
    while (!over) {
      const auto new_scans = scans.take();
      count += static_cast<double>(odometry.take().size());
      for (const auto& scan : new_scans) {
        msg::RobotPose pose;
        pose.robot("robot1");
        pose.stamp_ns(scan.message.stamp_ns());
        pose.map_from_base().x(count);
        poses.write(pose);
      }
      bus.wait(std::chrono::milliseconds{10});
    }
  }};
  bus::Bus bus{options("replay", bus::Pace::Lockstep)};
  mcap::Reader reader{mcap::file_source(file), "imported.mcap"};
  ReplayOptions replay;
  replay.lockstep = true;
  Player player{reader, bus, replay};
  std::vector<double> counts;
  EXPECT_EQ(player.play([](double) { return true; },
                        [&](const msg::RobotPose& pose) { counts.push_back(pose.map_from_base().x()); }),
            100U);
  over = true;
  localization.join();
  ASSERT_EQ(counts.size(), 50U);
  for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_EQ(counts[i], static_cast<double>(i + 1));
}

TEST_F(Recording, IsNotReplayedBesideARealBase) {
  const auto file = imported(1);
  bus::Bus base{options("base")};
  auto status = base.writer(topic::kBaseStatus);
  bus::Bus bus{options("replay")};
  mcap::Reader reader{mcap::file_source(file), "imported.mcap"};
  EXPECT_THROW((Player{reader, bus, {}}), std::runtime_error);
}

TEST_F(Recording, NeverOverwritesAnother) {
  RecorderConfig config;
  config.folder = folder_.path().string();
  config.name = "a";
  EXPECT_EQ(recording_path(config, {}), folder_ / "a.mcap");
  { RecordFile first{folder_ / "a.mcap"}; }
  EXPECT_EQ(recording_path(config, {}), folder_ / "a-2.mcap");
}

TEST_F(Recording, ThatCannotBeWrittenLeavesNothingBehind) {
  const auto file = folder_ / "a.mcap";
  EXPECT_THROW(write_recording(file, [](mcap::Writer&) { throw std::runtime_error("bad line"); }), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace tandem::recorder
