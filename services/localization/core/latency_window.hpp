#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

#include "services/common/time.hpp"

namespace tandem {

/// How old the last poses were when they were sent.
class LatencyWindow {
 public:
  explicit LatencyWindow(std::size_t count) : count_(count) {}

  void add(Duration latency) {
    latencies_.push_back(latency);
    if (latencies_.size() > count_) latencies_.pop_front();
  }
  [[nodiscard]] bool empty() const { return latencies_.empty(); }
  /// The latency that a share of `quantile` [0, 1] of them does not exceed; not of an empty window.
  [[nodiscard]] Duration quantile(double quantile) const {
    std::vector<Duration> sorted{latencies_.begin(), latencies_.end()};
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(quantile * static_cast<double>(sorted.size() - 1))];
  }

 private:
  std::size_t count_;
  std::deque<Duration> latencies_;  ///< oldest first
};

}  // namespace tandem
