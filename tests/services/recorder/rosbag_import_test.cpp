#include "services/recorder/rosbag_import.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <numbers>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/common/file_io.hpp"
#include "services/recorder/rosbag_source.hpp"
#include "tests/services/recorder/core/mcap_files.hpp"
#include "tests/services/recorder/core/ros1_bags.hpp"
#include "tests/services/recorder/core/ros_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::recorder {
namespace {

using ros::BagLine;
using ros::Wire;

/// A small drive: a scan, odometry, where the laser is, a map.
std::vector<BagLine> drive(Wire wire) {
  const std::string msg = wire == Wire::Cdr ? "msg/" : "";
  return {{"/odom", "nav_msgs/" + msg + "Odometry", 1, ros::odometry_bytes(wire, 1, "base")},
          {"/scan", "sensor_msgs/" + msg + "LaserScan", 2, ros::scan_bytes(wire, 2, "laser")},
          {"/tf_static", "tf2_msgs/" + msg + "TFMessage", 2, ros::transform_bytes(wire, "base", "laser", 0.5, 0.25)},
          {"/map", "nav_msgs/" + msg + "OccupancyGrid", 3, ros::grid_bytes(wire)},
          {"/image", "sensor_msgs/" + msg + "Image", 3, {1, 2, 3}}};
}

std::string text_of(const mcap::Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

class RosbagImport : public testing::Test {
 protected:
  std::filesystem::path ros1(const std::vector<BagLine>& lines) {
    write_file_atomically(folder_ / "a.bag", text_of(ros::ros1_bag(lines, "lz4")));
    return folder_ / "a.bag";
  }
  std::filesystem::path rosbag2_mcap() {
    mcap::Bytes bytes;
    mcap::IndexedWriter writer{mcap::into(bytes), {"ros2", "test"}};
    std::uint16_t id = 0;
    for (const BagLine& line : drive(Wire::Cdr)) {
      ++id;
      writer.write(mcap::Schema{id, line.type, "ros2msg", "# not needed"});
      writer.write(mcap::Channel{id, id, line.topic, "cdr", {}});
      writer.write(mcap::Message{id, 0, time_of(line), 0, line.data});
    }
    EXPECT_TRUE(writer.finish());
    write_file_atomically(folder_ / "b.mcap", text_of(bytes));
    return folder_ / "b.mcap";
  }
  std::filesystem::path rosbag2_database() {
    const auto file = folder_ / "c.db3";
    sqlite3* database = nullptr;
    EXPECT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    const auto execute = [database](const std::string& sql) {
      EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sql;
    };
    execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT)");
    execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)");
    int id = 0;
    for (const BagLine& line : drive(Wire::Cdr)) {
      ++id;
      execute("INSERT INTO topics VALUES(" + std::to_string(id) + ",'" + line.topic + "','" + line.type + "','cdr')");
      std::string hex;
      for (const std::uint8_t byte : line.data) {
        for (const int digit : {byte >> 4, byte & 15}) hex += "0123456789abcdef"[digit];
      }
      execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(" + std::to_string(id) + "," +
              std::to_string(time_of(line)) + ",x'" + hex + "')");
    }
    sqlite3_close(database);
    return file;
  }
  static std::uint64_t time_of(const BagLine& line) { return line.time_s * 1'000'000'000ULL + 250'000'000; }

  mcap::Reader imported(const std::filesystem::path& bag, const RosbagOptions& options = {}) {
    mcap::Bytes bytes;
    mcap::IndexedWriter writer{mcap::into(bytes), {"", "test"}};
    count_ = import_rosbag(bag, options, writer, [] { return true; });
    EXPECT_TRUE(writer.finish());
    return mcap::opened(bytes);
  }
  template <class PubSubType>
  typename PubSubType::type first(mcap::Reader& reader, const Topic<PubSubType>& topic) {
    const mcap::Channel* channel = reader.channel_of(std::string{topic.name});
    for (std::size_t i = 0; channel != nullptr && i < reader.message_count(); ++i) {
      const auto message = reader.message_at(i);
      if (message->channel_id != channel->id) continue;
      return *bus::decode<PubSubType>({message->data.begin(), message->data.end()});
    }
    ADD_FAILURE() << topic.name << " is missing";
    return {};
  }

  test::TemporaryFolder folder_;
  RosbagCount count_;
};

TEST_F(RosbagImport, AllThreeKindsOfBagGiveTheSame) {
  for (const auto& bag : {ros1(drive(Wire::Ros1)), rosbag2_mcap(), rosbag2_database()}) {
    mcap::Reader reader = imported(bag);
    EXPECT_EQ(reader.message_count(), 3U) << bag;
    EXPECT_EQ(count_.broken, 0U);
    EXPECT_TRUE(count_.lost_lasers.empty());

    const msg::LaserScan scan = first(reader, topic::kScan);
    EXPECT_EQ(scan.robot(), "robot1");
    EXPECT_EQ(scan.stamp_ns(), 2'500'000'000);
    EXPECT_EQ(scan.base_from_laser().x(), 0.5);
    EXPECT_NEAR(scan.base_from_laser().heading(), std::numbers::pi / 2.0, 1e-12);
    EXPECT_EQ(scan.ranges_m(), (std::vector<float>{1.0F, 2.0F, 3.0F}));
    const msg::Odometry odometry = first(reader, topic::kOdometry);
    EXPECT_EQ(odometry.odom_from_base().y(), 2.0);
    EXPECT_EQ(odometry.velocity().forward_mps(), 0.5);
    const msg::OccupancyGrid map = first(reader, topic::kMap);
    EXPECT_EQ(map.map_id(), "/map");
    EXPECT_EQ(map.cells(), (std::vector<std::uint8_t>{0, 255}));
    EXPECT_EQ(reader.log_time_at(0), 1'250'000'000U);
  }
}

TEST_F(RosbagImport, WithoutOdometryTheTransformOfItsFrameIsTaken) {
  mcap::Reader reader =
      imported(ros1({{"/tf", "tf/tfMessage", 1, ros::transform_bytes(Wire::Ros1, "odom", "base_link", 3.0, 4.0)}}));
  EXPECT_EQ(first(reader, topic::kOdometry).odom_from_base().x(), 3.0);
}

TEST_F(RosbagImport, ALaserUpsideDownIsTurnedUp) {
  mcap::Reader reader =
      imported(ros1({{"/tf", "tf/tfMessage", 1, ros::transform_bytes(Wire::Ros1, "base_link", "laser", 0.0, 0.0, true)},
                     {"/scan", "sensor_msgs/LaserScan", 2, ros::scan_bytes(Wire::Ros1, 2, "laser")}}));
  EXPECT_EQ(first(reader, topic::kScan).ranges_m(), (std::vector<float>{3.0F, 2.0F, 1.0F}));
}

TEST_F(RosbagImport, ALaserThatNobodyPlacesIsNamed) {
  mcap::Reader reader =
      imported(ros1({{"/scan", "sensor_msgs/LaserScan", 2, ros::scan_bytes(Wire::Ros1, 2, "laser")}}));
  EXPECT_EQ(count_.lost_lasers, std::vector<std::string>{"laser"});
  EXPECT_EQ(count_.scans, 1U);
}

TEST_F(RosbagImport, OfTwoLasersOneMustBeChosen) {
  const auto bag = ros1({{"/front", "sensor_msgs/LaserScan", 2, ros::scan_bytes(Wire::Ros1, 2, "front")},
                         {"/rear", "sensor_msgs/LaserScan", 2, ros::scan_bytes(Wire::Ros1, 3, "rear")}});
  EXPECT_THROW((void)imported(bag), std::runtime_error);
  RosbagOptions options;
  options.scan_topic = "/rear";
  mcap::Reader reader = imported(bag, options);
  EXPECT_EQ(first(reader, topic::kScan).stamp_ns(), 3'500'000'000);
  options.scan_topic = "/top";
  EXPECT_THROW((void)imported(bag, options), std::runtime_error);
}

TEST_F(RosbagImport, AFolderIsReadFileByFileAndWhatIsNoBagIsRefused) {
  std::filesystem::create_directory(folder_ / "bag");
  EXPECT_THROW(read_rosbag(folder_ / "bag", [](const RosbagMessage&) { return true; }), std::runtime_error);
  std::filesystem::rename(rosbag2_database(), folder_ / "bag" / "bag_0.db3");
  std::filesystem::rename(rosbag2_mcap(), folder_ / "bag" / "bag_1.mcap");
  EXPECT_EQ(imported(folder_ / "bag").message_count(), 6U);
  write_file_atomically(folder_ / "notes.txt", "these are notes");
  EXPECT_THROW(read_rosbag(folder_ / "notes.txt", [](const RosbagMessage&) { return true; }), std::runtime_error);
}

}  // namespace
}  // namespace tandem::recorder
