#pragma once

#include <string>
#include <vector>

#include "services/localization/core/trajectory_errors.hpp"

namespace tandem::cli {

/// What poses are compared with: either is empty.
struct Truth {
  std::vector<TimedPose> poses;  ///< by time
  std::vector<Relation> relations;
};

/// Some logs tell times that step back.
[[nodiscard]] std::vector<TimedPose> sorted_by_time(std::vector<TimedPose> poses);

/// Reads `file`, plain or gzip: relations if its name says so (".relations"), else lines of t x y theta. No name, no
/// truth. Throws, naming file and line.
[[nodiscard]] Truth read_truth(const std::string& file);

}  // namespace tandem::cli
