#include <gtest/gtest.h>

#include <atomic>
#include <memory>
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

const Player::Steer kPlay = [](double) { return ReplayWish::Play; };

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

/// A recorder and a tracker that talks to it, one message at a time.
struct RecordedTracker {
  RecordedTracker(const bus::DomainOptions& recorder, const bus::DomainOptions& tracker, const RecorderConfig& config,
                  const std::filesystem::path& file)
      : recorder_bus(recorder), tracker_bus(tracker), service(config, {}, file, {}, recorder_bus) {
    EXPECT_TRUE(bus::wait_until(tracker_bus, seconds{10}, [&] { return teammates.raw().matched_readers() == 1; }));
  }
  void say(int stamp, const std::string& agent = "person1") {
    msg::TeammateState state;
    state.agent(agent);
    state.stamp_ns(stamp);
    ASSERT_TRUE(teammates.write(state));
  }
  bus::Bus recorder_bus;
  bus::Bus tracker_bus;
  RecorderService service;
  bus::Writer<msg::TeammateState, msg::TeammateStatePubSubType> teammates = tracker_bus.writer(topic::kTeammates);
};

/// Stamps of all teammates of a recording.
std::vector<std::int64_t> stamps(const std::filesystem::path& file) {
  std::vector<std::int64_t> all;
  for (const mcap::Bytes& payload : payloads(file, "teammates")) {
    const auto state = bus::decode<msg::TeammateStatePubSubType>(payload);
    all.push_back(state ? state->stamp_ns() : -1);
  }
  return all;
}

TEST_F(Recording, GoesOnInANewFileWithoutLosingOrDoublingAMessage) {
  RecorderConfig config;
  config.topics = {"teammates"};
  config.rotate_s = 0.2;
  const auto file = folder_ / "a.mcap";
  RecordedTracker tracker{options("recorder"), options("tracker"), config, file};
  int said = 0;
  while (!std::filesystem::exists(folder_ / "a_part4.mcap")) {
    tracker.say(++said);
    while (tracker.service.message_count() < static_cast<std::uint64_t>(said)) tracker.service.step();
  }
  EXPECT_NE(tracker.service.finish().find("a.mcap and 3 more parts: "), std::string::npos);

  std::vector<std::int64_t> all;
  for (const char* name : {"a.mcap", "a_part2.mcap", "a_part3.mcap", "a_part4.mcap"}) {
    mcap::Reader reader{mcap::file_source(folder_ / name), name};
    EXPECT_TRUE(reader.complete()) << name;
    for (const std::int64_t stamp : stamps(folder_ / name)) all.push_back(stamp);
  }
  ASSERT_EQ(all.size(), static_cast<std::size_t>(said));
  for (int i = 0; i < said; ++i) EXPECT_EQ(all[static_cast<std::size_t>(i)], i + 1);
}

