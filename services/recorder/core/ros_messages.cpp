#include "services/recorder/core/ros_messages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tandem::ros {
namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr std::uint32_t kMostTransforms = 100'000;

/// Takes values off a message; after one that is not there, everything is "not there".
class Fields {
 public:
  Fields(Wire wire, mcap::ByteView bytes) : wire_(wire), bytes_(bytes) {
    if (wire == Wire::Ros1) return;
    good_ = bytes.size() >= kEncapsulation && bytes[0] == 0 && bytes[1] <= 1;
    if (!good_) return;
    is_little_ = bytes[1] == 1;
    bytes_ = bytes.subspan(kEncapsulation);
  }
  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] Wire wire() const { return wire_; }

  template <typename Number>
  Number number() {
    if (wire_ == Wire::Cdr) at_ = (at_ + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number);
    const std::size_t begin = at_;
    skip(sizeof(Number));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; good_ && i < sizeof(Number); ++i) {
      bits |= static_cast<std::uint64_t>(bytes_[begin + i]) << (8 * (is_little_ ? i : sizeof(Number) - 1 - i));
    }
    return static_cast<Number>(bits);
  }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  float small_real() { return std::bit_cast<float>(number<std::uint32_t>()); }

  std::string text() {
    const auto length = number<std::uint32_t>();
    const std::size_t begin = at_;
    skip(length);
    if (!good_ || length == 0) return "";
    const std::size_t zero = wire_ == Wire::Cdr ? 1 : 0;  // CDR counts a zero at the end
    return {reinterpret_cast<const char*>(bytes_.data()) + begin, length - zero};
  }
  std::vector<float> small_reals() {
    const auto count = number<std::uint32_t>();
    std::vector<float> values;
    if (count > bytes_.size() / sizeof(float)) good_ = false;
    for (std::uint32_t i = 0; good_ && i < count; ++i) values.push_back(small_real());
    return values;
  }
  std::vector<std::uint8_t> octets() {
    const auto count = number<std::uint32_t>();
    const std::size_t begin = at_;
    skip(count);
    if (!good_) return {};
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(begin);
    return {first, first + count};
  }

 private:
  void skip(std::size_t count) {
    if (at_ > bytes_.size() || count > bytes_.size() - at_) good_ = false;
    if (good_) at_ += count;
  }

  Wire wire_;
  mcap::ByteView bytes_;
  std::size_t at_ = 0;
  bool is_little_ = true;
  bool good_ = true;
};

std::int64_t time(Fields& fields) {
  const auto seconds = fields.number<std::int32_t>();
  return static_cast<std::int64_t>(seconds) * 1'000'000'000 + fields.number<std::uint32_t>();
}

Header header(Fields& fields) {
  if (fields.wire() == Wire::Ros1) (void)fields.number<std::uint32_t>();  // sequence number
  Header header;
  header.stamp_ns = time(fields);
  header.frame = fields.text();
  if (header.frame.starts_with('/')) header.frame.erase(0, 1);  // as early ROS wrote them
  return header;
}

/// Position and rotation in space, as they lie in the plane.
struct PoseInPlane {
  Pose2 pose;
  bool is_upside_down = false;
};

PoseInPlane pose_in_plane(Fields& fields) {
  Pose2 pose;
  pose.x = fields.real();
  pose.y = fields.real();
  (void)fields.real();  // z
  const double x = fields.real();
  const double y = fields.real();
  const double z = fields.real();
  const double w = fields.real();
  pose.heading = std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
  return {pose, 1.0 - 2.0 * (x * x + y * y) < 0.0};
}

Pose2 pose(Fields& fields) {
  return pose_in_plane(fields).pose;
}

std::array<double, 36> covariance6(Fields& fields) {
  std::array<double, 36> values{};
  for (double& value : values) value = fields.real();
  return values;
}

