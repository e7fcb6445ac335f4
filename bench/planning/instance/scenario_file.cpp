#include "bench/planning/instance/scenario_file.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace tandem::bench {
namespace {

using nlohmann::ordered_json;

constexpr double kGreatestRate_per_s = 1000.0;

/// So that files stay readable.
double rounded(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

ordered_json point(const Eigen::Vector2d& p) {
  return ordered_json::array({rounded(p.x()), rounded(p.y())});
}

ordered_json agent_json(const Searcher& searcher, const Pose2& start, double altitude_m) {
  const std::string kind = searcher.id.substr(0, searcher.id.find_first_of("0123456789"));
  ordered_json agent{{"id", searcher.id},
                     {"kind", kind},
                     {"start", {rounded(start.x), rounded(start.y), rounded(start.heading)}},
                     {"speed_mps", searcher.speed_mps},
                     {"radius_m", searcher.radius_m},
                     {"preferred_clearance_m", searcher.preferred_clearance_m},
                     {"view_min_m", searcher.view_min_m},
                     {"view_max_m", searcher.view_max_m},
                     {"field_of_view_deg", rounded(searcher.field_of_view_rad * 180.0 / std::numbers::pi)},
                     {"detection_rate_per_s", std::min(searcher.detection_rate_per_s, kGreatestRate_per_s)}};
  if (searcher.layer > 0) agent["altitude_m"] = altitude_m;
  if (std::isfinite(searcher.endurance_s)) agent["battery_s"] = searcher.endurance_s;
  return agent;
}

/// Where there are hills, the even part is one so wide that it is flat on the map.
ordered_json prior_json(const PlanningInstance& instance) {
  ordered_json prior{{"excluded_radius_m", instance.prior.excluded_radius_m}};
  if (instance.prior.gaussians.empty()) return prior;
  ordered_json hills = ordered_json::array();
  for (const Gaussian& hill : instance.prior.gaussians) {
    hills.push_back({rounded(hill.centre_in_map.x()), rounded(hill.centre_in_map.y()), rounded(hill.sigma_m),
                     rounded(hill.weight)});
  }
  const double sigma_m = 20.0 * std::max(instance.plan.width_m, instance.plan.height_m);
  const double density = instance.prior.uniform_weight / (instance.plan.width_m * instance.plan.height_m);
  hills.push_back({0.5 * instance.plan.width_m, 0.5 * instance.plan.height_m, sigma_m,
                   rounded(density * 2.0 * std::numbers::pi * sigma_m * sigma_m)});
  prior["gaussians"] = hills;
  return prior;
}

}  // namespace

std::string scenario_json(const PlanningInstance& instance) {
  ordered_json boxes = ordered_json::array();
  for (const Box& box : instance.plan.boxes) {
    ordered_json one{{"min", point(box.low_in_map)}, {"max", point(box.high_in_map)}};
    if (std::isfinite(box.height_m)) one["height_m"] = box.height_m;
    boxes.push_back(one);
  }
  ordered_json agents = ordered_json::array();
  for (std::size_t m = 0; m < instance.searchers.size(); ++m) {
    agents.push_back(agent_json(instance.searchers[m], instance.starts[m], instance.drone_altitude_m));
  }
  const ordered_json scenario{
      {"name", instance.family + " " + std::to_string(instance.seed)},
      {"description", "Instance " + std::to_string(instance.seed) + " of family " + instance.family +
                          " of the planning benchmark, written by tandem-bench-planning freeze."},
      {"room",
       {{"width_m", instance.plan.width_m},
        {"height_m", instance.plan.height_m},
        {"resolution_m", instance.plan.resolution_m},
        {"boxes", boxes}}},
      {"agents", agents},
      {"search", {{"cell_size_m", instance.area.cell_size_m}, {"prior", prior_json(instance)}}},
      {"horizon_s", instance.horizon_s}};
  return scenario.dump(1) + "\n";
}

}  // namespace tandem::bench
