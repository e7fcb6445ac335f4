#include "services/planner/core/baselines/sequential_planner.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tandem {

void SequentialPlanner::begin(const SearchProblem& problem, Rng rng) {
  rng_ = rng;
  rollouts_ = 0;
  problem_ = std::make_unique<PreparedProblem>(problem);
  objective_.emplace(problem.masses, problem.horizon_s, problem.tail_s);
  order_.resize(problem_->members().size());
  std::iota(order_.begin(), order_.end(), 0);
  if (options_.only_fastest) {
    const auto reach_m = [&](int m) {
      const PreparedProblem::Member& who = problem_->members()[static_cast<std::size_t>(m)];
      return who.actions->searcher().speed_mps * (who.end_s - who.start_s);
    };
    order_ = {*std::ranges::max_element(order_, {}, reach_m)};
  }
  best_.assign(problem_->members().size(), {});
  best_s_ = std::numeric_limits<double>::infinity();
  // The first plan: each in turn by greedy alone.
  search_.reset();
  tries_ = 0;
  turn_ = 0;
  do {
    plan_next_member();
  } while (turn_ < order_.size());
  end_round();
}

void SequentialPlanner::plan_next_member() {
  const int member = order_[turn_++];
  Routes routes = search_ ? search_->routes() : Routes(problem_->members().size());
  RouteSearchOptions greedy = options_.search;
  greedy.spread = 0.0;
  TeamWalk walk(*problem_, greedy.most_options);
  walk_among(walk, routes, member, [&] { return greedy_at_random(walk.options(member), greedy, rng_); });
  routes[static_cast<std::size_t>(member)] = walk.routes()[static_cast<std::size_t>(member)];
  search_.emplace(*problem_, *objective_, options_.search, std::move(routes), member);
  tries_left_ = tries_;
}

void SequentialPlanner::end_round() {
  if (search_->expected_time_s() < best_s_) {
    best_s_ = search_->expected_time_s();
    best_ = search_->routes();
  }
  search_.reset();
  turn_ = 0;
  tries_ = std::max(options_.tries_at_first, 2 * tries_);
}

void SequentialPlanner::run(int rollouts, const std::function<bool()>& stop) {
  for (int i = 0; i < rollouts && !(stop && stop()); ++i, ++rollouts_) {
    if (!search_) plan_next_member();
    search_->improve(rng_);
    if (--tries_left_ > 0) continue;
    turn_ < order_.size() ? plan_next_member() : end_round();
  }
}

}  // namespace tandem
