#pragma once

#include <deque>
#include <string>

#include "robot/laser/core/laser_reading.hpp"

namespace tandem {

/// Watches the stream of scans for what a sensor that answers well can still do wrong. It only says so: whether the
/// robot may move is for the safety gate, which sees the same scans.
class ScanWatch {
 public:
  /// `expected_period_s`: from one scan to the next.
  explicit ScanWatch(double expected_period_s) : expected_period_s_(expected_period_s) {}

  void add(const LaserReading& reading);
  /// What is wrong now, in words; empty when nothing is.
  [[nodiscard]] std::string complaint() const;

 private:
  double expected_period_s_;
  std::deque<Time> stamps_;  ///< of the last scans
  std::vector<float> last_ranges_;
  int identical_ = 1;       ///< scans in a row with the same ranges
  bool all_blind_ = false;  ///< the last scan had no return at all
};

}  // namespace tandem
