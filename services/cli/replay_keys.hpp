#pragma once

#include <string>

#include "services/recorder/core/replay_plan.hpp"

namespace tandem::cli {

/// What the keys of `tandem replay` mean: space pauses and goes on, `.` sends one message more and pauses, `q` ends.
class ReplayKeys {
 public:
  /// The wish after `typed` was typed.
  [[nodiscard]] recorder::ReplayWish wish_after(const std::string& typed);
  [[nodiscard]] bool is_paused() const { return is_paused_; }

 private:
  bool is_paused_ = false;
  int steps_ = 0;  ///< asked for, not yet made
};

}  // namespace tandem::cli
