#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "services/common/time.hpp"

namespace tandem::recorder {

/// What to replay, and how fast.
struct ReplayOptions {
  double rate = 1.0;                                         ///< Recorded seconds per second; 0: as fast as it goes.
  double from_s = 0.0;                                       ///< Where to begin [s from the first message].
  double until_s = std::numeric_limits<double>::infinity();  ///< Where to end [s from the first message].
  std::vector<std::string> topics;                           ///< Empty: the usual ones.
  std::map<std::string, std::string> rename;  ///< Recorded topic to the one it is sent on; others keep their name.
  bool loop = false;
  bool lockstep = false;  ///< Lossless, and each scan waits for its robot_pose.
};

/// Whether messages of `topic` are sent again.
///
/// Without a choice of topics all are, but what speaks of the moment of recording (clock, health, link heartbeats,
/// receipts), and velocity commands, which would move a robot. In lockstep only what localization takes in: its output
/// is what is waited for.
[[nodiscard]] bool is_replayed(std::string_view topic, const ReplayOptions& options);

/// What the person at the keyboard wants of a replay.
enum class ReplayWish { Play, Pause, Step, End };

/// When what is due: recorded time runs from `first` at machine time `start`, `rate` times as fast, but while it is
/// stopped.
class ReplayPace {
 public:
  ReplayPace(Time first, Time start, double rate) : first_(first), start_(start), rate_(rate) {}
  /// Machine time at which a message of log time `logged` is sent; `start` for all where the rate is 0.
  [[nodiscard]] Time due(Time logged) const;
  /// Recorded time at machine time `now`; only for a rate above 0.
  [[nodiscard]] Time mission_time(Time now) const;

  /// Recorded time stands still from machine time `now` on.
  void stop(Time now);
  /// It goes on at machine time `now` from where it stood.
  void go_on(Time now);
  /// Stands still at the recorded time `logged`.
  void step_to(Time logged);
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

 private:
  Time first_;
  Time start_;
  double rate_;
  bool is_stopped_ = false;  ///< then first_ is where recorded time stands
};

}  // namespace tandem::recorder
