#include "services/cli/truth.hpp"

#include <algorithm>

#include "services/recorder/core/carmen_log.hpp"

namespace tandem::cli {

std::vector<TimedPose> sorted_by_time(std::vector<TimedPose> poses) {
  std::stable_sort(poses.begin(), poses.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return poses;
}

Truth read_truth(const std::string& file) {
  if (file.empty()) return {};
  const std::string text = carmen::read_log_file(file);
  if (file.find(".relations") != std::string::npos) return {.poses = {}, .relations = parse_relations(text, file)};
  return {.poses = sorted_by_time(parse_trajectory(text, file)), .relations = {}};
}

}  // namespace tandem::cli
