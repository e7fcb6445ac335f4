#include "services/planner/core/scenario/scenario_search.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "services/planner/core/srs/planar_shape.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

/// Per square metre, not normalised.
double density_at(const ScenarioSearch& search, const Vector2d& first_start, const Vector2d& point) {
  if ((point - first_start).norm() < search.excluded_radius_m) return 0.0;
  double density = search.peaks.empty() ? 1.0 : 0.0;
  for (const PriorPeak& peak : search.peaks) {
    const double off = (point - peak.centre_in_map).norm() / peak.deviation_m;
    density +=
        peak.weight * std::exp(-0.5 * off * off) / (2.0 * std::numbers::pi * peak.deviation_m * peak.deviation_m);
  }
  for (const PriorArea& area : search.areas) {
    if (contains(PlanarShape{Polygon{area.corners_in_map}}, point)) density *= area.weight;
  }
  return density;
}

}  // namespace

std::vector<double> prior_of(const ScenarioSearch& search, const Vector2d& first_start_in_map,
                             const std::vector<Vector2d>& points_in_map, const std::vector<double>& floor_m2) {
  assert(points_in_map.size() == floor_m2.size());
  std::vector<double> masses;
  for (std::size_t i = 0; i < points_in_map.size(); ++i) {
    masses.push_back(floor_m2[i] * density_at(search, first_start_in_map, points_in_map[i]));
  }
  double sum = std::accumulate(masses.begin(), masses.end(), 0.0);
  if (sum <= 0.0) {
    masses = floor_m2;
    sum = std::accumulate(masses.begin(), masses.end(), 0.0);
  }
  for (double& mass : masses) mass /= sum;
  return masses;
}

}  // namespace tandem
