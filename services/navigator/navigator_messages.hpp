#pragma once

#include <optional>
#include <string>

#include "idl/topics.hpp"
#include "services/navigator/core/navigator.hpp"

namespace tandem::navigator {

/// What `plan` has for `robot`.
[[nodiscard]] PlanNews plan_news(const msg::TeamPlan& plan, const std::string& robot);

/// The pose, but for when it was received.
[[nodiscard]] LocatedPose located_pose(const msg::RobotPose& pose);

/// Where the beams of `scan` ended, in the base frame; beams without a usable return are left out.
[[nodiscard]] ScanHits scan_hits(const msg::LaserScan& scan);

[[nodiscard]] Twist2 twist(const msg::Velocity2& velocity);

/// The passers-by and teammates of `people`.
[[nodiscard]] std::vector<WalkingPerson> walking_people(const msg::TrackedPeople& people);

[[nodiscard]] BaseReport base_report(const msg::BaseStatus& status);

/// The code of the session if it is running.
[[nodiscard]] std::optional<std::string> running_session(const msg::SessionState& session);

[[nodiscard]] msg::VelocityCommand velocity_command(const Twist2& velocity, const std::string& robot, Time now,
                                                    std::uint64_t sequence_number);

[[nodiscard]] msg::PlanExecution plan_execution(const Execution& execution, const std::string& robot, Time now);

}  // namespace tandem::navigator
