#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"
#include "services/navigator/core/avoidance.hpp"
#include "services/navigator/core/navigator_config.hpp"
#include "services/navigator/core/path_follower.hpp"
#include "services/navigator/core/plan_keeper.hpp"
#include "services/navigator/core/way_back.hpp"
#include "services/navigator/core/zones.hpp"

namespace tandem::navigator {

enum class PoseQuality { Good, Uncertain, Lost };

/// Where the robot was when a scan or the wheels said so, and when that was heard here.
struct LocatedPose {
  Pose2 map_from_base;
  PoseQuality quality = PoseQuality::Good;
  Time stamp{};
  Time received{};
};

/// What a scan hit, in the base frame of the moment it was taken.
struct ScanHits {
  std::vector<Eigen::Vector2d> points_in_base;
  Time stamp{};
  Time received{};
};

struct WalkingPerson {
  Eigen::Vector2d position_in_map{0.0, 0.0};
  Eigen::Vector2d velocity_in_map_mps{0.0, 0.0};
};

/// What the base says about itself.
struct BaseReport {
  std::string stopped_by;    ///< Why the gate holds the wheels; empty while they are free.
  bool by_obstacle = false;  ///< And that this is something in the way.
};

/// What to do while the link to the operator is gone.
enum class LinkLoss { Stop, FinishLeg, Retreat };

/// All the navigator knows at a moment.
struct Situation {
  Time now{};
  std::optional<std::string> running_session;  ///< Its code; none while no session runs.
  std::optional<LocatedPose> pose;
  std::optional<ScanHits> obstacles;
  Twist2 velocity;  ///< As the wheels measured it last.
  std::vector<WalkingPerson> people;
  BaseReport base;
  bool link_lost = false;  ///< It was there, and is gone.
};

/// How the plan goes.
struct Execution {
  std::string plan_id;
  double progress = 0.0;  ///< [0, 1] of the robot's path
  bool moving = false;
  bool finished = false;
  bool blocked = false;
  Eigen::Vector2d blocked_at_in_map{0.0, 0.0};
  std::string reason;  ///< Why it stands still; empty while it moves.

  /// Differences that others should hear of at once; progress is not one.
  [[nodiscard]] bool differs_from(const Execution& other) const;
};

struct Decision {
  Twist2 velocity;
  Execution execution;
};

/// Executes accepted plans: from all that is known at a moment to the velocity of the next 50 ms.
///
/// Stands still unless everything it relies on is there and fresh. Never backwards, never sideways.
class Navigator {
 public:
  explicit Navigator(const NavigatorConfig& config, LinkLoss link_loss = LinkLoss::Stop, Zones zones = {});

  void receive_plan(PlanNews news, Time received) { plans_.receive(std::move(news), received); }
  [[nodiscard]] Decision decide(const Situation& situation);

 private:
  [[nodiscard]] std::string reason_to_stand(const Situation& situation) const;
  void take_up_plan(const Pose2& map_from_base, Time now);
  void begin(Path path, const Pose2& map_from_base, Time now);
  /// Goes back the way it came, or leaves that once the link is there again. True while it goes back.
  bool retreat(const Situation& situation, const Pose2& map_from_base);
  [[nodiscard]] Twist2 velocity_for(const Course& course, const Aim& aim, const Situation& situation,
                                    const Pose2& map_from_base) const;
  void watch_advance(const Situation& situation, const Pose2& map_from_base, const Aim& aim);

  /// Since when it has not got on, by one measure of getting on.
  struct Advance {
    Time since{};
    Pose2 map_from_base;
    double way_m = 0.0;
  };

  NavigatorConfig config_;
  PlanKeeper plans_;
  PathFollower follower_;
  Avoidance avoidance_;
  LinkLoss link_loss_;
  Zones zones_;
  WayBack way_back_;
  bool retreating_ = false;
  std::string plan_id_;  ///< of the path that is followed
  bool finished_ = false;
  Twist2 last_velocity_;
  bool wanted_to_move_ = false;
  Advance last_motion_;    ///< when and where it last moved at all
  Advance last_progress_;  ///< when and where it last got on along the path
};

/// The pose `age_s` after `pose` at the constant velocity `velocity`.
[[nodiscard]] Pose2 moved_on(const Pose2& pose, const Twist2& velocity, double age_s);

}  // namespace tandem::navigator
