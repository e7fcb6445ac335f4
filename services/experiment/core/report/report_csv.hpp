#pragma once

#include <span>
#include <string>

#include "services/experiment/core/report/report.hpp"

/// The tables of a report, each with a head line.
namespace tandem::experiment {

/// One row per episode: name, code, fields, outcome, every measure.
[[nodiscard]] std::string episodes_csv(std::span<const EpisodeLog> episodes, const Report& report);
/// One row per group and moment: episodes that go on, explored by the robot and in all, episodes in each role.
[[nodiscard]] std::string progress_csv(const Report& report);
/// One row per group and beginning: Table 1.
[[nodiscard]] std::string my_pose_csv(const Report& report);
/// One row per measure or question and pair of groups.
[[nodiscard]] std::string comparisons_csv(const Report& report);

}  // namespace tandem::experiment
