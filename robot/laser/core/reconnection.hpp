#pragma once

#include <array>
#include <cstddef>

#include "services/common/time.hpp"

namespace tandem {

/// When to open a device again after it was lost, and at which rate: soon at first, then less and less often.
class Reconnection {
 public:
  /// Rates a serial SCIP sensor may have been left at, most likely first.
  static constexpr std::array kBaudRates{115'200, 19'200, 57'600, 250'000, 500'000, 750'000};

  /// The device was opened and served; the next loss is met at once.
  void succeeded() { failures_ = 0; }
  /// It could not be opened, or was lost. `silent`: opened, but nothing sensible came: the next rate is tried.
  void failed(bool silent) {
    ++failures_;
    if (silent) rate_ = (rate_ + 1) % kBaudRates.size();
  }
  /// How long to wait before opening it again: 0.1 s, doubled with each failure in a row, at most 1 s.
  [[nodiscard]] Duration delay() const {
    Duration delay = std::chrono::milliseconds{100};
    for (int i = 1; i < failures_ && delay < kMostDelay; ++i) delay *= 2;
    return delay < kMostDelay ? delay : kMostDelay;
  }
  [[nodiscard]] int baud_rate() const { return kBaudRates[rate_]; }

 private:
  static constexpr Duration kMostDelay = std::chrono::seconds{1};
  int failures_ = 0;
  std::size_t rate_ = 0;
};

}  // namespace tandem
