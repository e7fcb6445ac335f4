#include "services/planner/core/team/course.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace tandem {
namespace {

constexpr double kDetourFactor = 1.5;  ///< how much further than straight a member may walk to a fixed goal
constexpr double kDetour_m = 4.0;
constexpr double kWorthwhile = 0.004;  ///< share of the mass left below which the neighbourhood is done
constexpr int kFarLookouts = 4;

/// The chance that an object in the cell of sighting `i` is detected during it.
double detected(const Sightings& seen, std::size_t i, double rate_per_s) {
  return std::isinf(rate_per_s) ? 1.0 : -std::expm1(-rate_per_s * (seen.leave_s[i] - seen.enter_s[i]));
}

bool is_better(const Choice& a, const Choice& b) {
  return a.score != b.score ? a.score > b.score : a.place < b.place;
}

}  // namespace

Course::Course(const PreparedProblem& problem)
    : problem_(&problem), mass_(problem.problem().masses.front()), routes_(problem.members().size()) {
  const auto& masses = problem.problem().masses;
  for (std::size_t object = 1; object < masses.size(); ++object) {
    std::ranges::transform(mass_, masses[object], mass_.begin(), std::plus{});
  }
  mass_left_ = std::accumulate(mass_.begin(), mass_.end(), 0.0);
  for (const Look& look : problem.fixed_looks()) promise(*look.seen, look.rate_per_s);
  for (const auto& member : problem.members()) {
    Progress progress;
    progress.place = member.start;
    progress.busy_until_s = member.start_s;
    progress.heading_rad = member.heading_rad;
    if (member.goal && member.actions->leg(member.start, *member.goal).possible()) {
      progress.goal_ahead = true;
      progress.detour_left_m = kDetourFactor * member.actions->distance_m(*member.goal, member.start) + kDetour_m;
    }
    members_.push_back(progress);
  }
}

int Course::next_member() const {
  int next = -1;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (members_[m].busy_until_s >= problem_->members()[m].end_s) continue;
    if (next < 0 || members_[m].busy_until_s < members_[static_cast<std::size_t>(next)].busy_until_s) {
      next = static_cast<int>(m);
    }
  }
  return next;
}

Choice Course::appraised(int member, int place) const {
  ActionSet& actions = *problem_->members()[static_cast<std::size_t>(member)].actions;
  const Progress& progress = members_[static_cast<std::size_t>(member)];
  const Leg& leg = actions.leg(progress.place, place);
  Choice choice{place, 0.0, 0.0};
  if (!leg.possible()) return choice;
  const double rate_per_s = actions.searcher().detection_rate_per_s;
  for (std::size_t i = 0; i < leg.seen.size(); ++i) {
    choice.gain += mass_[static_cast<std::size_t>(leg.seen.cells[i])] * detected(leg.seen, i, rate_per_s);
  }
  const double time_s =
      leg.duration_s + turning_time_s(actions.searcher(), progress.heading_rad, leg.initial_heading_rad);
  choice.score = choice.gain / (time_s * std::sqrt(time_s));  // the exponent 1.5 measured best for greedy plans
  return choice;
}

void Course::promise(const Sightings& seen, double rate_per_s) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    double& mass = mass_[static_cast<std::size_t>(seen.cells[i])];
    const double gain = mass * detected(seen, i, rate_per_s);
    mass_left_ -= gain;
    mass -= gain;
  }
}

std::vector<Choice> Course::choices(int member, int count) const {
  const PreparedProblem::Member& who = problem_->members()[static_cast<std::size_t>(member)];
  const Progress& progress = members_[static_cast<std::size_t>(member)];
  std::vector<Choice> choices;
  double best_gain = 0.0;
  for (const int lookout : who.actions->nearest_lookouts(progress.place)) {
    if (progress.goal_ahead &&
        who.actions->distance_m(progress.place, lookout) + who.actions->distance_m(*who.goal, lookout) >
            progress.detour_left_m) {
      continue;
    }
    const Choice choice = appraised(member, lookout);
    if (choice.score <= 0.0) continue;
    best_gain = std::max(best_gain, choice.gain);
    choices.push_back(choice);
  }
  if (progress.goal_ahead) {
    choices.push_back(appraised(member, *who.goal));
    // However little is seen on the way, going there is always worth a try.
    const double best = std::ranges::max(choices, {}, &Choice::score).score;
    choices.back().score = std::max({choices.back().score, 0.5 * best, 1e-12});
  } else if (best_gain < kWorthwhile * mass_left_) {
    add_far_lookouts(member, choices);
  }
  std::sort(choices.begin(), choices.end(), is_better);
  if (static_cast<int>(choices.size()) > count) {
    const bool goal_lost = progress.goal_ahead && std::none_of(choices.begin(), choices.begin() + count,
                                                               [&](const Choice& c) { return c.place == *who.goal; });
    choices.resize(static_cast<std::size_t>(count));
    if (goal_lost) choices.back() = {*who.goal, choices.back().score, 0.0};
  }
  if (choices.empty()) choices.push_back({});
  return choices;
}

void Course::add_far_lookouts(int member, std::vector<Choice>& choices) const {
  ActionSet& actions = *problem_->members()[static_cast<std::size_t>(member)].actions;
  const int from = members_[static_cast<std::size_t>(member)].place;
  std::vector<Choice> guesses;
  for (int lookout = 0; lookout < actions.lookouts(); ++lookout) {
    if (lookout == from || !actions.is_connected(from, lookout)) continue;
    double mass = 0.0;
    for (const int cell : actions.panorama(lookout)) mass += mass_[static_cast<std::size_t>(cell)];
    if (mass <= 0.0) continue;
    const double way_m = 1.0 + actions.distance_m(from, lookout);
    guesses.push_back({lookout, mass / (way_m * std::sqrt(way_m)), mass});
  }
  std::sort(guesses.begin(), guesses.end(), is_better);
  for (std::size_t i = 0; i < guesses.size() && i < kFarLookouts; ++i) {
    const int lookout = guesses[i].place;
    if (std::ranges::find(choices, lookout, &Choice::place) != choices.end()) continue;
    if (const Choice choice = appraised(member, lookout); choice.score > 0.0) choices.push_back(choice);
  }
}

void Course::choose(int member, int place) {
  const PreparedProblem::Member& who = problem_->members()[static_cast<std::size_t>(member)];
  Progress& progress = members_[static_cast<std::size_t>(member)];
  if (place < 0) {
    progress.busy_until_s = who.end_s;
    return;
  }
  const Leg& leg = who.actions->leg(progress.place, place);
  promise(leg.seen, who.actions->searcher().detection_rate_per_s);
  progress.busy_until_s +=
      leg.duration_s + turning_time_s(who.actions->searcher(), progress.heading_rad, leg.initial_heading_rad);
  progress.heading_rad = leg.final_heading_rad;
  progress.detour_left_m -= who.actions->distance_m(progress.place, place);
  progress.place = place;
  if (place == who.goal) progress.goal_ahead = false;
  routes_[static_cast<std::size_t>(member)].push_back(place);
}

}  // namespace tandem