TEST_F(Recording, GoesOnInANewFileWhenOneIsLarge) {
  RecorderConfig config;
  config.topics = {"map"};
  config.rotate_mb = 1;
  config.compact_at_close = false;
  bus::Bus recorder_bus{options("recorder")};
  bus::Bus server{options("map_server")};
  RecorderService service{config, {}, folder_ / "a.mcap", {}, recorder_bus};
  auto maps = server.writer(topic::kMap);
  ASSERT_TRUE(bus::wait_until(server, seconds{10}, [&] { return maps.raw().matched_readers() == 1; }));
  msg::OccupancyGrid map;
  map.cells(std::vector<std::uint8_t>(400'000));
  for (std::uint64_t said = 1; said <= 4; ++said) {
    ASSERT_TRUE(maps.write(map));
    while (service.message_count() < said) service.step();
  }
  (void)service.finish();
  EXPECT_EQ(payloads(folder_ / "a.mcap", "map").size(), 3U);  // 1.2 MB
  EXPECT_EQ(payloads(folder_ / "a_part2.mcap", "map").size(), 1U);
}

TEST_F(Recording, WithPreRollBeginsBeforeTheEvent) {
  RecorderConfig config;
  config.topics = {"teammates", "pose_hint"};
  config.pre_roll_s = 60.0;
  config.event_topics = {"pose_hint"};
  const auto file = folder_ / "a.mcap";
  RecordedTracker tracker{options("recorder"), options("tracker"), config, file};
  auto hints = tracker.tracker_bus.writer(topic::kPoseHint);
  ASSERT_TRUE(bus::wait_until(tracker.tracker_bus, seconds{10}, [&] { return hints.raw().matched_readers() == 1; }));
  tracker.say(1, "person1");
  tracker.say(2, "person2");
  for (int i = 0; i < 5; ++i) tracker.service.step();
  EXPECT_FALSE(std::filesystem::exists(file));
  ASSERT_TRUE(hints.write({}));
  while (tracker.service.message_count() < 3) tracker.service.step();
  tracker.say(3);
  while (tracker.service.message_count() < 4) tracker.service.step();
  (void)tracker.service.finish();
  EXPECT_EQ(stamps(file), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(payloads(file, "pose_hint").size(), 1U);
}

TEST_F(Recording, HoldsTheChosenTopicsAlone) {
  RecorderConfig config;
  config.topics = {"team*"};
  config.without_topics = {"*_plan"};
  bus::Bus recorder_bus{options("recorder")};
  bus::Bus others{options("others")};
  RecorderService service{config, {}, folder_ / "a.mcap", {}, recorder_bus};
  auto teammates = others.writer(topic::kTeammates);
  auto plan = others.writer(topic::kTeamPlan);
  auto odometry = others.writer(topic::kOdometry);
  ASSERT_TRUE(bus::wait_until(others, seconds{10}, [&] { return teammates.raw().matched_readers() == 1; }));
  EXPECT_EQ(plan.raw().matched_readers(), 0);
  EXPECT_EQ(odometry.raw().matched_readers(), 0);
}

TEST_F(Recording, SaysWhatItHadToDrop) {
  RecorderConfig config;
  config.topics = {"teammates"};
  config.queue_limit = 10;
  const auto file = folder_ / "a.mcap";
  RecordedTracker tracker{options("recorder"), options("tracker"), config, file};
  // Nobody writes to the disk meanwhile: 5 of these 15 find no room.
  for (int i = 1; i <= 15; ++i) tracker.say(i, "person" + std::to_string(i));
  ASSERT_TRUE(tracker.teammates.raw().wait_for_acknowledgments(seconds{10}));
  while (tracker.service.message_count() < 10) tracker.service.step();
  (void)tracker.service.finish();
  mcap::Reader reader{mcap::file_source(file), "a.mcap"};
  std::string dropped;
  for (const mcap::Metadata& record : reader.metadata()) {
    if (record.name == "dropped") dropped = record.entries.at("teammates");
  }
  EXPECT_EQ(dropped, std::to_string(15 - stamps(file).size()));
  EXPECT_EQ(dropped, "5");
}

TEST_F(Recording, OfAReplayHoldsTheSamePayloads) {
  const auto original = imported(20);
  bus::Bus recorder_bus{options("recorder")};
  bus::Bus watcher{options("watcher")};
  auto player_bus = std::make_unique<bus::Bus>(options("replay"));
  const auto file = folder_ / "again.mcap";
  RecorderService service{{}, {}, file, {}, recorder_bus};
  mcap::Reader reader{mcap::file_source(original), "imported.mcap"};
  auto player = std::make_unique<Player>(reader, *player_bus, ReplayOptions{});
  std::atomic<bool> over = false;
  std::thread recording{[&] {
    while (!over) service.step();
  }};
  EXPECT_EQ(player->play(kPlay, {}), 40U);
  player.reset();  // as the program ends, at once
  player_bus.reset();
  EXPECT_TRUE(bus::wait_until(watcher, seconds{10}, [&] {  // the last is still on its way
    return payloads(file, "scan").size() == 20 && payloads(file, "odometry").size() == 20;
  }));
  over = true;
  recording.join();
  (void)service.finish();

  EXPECT_TRUE(payloads(file, "scan") == payloads(original, "scan"));
  EXPECT_TRUE(payloads(file, "odometry") == payloads(original, "odometry"));
  EXPECT_FALSE(payloads(file, "clock").empty());
}

/// A recording of teammates: person1 at 1 s, person2 at 2 s, the end of person1 at 3 s, person2 again at 4 s.
mcap::Reader teammates_recording() {
  mcap::Bytes bytes;
  const auto sink = [&bytes](mcap::ByteView record) {
    bytes.insert(bytes.end(), record.begin(), record.end());
    return true;
  };
  mcap::LiveWriter writer{sink, {}};
  mcap::ChannelTable channels{writer};
  const auto write = [&](const std::string& agent, std::uint64_t time_s) {
    msg::TeammateState state;
    state.agent(agent);
    state.stamp_ns(static_cast<std::int64_t>(time_s));
    const auto payload = bus::encode<msg::TeammateStatePubSubType>(state);
    channels.write(channels.channel_of("teammates", "tandem::msg::TeammateState", ""), time_s * 1'000'000'000, 0,
                   payload);
    return bus::key_of<msg::TeammateStatePubSubType>(state);
  };
  const bus::KeyHash person1 = write("person1", 1);
  write("person2", 2);
  channels.write(channels.channel_of("teammates" + std::string{kDisposedSuffix}, "", "", kDisposedEncoding),
                 3'000'000'000, 0, person1);
  write("person2", 4);
  writer.finish();
  return mcap::Reader{mcap::memory_source(bytes), "teammates.mcap"};
}

TEST_F(Recording, TheEndOfAnInstanceIsReplayed) {
  bus::Bus player_bus{options("replay")};
  bus::Bus planner{options("planner")};
  auto teammates = planner.latest(topic::kTeammates);
  mcap::Reader reader = teammates_recording();
  ReplayOptions replay;
  replay.rate = 0.0;
  Player player{reader, player_bus, replay};
  ASSERT_TRUE(bus::wait_until(planner, seconds{10}, [&] { return teammates.matched_writers() == 1; }));
  EXPECT_EQ(player.play(kPlay, {}), 4U);
  EXPECT_TRUE(bus::wait_until(planner, seconds{10}, [&] {
    const auto each = teammates.each();
    return each.size() == 1 && each[0].message.agent() == "person2" && each[0].message.stamp_ns() == 4;
  }));
}

TEST_F(Recording, WhatHadEndedBeforeTheBeginningIsNotSent) {
  bus::Bus player_bus{options("replay")};
  mcap::Reader reader = teammates_recording();
  ReplayOptions replay;
  replay.rate = 0.0;
  replay.from_s = 2.5;  // after person1 has ended
  Player player{reader, player_bus, replay};
  EXPECT_EQ(player.play(kPlay, {}), 2U);  // person2 as it was, and as it came
}

TEST_F(Recording, IsReplayedUpToATimeAndUnderAnotherName) {
  bus::Bus player_bus{options("replay")};
  bus::Bus viewer{options("viewer")};
  mcap::Reader reader = teammates_recording();
  ReplayOptions replay;
  replay.rate = 0.0;
  replay.until_s = 1.0;
  replay.rename = {{"teammates", "recorded_teammates"}};
  TopicInfo renamed = info_of(topic::kTeammates);
  renamed.name = "recorded_teammates";
  const auto box = std::make_shared<bus::LatestBox>();
  const auto subscription = viewer.subscribe(renamed, box);
  const auto usual = viewer.latest(topic::kTeammates);
  Player player{reader, player_bus, replay};
  ASSERT_TRUE(bus::wait_until(viewer, seconds{10}, [&] { return subscription->matched_writers() == 1; }));
  EXPECT_EQ(player.play(kPlay, {}), 2U);
  EXPECT_TRUE(bus::wait_until(viewer, seconds{10}, [&] { return box->each().size() == 2; }));
  EXPECT_EQ(usual.matched_writers(), 0);
}

TEST_F(Recording, APausedReplaySendsOneMessageAStep) {
  bus::Bus player_bus{options("replay")};
  mcap::Reader reader = teammates_recording();
  Player player{reader, player_bus, {}};
  std::vector<ReplayWish> wishes{ReplayWish::Pause, ReplayWish::Step,  ReplayWish::Pause,
                                 ReplayWish::Step,  ReplayWish::Pause, ReplayWish::End};
  std::size_t asked = 0;
  // The first message is due at once, without being asked for.
  EXPECT_EQ(player.play([&](double) { return wishes.at(asked++); }, {}), 3U);
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
  EXPECT_EQ(player.play(kPlay, [&](const msg::RobotPose& pose) { counts.push_back(pose.map_from_base().x()); }), 100U);
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
