#pragma once

#include <base.h>
#include <localization.h>
#include <perception.h>

#include <optional>
#include <string>

#include "services/localization/core/laser_scan.hpp"
#include "services/localization/core/localizer.hpp"
#include "services/localization/core/odometry_history.hpp"

namespace tandem {

/// None if a number is not finite.
[[nodiscard]] std::optional<OdometrySample> from_message(const msg::Odometry& message);
[[nodiscard]] std::optional<LaserScan> from_message(const msg::LaserScan& message);
[[nodiscard]] std::optional<PoseHint> from_message(const msg::PoseHint& message);

[[nodiscard]] msg::RobotPose to_message(const LocalizationResult& result, const std::string& robot);
/// Says of a scan that no pose is known: lost, and without a hypothesis.
[[nodiscard]] msg::RobotPose no_pose(Time time, const std::string& robot);

}  // namespace tandem
