#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "services/planner/core/motion/motion_map.hpp"
#include "services/planner/core/srs/reward_source.hpp"

namespace tandem {

/// A source that a person draws on the map, or takes away again.
struct SourceEdit {
  enum class Kind { Remove, Avoid, PassThrough, GoTo, StayBehind };
  Kind kind = Kind::Remove;
  std::string source_id;
  PlanarShape region;                ///< not of Remove, nor of StayBehind
  std::string strength;              ///< a graded word of kStrengthWords; empty: "quite"
  std::vector<std::string> targets;  ///< whom it concerns; empty: all
  std::string who{};                 ///< draws it; of StayBehind, behind whom
};

/// Why nothing can be made of the edit by a team of `agents`, for people; none if something can.
[[nodiscard]] std::optional<std::string> problem_of(const SourceEdit& edit, std::span<const std::string> agents);

/// The edit as a reward source: a place to go to or to pass through pays once, one to avoid costs for as long as one is
/// in it, and so does what lies ahead of somebody to stay behind.
[[nodiscard]] RewardSource drawn_source(const SourceEdit& edit);

/// Discs that cover a shape of finite size and reach no further out of it than half a metre, or a thirtieth of a large
/// shape's radius.
[[nodiscard]] std::vector<BlockedDisc> covering_discs(const PlanarShape& shape);

}  // namespace tandem