LaserScan laser_scan(Fields& fields) {
  LaserScan scan;
  scan.header = header(fields);
  scan.angle_min_rad = fields.small_real();
  (void)fields.small_real();  // the last angle
  scan.angle_increment_rad = fields.small_real();
  scan.beam_interval_s = fields.small_real();
  scan.scan_period_s = fields.small_real();
  scan.range_min_m = fields.small_real();
  scan.range_max_m = fields.small_real();
  scan.ranges_m = fields.small_reals();
  scan.intensities = fields.small_reals();
  return scan;
}

Odometry odometry(Fields& fields) {
  Odometry odometry;
  odometry.header = header(fields);
  odometry.child_frame = fields.text();
  odometry.odom_from_base = pose(fields);
  const auto covariance = covariance6(fields);
  constexpr std::array<std::size_t, 3> kPlane{0, 1, 5};  // x, y and the turn about z
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      odometry.covariance[3 * row + column] = covariance[6 * kPlane[row] + kPlane[column]];
    }
  }
  odometry.forward_mps = fields.real();
  odometry.left_mps = fields.real();
  for (int i = 0; i < 3; ++i) (void)fields.real();  // up, and the turns about x and y
  odometry.turn_rate_radps = fields.real();
  (void)covariance6(fields);  // of the velocity
  return odometry;
}

Transforms transforms(Fields& fields) {
  Transforms all;
  const auto count = fields.number<std::uint32_t>();
  for (std::uint32_t i = 0; fields.good() && i < std::min(count, kMostTransforms); ++i) {
    Transform one;
    one.header = header(fields);
    one.child_frame = fields.text();
    if (one.child_frame.starts_with('/')) one.child_frame.erase(0, 1);
    const PoseInPlane placed = pose_in_plane(fields);
    one.parent_from_child = placed.pose;
    one.is_upside_down = placed.is_upside_down;
    all.push_back(one);
  }
  return all;
}

OccupancyGrid occupancy_grid(Fields& fields) {
  OccupancyGrid grid;
  grid.header = header(fields);
  (void)time(fields);  // when it was loaded
  grid.resolution_m = fields.small_real();
  grid.width = fields.number<std::uint32_t>();
  grid.height = fields.number<std::uint32_t>();
  grid.map_from_grid = pose(fields);
  grid.cells = fields.octets();  // -1, unknown, is 255
  return grid;
}

/// "nav_msgs/msg/Odometry" and "nav_msgs/Odometry" are one.
std::string without_msg(const std::string& type) {
  const std::size_t msg = type.find("/msg/");
  return msg == std::string::npos ? type : type.substr(0, msg) + type.substr(msg + 4);
}

std::optional<Message> message(const std::string& type, Fields& fields) {
  if (type == "sensor_msgs/LaserScan") return laser_scan(fields);
  if (type == "nav_msgs/Odometry") return odometry(fields);
  if (type == "tf2_msgs/TFMessage" || type == "tf/tfMessage") return transforms(fields);
  if (type == "nav_msgs/OccupancyGrid") return occupancy_grid(fields);
  return std::nullopt;
}

}  // namespace

bool is_known(const std::string& type) {
  constexpr std::array kTypes{"sensor_msgs/LaserScan", "nav_msgs/Odometry", "tf2_msgs/TFMessage", "tf/tfMessage",
                              "nav_msgs/OccupancyGrid"};
  return std::find(kTypes.begin(), kTypes.end(), without_msg(type)) != kTypes.end();
}

std::optional<Message> parse(const std::string& type, Wire wire, mcap::ByteView bytes) {
  Fields fields{wire, bytes};
  auto parsed = message(without_msg(type), fields);
  if (!fields.good()) return std::nullopt;
  if (const auto* grid = parsed ? std::get_if<OccupancyGrid>(&*parsed) : nullptr) {
    const bool fits = static_cast<std::uint64_t>(grid->width) * grid->height == grid->cells.size();
    if (!fits) return std::nullopt;
  }
  return parsed;
}

}  // namespace tandem::ros
