#include "services/planner/core/baselines/greedy_planner.hpp"

#include <cmath>

namespace tandem {

int greediest(const std::vector<WalkOption>& options, double exponent) {
  int best = -1;
  double best_score = -1.0;
  for (const WalkOption& option : options) {
    const double score = option.time_s > 0.0 ? option.gain / std::pow(option.time_s, exponent) : 0.0;
    if (score <= best_score) continue;
    best_score = score;
    best = option.place;
  }
  return best;
}

Routes greedy_routes(const PreparedProblem& problem, double exponent, int most_options, int only) {
  TeamWalk walk(problem, most_options);
  for (int member = walk.next_member(); member >= 0; member = walk.next_member()) {
    const int place = only < 0 || member == only ? greediest(walk.options(member), exponent) : -1;
    place < 0 ? walk.stay(member) : walk.go(member, place);
  }
  return walk.routes();
}

Routes GreedyPlanner::routes(const PreparedProblem& problem) const {
  if (options_.mates == Mates::Coordinated) return greedy_routes(problem, options_.exponent, options_.most_options);
  Routes routes(problem.members().size());
  for (std::size_t m = 0; m < routes.size(); ++m) {
    routes[m] = greedy_routes(problem, options_.exponent, options_.most_options, static_cast<int>(m))[m];
  }
  return routes;
}

}  // namespace tandem
