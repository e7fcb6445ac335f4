#include "services/planner/core/inform/own_way.hpp"

#include <cassert>
#include <cmath>

#include "services/mapping/core/ray_casting.hpp"
#include "services/planner/core/baselines/greedy_planner.hpp"

namespace tandem {
namespace {

constexpr double kExponent = 1.0;  ///< gain for the time, as somebody in a hurry would have it
constexpr int kMostOptions = 40;
constexpr double kStep_s = 0.1;

}  // namespace

double time_of_own_way_s(const SearchProblem& problem, const std::vector<double>& believed) {
  assert(problem.members.size() == 1 && problem.masses.size() == 1);
  SearchProblem as_believed = problem;
  as_believed.masses = {believed};
  const PreparedProblem prepared(as_believed);
  const Routes routes = greedy_routes(prepared, kExponent, kMostOptions);
  return evaluated(problem, {prepared.path(0, routes[0])}).forecast.expected_time_s;
}

double gain_of_knowing_s(const SearchProblem& problem, const std::vector<double>& believed) {
  return time_of_own_way_s(problem, believed) - time_of_own_way_s(problem, problem.masses.front());
}

double time_walked_into_s(const OccupancyGrid& map, const PlanarShape& place, const Eigen::Vector2d& from_in_map,
                          const Eigen::Vector2d& course, double speed_mps, double ahead_s) {
  const double heading_rad = std::atan2(course.y(), course.x());
  const double longest_m = speed_mps * ahead_s;
  const double free_m = range_to_obstacle_m(map, from_in_map, heading_rad, longest_m).value_or(longest_m);
  double inside_s = 0.0;
  for (double time_s = 0.5 * kStep_s; time_s * speed_mps < free_m; time_s += kStep_s) {
    if (contains(place, from_in_map + time_s * speed_mps * course)) inside_s += kStep_s;
  }
  return inside_s;
}

}  // namespace tandem
