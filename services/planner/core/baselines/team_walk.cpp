#include "services/planner/core/baselines/team_walk.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace tandem {
namespace {

constexpr double kDetourFactor = 1.5;
constexpr double kDetour_m = 4.0;
constexpr double kNothing = 1e-12;  ///< share of all mass

/// By a look at `seen` until `until_s` of it.
double detected(const Sightings& seen, std::size_t i, double rate_per_s, double until_s) {
  if (seen.enter_s[i] >= until_s) return 0.0;
  return std::isinf(rate_per_s) ? 1.0
                                : -std::expm1(-rate_per_s * (std::min(seen.leave_s[i], until_s) - seen.enter_s[i]));
}

}  // namespace

TeamWalk::TeamWalk(const PreparedProblem& problem, int most_options)
    : problem_(&problem),
      most_options_(most_options),
      mass_(problem.problem().masses.front().size(), 0.0),
      routes_(problem.members().size()) {
  for (const auto& of_object : problem.problem().masses) {
    std::ranges::transform(mass_, of_object, mass_.begin(), std::plus{});
  }
  nothing_ = kNothing * std::accumulate(mass_.begin(), mass_.end(), 0.0);
  for (const Look& look : problem.fixed_looks()) take_in(*look.seen, look.rate_per_s, look.until_s);
  for (const auto& member : problem.members()) {
    Progress progress{member.start, member.start_s, member.heading_rad};
    if (member.goal && member.actions->leg(member.start, *member.goal).possible()) {
      progress.goal_ahead = true;
      progress.detour_left_m = kDetourFactor * member.actions->distance_m(member.start, *member.goal) + kDetour_m;
    }
    progress_.push_back(progress);
  }
}

int TeamWalk::next_member() const {
  int next = -1;
  for (std::size_t m = 0; m < progress_.size(); ++m) {
    if (progress_[m].busy_until_s >= problem_->members()[m].end_s) continue;
    if (next < 0 || progress_[m].busy_until_s < progress_[static_cast<std::size_t>(next)].busy_until_s) {
      next = static_cast<int>(m);
    }
  }
  return next;
}

double TeamWalk::mass_around(int member, int lookout) const {
  double mass = 0.0;
  for (const int cell : member_at(member).actions->panorama(lookout)) mass += mass_[static_cast<std::size_t>(cell)];
  return mass;
}

WalkOption TeamWalk::option(int member, int place) const {
  ActionSet& actions = *member_at(member).actions;
  const Progress& progress = progress_[static_cast<std::size_t>(member)];
  const Leg& leg = actions.leg(progress.place, place);
  WalkOption option{place, 0.0, 0.0};
  if (!leg.possible()) return option;
  const double turn_s = turning_time_s(actions.searcher(), progress.heading_rad, leg.initial_heading_rad);
  const double until_s = member_at(member).end_s - progress.busy_until_s - turn_s;
  const double rate_per_s = actions.searcher().detection_rate_per_s;
  for (std::size_t i = 0; i < leg.seen.size(); ++i) {
    option.gain += mass_[static_cast<std::size_t>(leg.seen.cells[i])] * detected(leg.seen, i, rate_per_s, until_s);
  }
  option.time_s = leg.duration_s + turn_s;
  return option;
}

std::vector<WalkOption> TeamWalk::options(int member) const {
  const PreparedProblem::Member& who = member_at(member);
  const Progress& progress = progress_[static_cast<std::size_t>(member)];
  std::vector<std::pair<double, int>> near;
  for (int lookout = 0; lookout < who.actions->lookouts(); ++lookout) {
    if (lookout == progress.place || !who.actions->is_connected(progress.place, lookout)) continue;
    const double distance_m = who.actions->distance_m(progress.place, lookout);
    if (progress.goal_ahead && distance_m + who.actions->distance_m(*who.goal, lookout) > progress.detour_left_m) {
      continue;
    }
    near.emplace_back(distance_m, lookout);
  }
  std::ranges::sort(near);
  std::vector<WalkOption> options;
  const auto offer = [&](bool shows_new_at_its_end) {
    for (const auto& [distance_m, lookout] : near) {
      if (static_cast<int>(options.size()) >= most_options_) break;
      if (counts(mass_around(member, lookout)) != shows_new_at_its_end) continue;
      const WalkOption offered = option(member, lookout);
      if (counts(offered.gain) && offered.time_s > 0.0) options.push_back(offered);
    }
  };
  offer(true);
  if (options.empty()) offer(false);  // what can be seen from afar only
  if (progress.goal_ahead) options.push_back(option(member, *who.goal));
  return options;
}

void TeamWalk::take_in(const Sightings& seen, double rate_per_s, double until_s) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    mass_[static_cast<std::size_t>(seen.cells[i])] *= 1.0 - detected(seen, i, rate_per_s, until_s);
  }
}

void TeamWalk::go(int member, int place) {
  const PreparedProblem::Member& who = member_at(member);
  Progress& progress = progress_[static_cast<std::size_t>(member)];
  const Leg& leg = who.actions->leg(progress.place, place);
  if (!leg.possible()) {
    stay(member);
    return;
  }
  progress.busy_until_s += turning_time_s(who.actions->searcher(), progress.heading_rad, leg.initial_heading_rad);
  take_in(leg.seen, who.actions->searcher().detection_rate_per_s, who.end_s - progress.busy_until_s);
  progress.busy_until_s += leg.duration_s;
  progress.detour_left_m -= who.actions->distance_m(progress.place, place);
  progress.heading_rad = leg.final_heading_rad;
  progress.place = place;
  routes_[static_cast<std::size_t>(member)].push_back(place);
  if (progress.goal_ahead && place == *who.goal) stay(member);
}

void TeamWalk::stay(int member) {
  progress_[static_cast<std::size_t>(member)].busy_until_s = member_at(member).end_s;
}

}  // namespace tandem
