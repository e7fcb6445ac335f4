#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bench/planning/instance/families.hpp"
#include "services/experiment/core/humans/human.hpp"
#include "services/experiment/core/humans/person_world.hpp"
#include "services/planner/core/motion/timed_path.hpp"

namespace tandem::bench {

/// The first person of an instance with a will of their own (S5): where they really walk while plans are made.
class PersonWalk {
 public:
  /// `searcher` is the number of the person in the instance.
  PersonWalk(const PlanningInstance& instance, const OccupancyGrid& ground, std::size_t searcher, std::uint64_t seed);

  /// Shows the person a new plan: the way it asks of them.
  void show_plan(const TimedPath& path);
  /// Walks for `stretch_s`, or until the person presses *My goal* or *Replan*, at least `least_s`. Gives where they
  /// went, from their pose at its beginning.
  [[nodiscard]] TimedPath walk(double stretch_s, double least_s);

  /// The goal that the person announced and has not reached yet [m].
  [[nodiscard]] const std::optional<Eigen::Vector2d>& goal() const { return goal_; }
  /// Where they are going now, from their pose on: what a planner may take for granted while they make up their mind.
  [[nodiscard]] TimedPath under_way(double duration_s) const;

 private:
  void step(double now_s, TimedPath& walked);

  std::unique_ptr<experiment::PersonWorld> world_;
  experiment::Human human_;
  Rng rng_;
  Pose2 pose_;
  double now_s_ = 0.0;
  std::vector<Eigen::Vector2d> route_;  ///< what is left of it
  std::optional<simulator::PhonePlan> plan_;
  int plans_ = 0;
  std::optional<Eigen::Vector2d> goal_;
  bool pressed_ = false;
};

}  // namespace tandem::bench
