#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "services/common/time.hpp"

namespace tandem {

/// When to open a device again after it was lost, and at which rate: soon at first, then less and less often.
class Reconnection {
 public:
  /// `baud_rates`: those a serial sensor may have been left at, most likely first; at least one.
  explicit Reconnection(std::vector<int> baud_rates) : baud_rates_(std::move(baud_rates)) {}

  /// The device was opened and served; the next loss is met at once.
  void succeeded() { failures_ = 0; }
  /// It could not be opened, or was lost. `silent`: opened, but nothing sensible came: the next rate is tried.
  void failed(bool silent) {
    ++failures_;
    if (silent) rate_ = (rate_ + 1) % baud_rates_.size();
  }
  /// The sensor was set to `baud_rate`: it is looked for there first.
  void switched_to(int baud_rate) {
    const auto found = std::find(baud_rates_.begin(), baud_rates_.end(), baud_rate);
    if (found != baud_rates_.end()) rate_ = static_cast<std::size_t>(found - baud_rates_.begin());
  }
  /// How long to wait before opening it again: 0.1 s, doubled with each failure in a row, at most 1 s.
  [[nodiscard]] Duration delay() const {
    Duration delay = std::chrono::milliseconds{100};
    for (int i = 1; i < failures_ && delay < kMostDelay; ++i) delay *= 2;
    return delay < kMostDelay ? delay : kMostDelay;
  }
  [[nodiscard]] int baud_rate() const { return baud_rates_[rate_]; }

 private:
  static constexpr Duration kMostDelay = std::chrono::seconds{1};
  std::vector<int> baud_rates_;
  int failures_ = 0;
  std::size_t rate_ = 0;
};

}  // namespace tandem
