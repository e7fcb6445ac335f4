#include "services/planner/core/team/tandem_planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "services/planner/core/baselines/lawnmower_planner.hpp"
#include "services/planner/core/team/lower_bound.hpp"

namespace tandem {
namespace {

constexpr int kSeedChoices = 1;
constexpr int kTreeOften = 2;           ///< rollouts; with few lookouts a tree is searched through
constexpr int kTreeSeldom = 100;        ///< lookouts squared for each rollout between two of the tree
constexpr std::size_t kMowable = 5000;  ///< search cells; mowing a larger area takes longer than a first plan may
constexpr double kSamePlace_m = 1e-3;
constexpr double kSameTime_s = 1e-2;
constexpr std::size_t kMostPassed = 4;  ///< lookouts that a leg may pass

using PlaceKey = std::pair<long, long>;

PlaceKey key_of(const Eigen::Vector2d& point_in_map) {
  return {std::lround(point_in_map.x() / kSamePlace_m), std::lround(point_in_map.y() / kSamePlace_m)};
}

/// A place on the way of a plan.
struct Stop {
  int place;
  double arrival_s;
  double heading_rad;  ///< on arrival
};

/// A way from lookout to lookout may have a corner at another one, from which its own leg onward takes another way.
/// Drops the last stops if the plan's time of arrival at `next` is that of a leg from one before them.
void drop_passed(LegBook& book, int next, double arrival_s, std::vector<Stop>& stops) {
  for (std::size_t count = stops.size(); count > 0 && count + kMostPassed >= stops.size(); --count) {
    const Stop& from = stops[count - 1];
    if (from.place < 0 || !book.actions().is_near(from.place, next)) continue;
    const CompactLeg& leg = book.leg(from.place, next);
    const double turn_s = turning_time_s(book.actions().searcher(), from.heading_rad, leg.initial_heading_rad);
    if (!leg.possible || std::abs(from.arrival_s + turn_s + leg.duration_s - arrival_s) > kSameTime_s) continue;
    stops.erase(stops.begin() + static_cast<std::ptrdiff_t>(count), stops.end());
    return;
  }
}

}  // namespace

void TandemPlanner::begin(const SearchProblem& problem, Rng rng) {
  assert(!problem.members.empty() && !problem.masses.empty());
  rng_ = rng;
  rollouts_ = 0;
  bound_s_.reset();
  tree_every_ = options_.tree_every;
  refinement_.reset();
  tree_.reset();
  value_.reset();
  problem_ = std::make_unique<PreparedProblem>(problem);
  ground_ = team_ground(*problem_);
  value_.emplace(ground_);
  tree_.emplace(ground_, *value_, options_.tree, options_.walk);
  refinement_.emplace(ground_, *value_, options_.refinement);
  int lookouts = 0;
  for (const PreparedProblem::Member& who : problem_->members()) lookouts = std::max(lookouts, who.actions->lookouts());
  tree_every_ = std::min(tree_every_, std::max(kTreeOften, lookouts * lookouts / kTreeSeldom));
  best_ = Routes(problem.members.size());
  best_s_ = value_->value_s(best_);
  incumbent_ = best_;
  incumbent_s_ = value_->exact_s(best_);
  take_seed(greedy(options_.walk.exponent, false));
  if (options_.seeds) {
    take_seed(greedy(1.0, false));
    if (problem.members.size() > 1) take_seed(greedy(options_.walk.exponent, true));
    if (ground_.mass.size() <= kMowable) take_seed(lawnmower_routes(*problem_));
  }
  if (options_.warm_start && problem.current.size() == problem.members.size()) take_seed(running_plan());
  refinement_->restart(best_, best_s_);
}

void TandemPlanner::take_seed(Routes routes) {
  for (std::size_t m = 0; m < routes.size(); ++m) {
    const PreparedProblem::Member& who = problem_->members()[m];
    if (who.start >= 0) routes[m] = who.actions->joined(who.start, routes[m]);
  }
  const double value_s = value_->value_s(routes);
  tree_->remember(routes, value_s);
  if (const double exact_s = value_->exact_s(routes); exact_s < incumbent_s_) {
    incumbent_ = routes;
    incumbent_s_ = exact_s;
  }
  if (value_s < best_s_) {
    best_ = routes;
    best_s_ = value_s;
  }
}

Routes TandemPlanner::greedy(double exponent, bool one_after_the_other) const {
  WalkOptions options = options_.walk;
  options.exponent = exponent;
  JointWalk walk(ground_, options);
  const auto finish = [&](int only) {
    for (int m = walk.next_member(only); m >= 0; m = walk.next_member(only)) {
      walk.choose(m, walk.choices(m, kSeedChoices).front().place);
    }
  };
  if (one_after_the_other) {
    for (int m = 0; m < static_cast<int>(ground_.books.size()); ++m) finish(m);
  } else {
    finish(-1);
  }
  return walk.routes();
}

Routes TandemPlanner::running_plan() const {
  Routes routes;
  for (std::size_t m = 0; m < ground_.books.size(); ++m) {
    const ActionSet& actions = ground_.books[m]->actions();
    std::map<PlaceKey, int> lookouts;
    for (int place = 0; place < actions.lookouts(); ++place) lookouts.emplace(key_of(actions.place(place)), place);
    const PreparedProblem::Member& who = problem_->members()[m];
    std::vector<Stop> stops{{who.start, who.start_s, who.heading_rad}};
    const std::vector<TimedPoint>& points = problem_->problem().current[m].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto lookout = lookouts.find(key_of(points[i].point_in_map));
      if (points[i].time_s < who.start_s || lookout == lookouts.end() || lookout->second == stops.back().place)
        continue;
      drop_passed(*ground_.books[m], lookout->second, points[i].time_s, stops);
      const double heading_rad = heading_towards(points[i - 1].point_in_map, points[i].point_in_map);
      stops.push_back({lookout->second, points[i].time_s, heading_rad});
    }
    std::vector<int>& route = routes.emplace_back();
    for (std::size_t i = 1; i < stops.size(); ++i) route.push_back(stops[i].place);
    if (who.goal) route.insert(route.begin(), *who.goal);
  }
  return routes;
}

void TandemPlanner::run(int rollouts, const std::function<bool()>& stop) {
  for (int i = 0; i < rollouts && !(stop && stop()); ++i, ++rollouts_) {
    if (tree_every_ > 0 && rollouts_ % tree_every_ == 0) {
      const double value_s = tree_->rollout(rng_);
      if (value_s < best_s_) {
        best_ = tree_->routes();
        best_s_ = value_s;
        refinement_->restart(best_, best_s_);
      }
    }
    if (tree_every_ > 0 && refinement_->is_stuck()) {
      const double value_s = tree_->rollout(rng_);
      refinement_->restart(tree_->routes(), value_s);
    }
    if (options_.moves == 0 || !refinement_->improve(options_.moves, rng_) || refinement_->best_s() >= best_s_)
      continue;
    best_ = refinement_->best();
    best_s_ = refinement_->best_s();
    if (tree_every_ > 0) tree_->remember(best_, best_s_);
  }
}

JointPlan TandemPlanner::best() {
  if (const double exact_s = value_->exact_s(best_); exact_s < incumbent_s_) {
    incumbent_ = best_;
    incumbent_s_ = exact_s;
  }
  return problem_->plan(incumbent_);
}

double TandemPlanner::lower_bound_s() {
  if (!bound_s_) bound_s_ = tandem::lower_bound_s(*problem_);
  return *bound_s_;
}

}  // namespace tandem
