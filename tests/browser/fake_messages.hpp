#pragma once
// What the fake team's world looks like, as messages.

#include <cstdint>
#include <optional>
#include <string>

#include "idl/topics.hpp"
#include "services/common/time.hpp"

namespace tandem::test {

[[nodiscard]] msg::Point2 point(double x, double y);

/// A room of 24 x 16 m with columns, at 0.1 m.
[[nodiscard]] msg::OccupancyGrid fake_room();

struct FakeGoals {
  std::optional<msg::Point2> person;
  std::optional<msg::Point2> robot;
};
/// An accepted plan to the goals, or to places of its own.
[[nodiscard]] msg::TeamPlan fake_plan(int number, const msg::Point2& person, const FakeGoals& goals, Time now);

/// The likelier the nearer to a corner; what the robot has passed on its first `travelled_m` is searched.
[[nodiscard]] msg::SearchBelief fake_belief(double travelled_m, std::int64_t stamp_ns);

[[nodiscard]] msg::TeammateState fake_teammate(const msg::Point2& at, bool lost, std::int64_t stamp_ns);
[[nodiscard]] msg::BaseStatus fake_base_status(bool stopped, std::int64_t stamp_ns);
[[nodiscard]] msg::PlanExecution fake_execution(bool moving, std::int64_t stamp_ns);
[[nodiscard]] msg::LinkStatus fake_link_status();

/// The source that a planner makes of `edit`.
[[nodiscard]] msg::RewardSource fake_source(const msg::SourceEdit& edit);

}  // namespace tandem::test
