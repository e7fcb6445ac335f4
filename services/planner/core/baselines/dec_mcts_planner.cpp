#include "services/planner/core/baselines/dec_mcts_planner.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "services/planner/core/baselines/greedy_planner.hpp"

namespace tandem {

void DecMctsPlanner::begin(const SearchProblem& problem, Rng rng) {
  rng_ = rng;
  rollouts_ = 0;
  messages_ = 0;
  temperature_ = options_.temperature;
  problem_ = std::make_unique<PreparedProblem>(problem);
  objective_.emplace(problem.masses, problem.horizon_s, problem.tail_s);
  best_s_ = std::numeric_limits<double>::infinity();
  robots_.clear();
  Routes routes(problem_->members().size());
  for (std::size_t m = 0; m < routes.size(); ++m) {
    routes[m] =
        greedy_routes(*problem_, options_.rollout.exponent, options_.rollout.most_options, static_cast<int>(m))[m];
    robots_.push_back({RouteTree(options_.tree), uniform_distribution({routes[m]})});
  }
  (void)expected_time_s(routes);
}

double DecMctsPlanner::expected_time_s(const Routes& routes) {
  looks_ = problem_->fixed_looks();
  for (std::size_t m = 0; m < routes.size(); ++m) problem_->add_looks(m, routes[m], looks_);
  const double value_s = objective_->forecast(looks_).expected_time_s;
  if (value_s < best_s_) {
    best_s_ = value_s;
    best_ = routes;
  }
  return value_s;
}

Routes DecMctsPlanner::drawn_routes(std::size_t robot) {
  Routes routes(robots_.size());
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot) continue;
    const RouteDistribution& intention = robots_[other].intention;
    routes[other] = intention.routes[intention.drawn(rng_)];
  }
  return routes;
}

void DecMctsPlanner::grow(std::size_t robot) {
  const int member = static_cast<int>(robot);
  Routes routes = drawn_routes(robot);
  const double without_s = expected_time_s(routes);
  const auto successors = [&](const std::vector<int>& route) {
    TeamWalk walk(*problem_, options_.successors);
    for (const int place : route) walk.go(member, place);
    for (std::size_t other = 0; other < routes.size(); ++other) {
      if (other != robot) walk.stay(static_cast<int>(other));
    }
    std::vector<int> places;
    if (walk.next_member() == member) {
      for (const WalkOption& option : walk.options(member)) {
        if (option.time_s > 0.0) places.push_back(option.place);
      }
    }
    return places;
  };
  const auto simulate = [&](std::vector<int>& route) {
    TeamWalk walk(*problem_, options_.rollout.most_options);
    std::size_t done = 0;
    walk_among(walk, routes, member, [&] {
      return done < route.size() ? route[done++] : greedy_at_random(walk.options(member), options_.rollout, rng_);
    });
    route = walk.routes()[robot];
    routes[robot] = route;
    const double saved_s = without_s - expected_time_s(routes);
    robots_[robot].scale_s = std::max(robots_[robot].scale_s, saved_s);
    return std::max(0.0, saved_s / robots_[robot].scale_s);
  };
  robots_[robot].tree.grow(successors, simulate, rng_);
}

void DecMctsPlanner::send_messages() {
  ++messages_;
  std::vector<RouteDistribution> next;
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    RouteDistribution intention = robots_[robot].intention;
    if (messages_ % options_.messages_per_choice == 1 || options_.messages_per_choice == 1) {
      auto routes = robots_[robot].tree.best_routes(static_cast<std::size_t>(options_.intentions));
      if (!routes.empty()) intention = uniform_distribution(std::move(routes));
    }
    std::vector<double> rewards(intention.routes.size(), 0.0);
    for (int sample = 0; sample < options_.samples; ++sample) {
      Routes routes = drawn_routes(robot);
      const double without_s = expected_time_s(routes);
      for (std::size_t i = 0; i < rewards.size(); ++i) {
        routes[robot] = intention.routes[i];
        rewards[i] += (without_s - expected_time_s(routes)) / (options_.samples * robots_[robot].scale_s);
      }
    }
    descend(intention, rewards, options_.step, temperature_);
    next.push_back(std::move(intention));
  }
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) robots_[robot].intention = std::move(next[robot]);
  temperature_ *= options_.cooling;
  Routes likeliest;
  for (const Robot& robot : robots_) likeliest.push_back(robot.intention.routes[robot.intention.likeliest()]);
  (void)expected_time_s(likeliest);
}

void DecMctsPlanner::run(int rollouts, const std::function<bool()>& stop) {
  const int between_messages = options_.growths * static_cast<int>(robots_.size());
  for (int i = 0; i < rollouts && !(stop && stop()); ++i) {
    grow(static_cast<std::size_t>(rollouts_ % static_cast<int>(robots_.size())));
    ++rollouts_;
    if (rollouts_ % between_messages == 0) send_messages();
  }
}

}  // namespace tandem
