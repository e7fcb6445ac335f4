#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/recorder/core/mcap_records.hpp"

/// The messages of ROS that are imported, as values; both of its wire formats. Only what lies in the plane is kept.
namespace tandem::ros {

/// How the bytes of a message are laid out.
enum class Wire {
  Ros1,  ///< packed, little-endian, with a sequence number in the header
  Cdr,   ///< ROS 2: CDR with its encapsulation header
};

struct Header {
  std::int64_t stamp_ns = 0;
  std::string frame;
};
struct LaserScan {
  Header header;
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double beam_interval_s = 0.0;
  double scan_period_s = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m{};
  std::vector<float> intensities{};
};
struct Odometry {
  Header header;
  std::string child_frame;
  Pose2 odom_from_base;
  std::array<double, 9> covariance{};  ///< of (x, y, heading), row-major
  double forward_mps = 0.0;
  double left_mps = 0.0;
  double turn_rate_radps = 0.0;
};
struct Transform {
  Header header;  ///< its frame is the parent
  std::string child_frame;
  Pose2 parent_from_child;      ///< heading: of the child's x axis
  bool is_upside_down = false;  ///< the child's z axis points down in the parent
};
using Transforms = std::vector<Transform>;
struct OccupancyGrid {
  Header header;
  double resolution_m = 0.0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Pose2 map_from_grid;
  std::vector<std::uint8_t> cells{};  ///< row by row from the lower left: 0 free, 100 occupied, 255 unknown
};
using Message = std::variant<LaserScan, Odometry, Transforms, OccupancyGrid>;

/// Whether messages of `type` are imported: "sensor_msgs/LaserScan" (ROS 1) or "sensor_msgs/msg/LaserScan" (ROS 2),
/// and so nav_msgs Odometry, nav_msgs OccupancyGrid, tf2_msgs or tf TFMessage.
[[nodiscard]] bool is_known(const std::string& type);

/// The message of `type` in `bytes`; none if they are not a whole one, or the type is not known.
[[nodiscard]] std::optional<Message> parse(const std::string& type, Wire wire, mcap::ByteView bytes);

}  // namespace tandem::ros
