#include "services/planner/core/tasks/hazards.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "services/planner/core/tasks/task_problem.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kSampling_m = 0.25;
constexpr int kDetourPoints = 12;
constexpr double kOutside_m = 0.05;

bool is_fixed(const ResolvedBoundary& boundary) {
  const auto* shape = std::get_if<PlacedShape>(&boundary);
  return (shape != nullptr && shape->owner < 0) || std::holds_alternative<Sphere>(boundary) ||
         std::holds_alternative<Box>(boundary);
}

/// The disc around everything that the source costs inside its boundary; none if it has no end.
std::optional<Disc> disc_of(const ResolvedBoundary& boundary) {
  if (const auto* shape = std::get_if<PlacedShape>(&boundary)) return enclosing_disc(shape->shape);
  if (const auto* sphere = std::get_if<Sphere>(&boundary)) {
    return Disc{sphere->centre_in_map.head<2>(), sphere->radius_m};
  }
  if (const auto* box = std::get_if<Box>(&boundary)) {
    const Vector2d low = box->low_in_map.head<2>();
    const Vector2d high = box->high_in_map.head<2>();
    return Disc{0.5 * (low + high), 0.5 * (high - low).norm()};
  }
  return std::nullopt;
}

}  // namespace

Hazards::Hazards(const ResolvedWorld& world, std::size_t agent, double altitude_m)
    : world_(&world), agent_(agent), altitude_m_(altitude_m) {
  for (std::size_t s = 0; s < world.sources().size(); ++s) {
    const ResolvedSource& source = world.sources()[s];
    const double peak = std::min(peak_of(source.inside), peak_of(source.outside));
    if ((source.targets & mask_of(agent)) == 0 || peak >= 0.0 || !is_fixed(source.boundary)) continue;
    sources_.push_back(s);
    is_stepwise_ &= std::holds_alternative<PlacedShape>(source.boundary) && is_constant(source.inside) &&
                    is_constant(source.outside);
    peak_per_s_ = std::max(peak_per_s_, -peak * source.pace[agent] * source.worth[agent]);
    const auto disc = disc_of(source.boundary);
    if (!disc) continue;
    const double radius_m = (disc->radius_m + kOutside_m) / std::cos(std::numbers::pi / kDetourPoints);
    for (int i = 0; i < kDetourPoints; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDetourPoints;
      detour_points_.push_back(disc->centre + radius_m * Vector2d{std::cos(angle), std::sin(angle)});
    }
  }
}

double Hazards::cost_per_s(const Vector2d& point_in_map) const {
  if (sources_.empty()) return 0.0;
  std::array<AgentMove, kMaxTaskAgents> moves;
  AgentMove& move = moves[agent_];
  move = stay_at(point_in_map);
  move.from_altitude_m = move.to_altitude_m = altitude_m_;
  const JointMove joint{{moves.data(), world_->agent_count()}, 1.0};
  double cost = 0.0;
  for (const std::size_t s : sources_) cost += std::max(0.0, -rate_of(world_->sources()[s], agent_, joint, 0.0));
  return cost;
}

double Hazards::along(const Vector2d& from, const Vector2d& to) const {
  const double length_m = (to - from).norm();
  if (sources_.empty() || length_m == 0.0) return 0.0;
  const int pieces = is_stepwise_ ? 1 : std::max(1, static_cast<int>(std::ceil(length_m / kSampling_m)));
  std::vector<double> shares;
  for (int i = 0; i <= pieces; ++i) shares.push_back(static_cast<double>(i) / pieces);
  for (const std::size_t s : sources_) {
    if (const auto* placed = std::get_if<PlacedShape>(&world_->sources()[s].boundary)) {
      (void)append_level_crossings(placed->shape, 0.0, from, to, shares);
    }
  }
  std::ranges::sort(shares);
  double sum = 0.0;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double middle = 0.5 * (shares[i - 1] + shares[i]);
    if (shares[i] > shares[i - 1]) sum += (shares[i] - shares[i - 1]) * cost_per_s(from + middle * (to - from));
  }
  return sum * length_m;
}

}  // namespace tandem
