#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem::navigator {

enum class PlanState { Proposed, Accepted, Rejected, Superseded };

/// One publication of a team plan, as far as it concerns this robot.
struct PlanNews {
  std::string id;
  std::string session;
  std::string planner;  ///< host and process
  std::uint64_t sequence_number = 0;
  PlanState state = PlanState::Proposed;
  Time valid_until{};
  std::vector<Eigen::Vector2d> points_in_map;  ///< of this robot; empty: the plan has no path for it
};

/// Which plan may be executed now: an accepted one that its planner keeps alive.
///
/// A plan is alive while its planner repeats it, or proposes the next one without withdrawing it. One that has been
/// heard a single time may be the last word of a dead planner, kept by the middleware for late joiners: it counts once
/// its planner has been heard again. While a plan is alive, another planner's is not taken up; and if the other goes on
/// publishing as well, none is executed: nobody can say which of the two the people look at.
class PlanKeeper {
 public:
  explicit PlanKeeper(Duration timeout) : timeout_(timeout) {}

  void receive(PlanNews news, Time received);

  enum class Standing { None, Proposed, Unconfirmed, Dead, Expired, OtherSession, NoPath, TwoPlanners, Executable };
  /// How the plan to be executed stands. `session` is the code of the session that is running.
  [[nodiscard]] Standing standing(Time now, const std::string& session) const;
  /// Who publishes beside the planner that is listened to; empty if nobody does at `now`.
  [[nodiscard]] const std::string& rival(Time now) const;
  [[nodiscard]] const std::string& planner() const { return planner_; }
  /// The newest accepted plan, else the newest proposed one; none before the first or after a rejection.
  [[nodiscard]] const std::optional<PlanNews>& plan() const { return plan_; }

 private:
  /// Another planner than the one that is listened to.
  struct Rival {
    std::string planner;
    std::uint64_t sequence_number = 0;
    Time first{};
    Time last{};
    bool repeats = false;  ///< one that was heard a single time may be dead
  };
  [[nodiscard]] bool is_alive(Time now) const;
  void note_rival(const PlanNews& news, Time received);

  Duration timeout_;
  std::optional<PlanNews> plan_;
  Time refreshed_{};
  Time planner_heard_{};
  std::string planner_;
  std::uint64_t last_sequence_number_ = 0;
  bool planner_alive_ = false;  ///< heard at least twice, no longer apart than the time-out
  Rival rival_;
};

}  // namespace tandem::navigator
