#pragma once

#include <string>

#include "idl/topics.hpp"
#include "robot/pioneer/core/odometry.hpp"
#include "robot/pioneer/core/robot_parameters.hpp"
#include "robot/pioneer/core/sip.hpp"
#include "robot/safety/core/safety_gate.hpp"

namespace tandem {

[[nodiscard]] msg::Odometry to_message(const pioneer::OdometryState& state, const std::string& robot, Time stamp);
[[nodiscard]] msg::SonarRanges sonar_message(const pioneer::Sip& sip, const pioneer::RobotParameters& parameters,
                                             const std::string& robot, Time stamp);
/// What goes into a base_status besides the gate's decision.
struct BaseStatusParts {
  safety::BaseInput base;
  safety::GateDecision decision;
  std::string model;
};
[[nodiscard]] msg::BaseStatus to_message(const BaseStatusParts& parts, const std::string& robot, Time stamp);

/// `message`, sent by `commander`; "teleop" is an operator at the robot.
[[nodiscard]] safety::CommandSample from_message(const msg::VelocityCommand& message,
                                                 const safety::CommanderId& commander);
/// A view into `message`, which must outlive it.
[[nodiscard]] safety::ScanView view_of(const msg::LaserScan& message);
[[nodiscard]] Pose2 from_message(const msg::Pose& pose);

}  // namespace tandem
