#pragma once

#include <optional>
#include <string>
#include <vector>

#include "idl/topics.hpp"
#include "services/mapping/core/occupancy_grid.hpp"
#include "services/tracking/core/leg_detection.hpp"
#include "services/tracking/core/people_tracker.hpp"
#include "services/tracking/core/teammate.hpp"

namespace tandem::tracking {

[[nodiscard]] LaserScan laser_scan(const msg::LaserScan& scan);

/// The map, or none if the message contradicts itself.
[[nodiscard]] std::optional<OccupancyGrid> occupancy_grid(const msg::OccupancyGrid& map);

/// None if the pose is lost or not finite: nothing can be placed in the map by it.
[[nodiscard]] std::optional<Pose2> usable_pose(const msg::RobotPose& pose);

[[nodiscard]] PoseMessage pose_message(const msg::HumanMessage& message);

/// The path of `agent` in an accepted plan; empty otherwise.
[[nodiscard]] std::vector<Eigen::Vector2d> accepted_path(const msg::TeamPlan& plan, const std::string& agent);

[[nodiscard]] msg::TrackedPeople tracked_people(const std::vector<Track>& tracks, const std::string& robot, Time stamp,
                                                const Pose2& map_from_base);

[[nodiscard]] msg::TeammateState teammate_state(const TeammateEstimate& estimate, const std::string& agent,
                                                const std::string& robot);

}  // namespace tandem::tracking
