#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "services/recorder/core/byte_source.hpp"

namespace tandem::ros {

/// A bag that cannot be read; what() says where and why.
class BagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A message of a bag, its bytes still packed.
struct BagMessage {
  std::string topic;
  std::string type;          ///< "sensor_msgs/LaserScan"
  std::int64_t time_ns = 0;  ///< when it was recorded
  mcap::ByteView data;       ///< valid during the call
};
using OnBagMessage = std::function<void(const BagMessage&)>;

/// Gives each message of a ROS 1 bag (format 2.0; chunks plain, bz2 or lz4) in the order of the file.
///
/// A bag that was not closed is read up to its last whole chunk. Throws BagError, with `name` and the byte, for what is
/// no such bag, and for a damaged chunk.
void read_ros1_bag(mcap::ByteSource& source, const std::string& name, const OnBagMessage& on_message);

}  // namespace tandem::ros
