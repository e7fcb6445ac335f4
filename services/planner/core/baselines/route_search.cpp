#include "services/planner/core/baselines/route_search.hpp"

#include <cmath>
#include <utility>

namespace tandem {

int greedy_at_random(const std::vector<WalkOption>& options, const RouteSearchOptions& search, Rng& rng) {
  double best = 0.0;
  std::vector<double> scores;
  for (const WalkOption& option : options) {
    scores.push_back(option.time_s > 0.0 ? option.gain / std::pow(option.time_s, search.exponent) : 0.0);
    best = std::max(best, scores.back());
  }
  std::vector<int> good;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i].time_s > 0.0 && scores[i] >= (1.0 - search.spread) * best) good.push_back(options[i].place);
  }
  return good.empty() ? -1 : good[rng.index(good.size())];
}

RouteSearch::RouteSearch(const PreparedProblem& problem, SearchObjective& objective, const RouteSearchOptions& options,
                         Routes routes, int member)
    : problem_(&problem),
      objective_(&objective),
      options_(options),
      routes_(std::move(routes)),
      member_(member),
      looks_(problem.fixed_looks()) {
  for (std::size_t m = 0; m < routes_.size(); ++m) {
    if (static_cast<int>(m) != member_) problem.add_looks(m, routes_[m], looks_);
  }
  looks_of_others_ = looks_.size();
  expected_time_s_ = expected_time_of(routes_[static_cast<std::size_t>(member_)]);
}

double RouteSearch::expected_time_of(const std::vector<int>& route) {
  looks_.resize(looks_of_others_);
  problem_->add_looks(static_cast<std::size_t>(member_), route, looks_);
  return objective_->forecast(looks_).expected_time_s;
}

void RouteSearch::improve(Rng& rng) {
  const auto m = static_cast<std::size_t>(member_);
  TeamWalk walk(*problem_, options_.most_options);
  const std::size_t kept = rng.index(routes_[m].size() + 1);
  std::size_t done = 0;
  walk_among(walk, routes_, member_,
             [&] { return done < kept ? routes_[m][done++] : greedy_at_random(walk.options(member_), options_, rng); });
  const double value_s = expected_time_of(walk.routes()[m]);
  if (value_s >= expected_time_s_) return;
  expected_time_s_ = value_s;
  routes_[m] = walk.routes()[m];
}

}  // namespace tandem
