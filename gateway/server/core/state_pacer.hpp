#pragma once

#include <optional>

#include "gateway/protocol/messages.hpp"
#include "services/common/time.hpp"

namespace tandem::gateway {

/// Decides when the phones get a new state: at once when something changed, but at most every `least`, and every `most`
/// even when nothing did, so that a silent link is told from a quiet robot.
class StatePacer {
 public:
  StatePacer(Duration least, Duration most) : least_(least), most_(most) {}

  /// `state` with its number if it is to be sent now. Ages and counters of seconds alone are no change: the phone goes
  /// on counting them itself.
  [[nodiscard]] std::optional<protocol::State> next(protocol::State state, Time now);
  [[nodiscard]] const std::optional<protocol::State>& last() const { return last_; }

 private:
  Duration least_;
  Duration most_;
  Time sent_{};
  std::optional<protocol::State> last_;
};

}  // namespace tandem::gateway
