#include "services/planner/core/srs/reward_ratio.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

double ratio_at(const RewardRatio& ratio, const BoundaryVector& vector) {
  double per_s = ratio.boundary_per_s;
  const double distance = std::abs(vector.distance);
  if (ratio.shape == RatioShape::Exponential) {
    per_s = ratio.far_per_s + (ratio.boundary_per_s - ratio.far_per_s) * std::exp(-distance / ratio.reach_m);
  } else if (ratio.shape == RatioShape::Ramp) {
    per_s = std::lerp(ratio.boundary_per_s, ratio.far_per_s, std::min(1.0, distance / ratio.reach_m));
  }
  if (!ratio.towards_rad) return per_s;
  const Eigen::Vector2d towards{std::cos(*ratio.towards_rad), std::sin(*ratio.towards_rad)};
  return per_s * 0.5 * (1.0 + towards.dot(vector.direction));
}

double peak_of(const RewardRatio& ratio) {
  if (ratio.shape == RatioShape::Constant) return ratio.boundary_per_s;
  return std::abs(ratio.boundary_per_s) >= std::abs(ratio.far_per_s) ? ratio.boundary_per_s : ratio.far_per_s;
}

std::optional<std::string> problem_of(const RewardRatio& ratio) {
  if (!std::isfinite(ratio.boundary_per_s) || !std::isfinite(ratio.far_per_s) ||
      !std::isfinite(ratio.towards_rad.value_or(0.0))) {
    return "its numbers must be finite";
  }
  if (ratio.shape == RatioShape::Constant) return std::nullopt;
  if (!(ratio.reach_m > 0.0) || !std::isfinite(ratio.reach_m)) return "reach_m must be greater than 0";
  if (ratio.boundary_per_s * ratio.far_per_s < 0.0) {
    return "a ratio must not attract at one distance and repel at another; make it two sources";
  }
  return std::nullopt;
}

std::optional<double> strength_per_s(std::string_view word) {
  const auto found = std::ranges::find(kStrengthWords, word, &StrengthWord::word);
  return found == kStrengthWords.end() ? std::nullopt : std::optional{found->per_s};
}

}  // namespace tandem
