#include "services/planner/core/mission/drawn_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kFinest_m = 0.25;         ///< radius of the smallest covering discs ...
constexpr double kFinestPerRadius = 60.0;  ///< ... or that of the shape divided by this

double strength_of(const SourceEdit& edit) {
  return strength_per_s(edit.strength.empty() ? "quite" : edit.strength).value_or(0.0);
}

/// Covers the part of the shape in a square by the disc around it, or by those of its quarters if that one reaches out
/// of the shape and is larger than need be.
void cover(const PlanarShape& shape, const Vector2d& centre, double side_m, double finest_m,
           std::vector<BlockedDisc>& discs) {
  const double radius_m = side_m / std::numbers::sqrt2;
  const double distance_m = signed_distance(shape, centre);
  if (distance_m > radius_m) return;
  if (distance_m <= -radius_m || radius_m <= finest_m) {
    discs.push_back({centre, radius_m});
    return;
  }
  for (const Vector2d& quarter : {Vector2d{-1, -1}, Vector2d{1, -1}, Vector2d{-1, 1}, Vector2d{1, 1}}) {
    cover(shape, centre + 0.25 * side_m * quarter, 0.5 * side_m, finest_m, discs);
  }
}

}  // namespace

std::optional<std::string> problem_of(const SourceEdit& edit, std::span<const std::string> agents) {
  using Kind = SourceEdit::Kind;
  if (edit.source_id.empty()) return "a source needs an id";
  if (edit.kind == Kind::Remove) return std::nullopt;
  if (strength_of(edit) <= 0.0) return "nobody knows how much \"" + edit.strength + "\" is";
  if (edit.kind != Kind::StayBehind && !enclosing_disc(edit.region)) return "the place has no end";
  for (const std::string& target : edit.targets) {
    if (std::ranges::find(agents, target) == agents.end()) return "nobody in the team is called " + target;
  }
  if (edit.kind == Kind::GoTo && edit.targets.size() != 1) return "it is not said who is to go there";
  if (edit.kind == Kind::PassThrough && edit.targets.size() != 1) return "it is not said who is to pass through there";
  if (edit.kind == Kind::StayBehind && std::ranges::find(agents, edit.who) == agents.end()) {
    return "it is not said behind whom";
  }
  if (edit.kind == Kind::StayBehind && std::ranges::find(edit.targets, edit.who) != edit.targets.end()) {
    return "nobody can stay behind themselves";
  }
  return std::nullopt;
}

RewardSource drawn_source(const SourceEdit& edit) {
  using Kind = SourceEdit::Kind;
  const bool pays_once = edit.kind == Kind::GoTo || edit.kind == Kind::PassThrough;
  RewardSource source;
  source.id = edit.source_id;
  source.meaning = edit.kind == Kind::GoTo          ? "somebody is to go here"
                   : edit.kind == Kind::PassThrough ? "somebody is to pass through here"
                   : edit.kind == Kind::StayBehind  ? "stay behind " + edit.who
                                                    : "keep out of here";
  source.boundary = std::visit([](const auto& shape) { return Boundary{shape}; }, edit.region);
  if (edit.kind == Kind::StayBehind) {
    source.kind = SourceKind::Interaction;
    source.boundary = Attached{edit.who, HalfPlane{Eigen::Vector2d::Zero(), -Eigen::Vector2d::UnitX()}};
  }
  source.inside = constant_ratio(pays_once ? strength_of(edit) : -strength_of(edit));
  if (pays_once) source.pool = 1.0;
  source.targets = edit.targets;
  return source;
}

std::vector<BlockedDisc> covering_discs(const PlanarShape& shape) {
  std::vector<BlockedDisc> discs;
  if (const auto around = enclosing_disc(shape)) {
    const double finest_m = std::max(kFinest_m, around->radius_m / kFinestPerRadius);
    cover(shape, around->centre, 2.0 * around->radius_m, finest_m, discs);
  }
  return discs;
}

}  // namespace tandem
