#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "services/planner/core/srs/planar_shape.hpp"

namespace tandem {

/// How a ratio changes with the distance to the boundary.
enum class RatioShape {
  Constant,     ///< the same everywhere
  Exponential,  ///< from the value on the boundary towards the far one; after `reach_m` 1/e of the difference is left
  Ramp,         ///< straight from the value on the boundary to the far one, which it has from `reach_m` on
};

/// A reward ratio as a function of the boundary vector, equation (1): the inner or the outer one of a source.
///
/// Of one sign everywhere, or zero. In the space of speeds, distances are [m/s].
struct RewardRatio {
  RatioShape shape = RatioShape::Constant;
  double boundary_per_s =
      0.0;                 ///< Reward for a second on the boundary [1/s]; negative repels. Everywhere, if constant.
  double far_per_s = 0.0;  ///< far from the boundary [1/s]; not used if constant
  double reach_m = 1.0;    ///< > 0; not used if constant
  /// Full in this direction from the boundary, nothing in the opposite one, as a cosine between [rad, in the frame of
  /// the boundary]; none: equal in all directions.
  std::optional<double> towards_rad;

  bool operator==(const RewardRatio&) const = default;
};

/// The same reward ratio everywhere [1/s].
[[nodiscard]] inline RewardRatio constant_ratio(double per_s) {
  RewardRatio ratio;
  ratio.boundary_per_s = per_s;
  return ratio;
}

/// The reward of a second at a boundary vector [1/s].
[[nodiscard]] double ratio_at(const RewardRatio& ratio, const BoundaryVector& vector);

/// The value of the largest magnitude that the ratio has anywhere [1/s]; its sign is the sign of the ratio.
[[nodiscard]] double peak_of(const RewardRatio& ratio);

[[nodiscard]] inline bool is_constant(const RewardRatio& ratio) {
  return ratio.shape == RatioShape::Constant && !ratio.towards_rad;
}

/// What is wrong with the ratio, for people; none if nothing is.
[[nodiscard]] std::optional<std::string> problem_of(const RewardRatio& ratio);

/// A graded word of a person about how much a source matters, and the ratio it stands for [1/s].
struct StrengthWord {
  std::string_view word;
  double per_s;
};

/// The one table of graded words: each is three times the one before.
inline constexpr std::array<StrengthWord, 3> kStrengthWords{{{"a bit", 1.0 / 3.0}, {"quite", 1.0}, {"very", 3.0}}};

/// The ratio a word stands for [1/s]; none if it is not in the table.
[[nodiscard]] std::optional<double> strength_per_s(std::string_view word);

}  // namespace tandem
