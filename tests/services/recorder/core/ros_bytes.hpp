#pragma once

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "services/recorder/core/ros_messages.hpp"

/// Messages of ROS as bytes, written independently of what reads them.
namespace tandem::ros {

/// Appends values as one of the wire formats has them.
class RosBytes {
 public:
  explicit RosBytes(Wire wire) : wire_(wire) {}

  RosBytes& u8(std::uint8_t value) {
    body_.push_back(value);
    return *this;
  }
  RosBytes& u32(std::uint32_t value) { return number(value, 4); }
  RosBytes& f32(float value) { return number(std::bit_cast<std::uint32_t>(value), 4); }
  RosBytes& f64(double value) { return number(std::bit_cast<std::uint64_t>(value), 8); }
  RosBytes& text(const std::string& value) {
    u32(static_cast<std::uint32_t>(value.size()) + (wire_ == Wire::Cdr ? 1 : 0));
    body_.insert(body_.end(), value.begin(), value.end());
    return wire_ == Wire::Cdr ? u8(0) : *this;
  }
  /// At `seconds` and half a second.
  RosBytes& header(std::uint32_t seconds, const std::string& frame) {
    if (wire_ == Wire::Ros1) u32(99);
    return u32(seconds).u32(500'000'000).text(frame);
  }
  /// At (x, y), turned left by a right angle; `upside_down`: about its x axis first.
  RosBytes& pose(double x, double y, bool upside_down = false) {
    f64(x).f64(y).f64(0.7);
    const double half = std::sqrt(0.5);
    return upside_down ? f64(half).f64(half).f64(0.0).f64(0.0) : f64(0.0).f64(0.0).f64(half).f64(half);
  }
  [[nodiscard]] mcap::Bytes bytes() const {
    if (wire_ == Wire::Ros1) return body_;
    mcap::Bytes all{0, 1, 0, 0};
    all.insert(all.end(), body_.begin(), body_.end());
    return all;
  }

 private:
  RosBytes& number(std::uint64_t bits, std::size_t size) {
    while (wire_ == Wire::Cdr && body_.size() % size != 0) body_.push_back(0);
    for (std::size_t i = 0; i < size; ++i) body_.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    return *this;
  }

  Wire wire_;
  mcap::Bytes body_;
};

/// Three beams of 1, 2 and 3 m at -0.5, 0 and 0.5 rad.
inline mcap::Bytes scan_bytes(Wire wire, std::uint32_t seconds, const std::string& frame) {
  RosBytes bytes{wire};
  bytes.header(seconds, frame).f32(-0.5F).f32(0.5F).f32(0.5F).f32(0.0F).f32(0.125F).f32(0.25F).f32(8.0F);
  bytes.u32(3).f32(1.0F).f32(2.0F).f32(3.0F).u32(0);
  return bytes.bytes();
}

/// At (1, 2), turned left by a right angle, 0.5 m/s forward, 0.25 rad/s.
inline mcap::Bytes odometry_bytes(Wire wire, std::uint32_t seconds, const std::string& child) {
  RosBytes bytes{wire};
  bytes.header(seconds, "odom").text(child).pose(1.0, 2.0);
  for (int i = 0; i < 36; ++i) bytes.f64(i);
  bytes.f64(0.5).f64(0.0).f64(0.0).f64(0.0).f64(0.0).f64(0.25);
  for (int i = 0; i < 36; ++i) bytes.f64(0.0);
  return bytes.bytes();
}

inline mcap::Bytes transform_bytes(Wire wire, const std::string& parent, const std::string& child, double x, double y,
                                   bool upside_down = false) {
  return RosBytes{wire}.u32(1).header(1, parent).text(child).pose(x, y, upside_down).bytes();
}

/// Two cells wide, one high: free and unknown.
inline mcap::Bytes grid_bytes(Wire wire) {
  RosBytes bytes{wire};
  bytes.header(1, "map").u32(0).u32(0).f32(0.5F).u32(2).u32(1).pose(-1.0, -2.0).u32(2).u8(0).u8(255);
  return bytes.bytes();
}

}  // namespace tandem::ros
