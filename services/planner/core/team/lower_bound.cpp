#include "services/planner/core/team/lower_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace tandem {
namespace {

constexpr int kSteps = 200;

/// A member as a growing strip.
struct Sweep {
  Eigen::Vector2d start;
  double start_s;
  double end_s;
  double speed_mps;
  double view_m;
};

std::vector<Sweep> sweeps_of(const PreparedProblem& problem) {
  const double slack_m = std::numbers::sqrt2 * problem.problem().world->area().cell_size_m();
  std::vector<Sweep> sweeps;
  for (const PreparedProblem::Member& member : problem.members()) {
    if (member.start < 0) continue;
    const Searcher& searcher = member.actions->searcher();
    sweeps.push_back({member.actions->place(member.start), member.start_s, member.end_s, searcher.speed_mps,
                      searcher.view_max_m + slack_m});
  }
  return sweeps;
}

double swept_m2(const std::vector<Sweep>& sweeps, double time_s) {
  double area_m2 = 0.0;
  for (const Sweep& sweep : sweeps) {
    const double walked_s = std::min(time_s, sweep.end_s) - sweep.start_s;
    if (walked_s < 0.0) continue;
    area_m2 += std::numbers::pi * sweep.view_m * sweep.view_m + 2.0 * sweep.view_m * sweep.speed_mps * walked_s;
  }
  return area_m2;
}

/// A cell that can be found: when at the earliest, what it holds, how large it is.
struct Prospect {
  double in_reach_s;
  double mass;
  double floor_m2;
};

double bound_of_object_s(const PreparedProblem& problem, const std::vector<Sweep>& sweeps,
                         const std::vector<double>& anyway_s, const std::vector<double>& mass) {
  const SearchProblem& search = problem.problem();
  const SearchArea& area = search.world->area();
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  if (total <= 0.0) return 0.0;
  std::vector<Prospect> prospects;
  std::vector<Prospect> anyway;
  for (int cell = 0; cell < area.size(); ++cell) {
    const auto i = static_cast<std::size_t>(cell);
    if (mass[i] <= 0.0) continue;
    double in_reach_s = std::numeric_limits<double>::infinity();
    for (const Sweep& sweep : sweeps) {
      const double way_m = std::max(0.0, (area.point(cell) - sweep.start).norm() - sweep.view_m);
      in_reach_s = std::min(in_reach_s, sweep.start_s + way_m / sweep.speed_mps);
    }
    prospects.push_back({in_reach_s, mass[i] / total, area.floor_m2(cell)});
    if (std::isfinite(anyway_s[i])) anyway.push_back({anyway_s[i], mass[i] / total, 0.0});
  }
  std::ranges::sort(prospects, std::greater<>{}, [](const Prospect& p) { return p.mass / p.floor_m2; });
  const double step_s = search.horizon_s / kSteps;
  double integral_s = 0.0;
  double left = 1.0;
  for (int step = 1; step <= kSteps; ++step) {
    const double time_s = step * step_s;  // what is found grows, so its end stands for the whole step
    double room_m2 = swept_m2(sweeps, time_s);
    double found = 0.0;
    for (const Prospect& prospect : prospects) {
      if (room_m2 <= 0.0) break;
      if (prospect.in_reach_s > time_s) continue;
      found += prospect.mass * std::min(1.0, room_m2 / prospect.floor_m2);
      room_m2 -= prospect.floor_m2;
    }
    for (const Prospect& prospect : anyway) found += prospect.in_reach_s <= time_s ? prospect.mass : 0.0;
    left = std::max(0.0, 1.0 - found);
    integral_s += left * step_s;
  }
  return integral_s + left * search.tail_s;
}

}  // namespace

double lower_bound_s(const PreparedProblem& problem) {
  const SearchProblem& search = problem.problem();
  if (std::ranges::any_of(search.members, [](const SearchMember& member) { return !member.hypotheses.empty(); })) {
    return 0.0;
  }
  std::vector<double> anyway_s(search.masses.front().size(), std::numeric_limits<double>::infinity());
  for (const Look& look : problem.fixed_looks()) {
    for (std::size_t i = 0; i < look.seen->size(); ++i) {
      double& earliest_s = anyway_s[static_cast<std::size_t>(look.seen->cells[i])];
      earliest_s = std::min(earliest_s, look.start_s + look.seen->enter_s[i]);
    }
  }
  const std::vector<Sweep> sweeps = sweeps_of(problem);
  double bound_s = 0.0;
  for (const auto& mass : search.masses) {
    bound_s = std::max(bound_s, bound_of_object_s(problem, sweeps, anyway_s, mass));
  }
  return bound_s;
}

}  // namespace tandem
