#include "services/planner/core/team/joint_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace tandem {
namespace {

constexpr double kDetourFactor = 1.5;  ///< how much further than straight a member may walk to a fixed goal
constexpr double kDetour_m = 4.0;
/// The neighbourhood is done once its best leg shows less than this share of what is left for each lookout.
constexpr double kWorthwhile = 2.0;
constexpr float kNothingLeft = 1e-6F;  ///< of the mass

bool is_better(const Choice& a, const Choice& b) {
  return a.score != b.score ? a.score > b.score : a.place < b.place;
}

}  // namespace

JointWalk::JointWalk(const TeamGround& ground, const WalkOptions& options) : ground_(&ground), options_(options) {
  for (std::size_t m = 0; m < ground.problem->members().size(); ++m) {
    const PreparedProblem::Member& member = ground.problem->members()[m];
    Progress progress;
    progress.place = member.start;
    progress.busy_until_s = member.start_s;
    progress.heading_rad = static_cast<float>(member.heading_rad);
    if (member.goal && member.actions->is_connected(member.start, *member.goal)) {
      progress.goal_ahead = true;
      progress.detour_left_m = kDetourFactor * member.actions->distance_m(*member.goal, member.start) + kDetour_m;
    }
    beginnings_.push_back(progress);
  }
  routes_.resize(beginnings_.size());
  counted_.assign(ground.mass.size(), 0);
  total_ = std::accumulate(ground.mass.begin(), ground.mass.end(), 0.0F);
  restart();
  for (const PreparedProblem::Member& member : ground.problem->members()) {
    for (int lookout = 0; lookout < member.actions->lookouts(); ++lookout) {
      best_view_ = std::max(best_view_, in_view_of(*member.actions, lookout));
    }
  }
}

void JointWalk::restart() {
  members_ = beginnings_;
  mass_ = ground_->unpromised;
  mass_left_ = std::accumulate(mass_.begin(), mass_.end(), 0.0F);
  for (auto& route : routes_) route.clear();
}

int JointWalk::next_member(int only) const {
  int next = -1;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (only >= 0 && static_cast<int>(m) != only) continue;
    if (members_[m].busy_until_s >= ground_->problem->members()[m].end_s) continue;
    if (next < 0 || members_[m].busy_until_s < members_[static_cast<std::size_t>(next)].busy_until_s) {
      next = static_cast<int>(m);
    }
  }
  return next;
}

double JointWalk::time_left_s(int member) const {
  const auto m = static_cast<std::size_t>(member);
  return ground_->problem->members()[m].end_s - members_[m].busy_until_s;
}

double JointWalk::leg_time_s(int member, const CompactLeg& leg) const {
  const auto m = static_cast<std::size_t>(member);
  const Searcher& searcher = ground_->problem->members()[m].actions->searcher();
  return leg.duration_s + turning_time_s(searcher, members_[m].heading_rad, leg.initial_heading_rad);
}

Choice JointWalk::scored(int place, float gain, double time_s) const {
  return {place, time_s > 0.0 ? gain / static_cast<float>(std::pow(time_s, options_.exponent)) : 0.0F, gain};
}

Choice JointWalk::appraised(int member, int place) {
  const auto m = static_cast<std::size_t>(member);
  LegBook& book = *ground_->books[m];
  const CompactLeg& leg = book.leg(members_[m].place, place);
  if (!leg.possible) return {place, 0.0F, 0.0F};
  const auto shown = [&](std::size_t i) {
    const float mass = mass_[static_cast<std::size_t>(leg.cells[i])];
    return book.first_sight() ? mass : mass * (1.0F - leg.kept[i]);
  };
  // Four sums, as each addition waits for the one before it.
  std::array<float, 4> gain{};
  const double time_s = leg_time_s(member, leg);
  const std::size_t count = cells_until(leg, time_left_s(member) - (time_s - leg.duration_s));
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) gain[k] += shown(i + k);
  }
  for (; i < count; ++i) gain[0] += shown(i);
  return scored(place, (gain[0] + gain[1]) + (gain[2] + gain[3]), time_s);
}

Choice JointWalk::appraised_far(int member, int place) {
  const auto m = static_cast<std::size_t>(member);
  LegBook& book = *ground_->books[m];
  ++appraisal_;
  float gain = 0.0F;
  double time_s = 0.0;
  int from = members_[m].place;
  for (const int stop : book.actions().joined(from, {&place, 1})) {
    const CompactLeg& leg = book.leg(from, stop);
    if (!leg.possible) continue;
    const double leg_s = leg_time_s(member, leg);
    const std::size_t count = cells_until(leg, time_left_s(member) - time_s - (leg_s - leg.duration_s));
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t& counted = counted_[static_cast<std::size_t>(leg.cells[i])];
      const float mass = mass_[static_cast<std::size_t>(leg.cells[i])];
      if (counted != appraisal_) gain += book.first_sight() ? mass : mass * (1.0F - leg.kept[i]);
      counted = appraisal_;
    }
    time_s += leg_s;
    from = stop;
  }
  return scored(place, gain, time_s);
}

std::span<const Choice> JointWalk::choices(int member, int count) {
  const auto m = static_cast<std::size_t>(member);
  const PreparedProblem::Member& who = ground_->problem->members()[m];
  const Progress& progress = members_[m];
  choices_.clear();
  float best_gain = 0.0F;
  for (const int lookout : who.actions->nearest_lookouts(progress.place)) {
    if (progress.goal_ahead &&
        who.actions->distance_m(progress.place, lookout) + who.actions->distance_m(*who.goal, lookout) >
            progress.detour_left_m) {
      continue;
    }
    const Choice choice = appraised(member, lookout);
    if (choice.score <= 0.0F) continue;
    best_gain = std::max(best_gain, choice.gain);
    choices_.push_back(choice);
  }
  if (progress.goal_ahead) {
    choices_.push_back(appraised_far(member, *who.goal));
    // However little is seen on the way, going there is always worth a try.
    const float best = std::ranges::max(choices_, {}, &Choice::score).score;
    choices_.back().score = std::max({choices_.back().score, 0.5F * best, 1e-12F});
  } else if (best_gain < kWorthwhile * mass_left_ / who.actions->lookouts()) {
    add_far_lookouts(member);
  }
  std::sort(choices_.begin(), choices_.end(), is_better);
  if (static_cast<int>(choices_.size()) > count) {
    const bool goal_lost = progress.goal_ahead && std::none_of(choices_.begin(), choices_.begin() + count,
                                                               [&](const Choice& c) { return c.place == *who.goal; });
    choices_.resize(static_cast<std::size_t>(count));
    if (goal_lost) choices_.back() = {*who.goal, choices_.back().score, 0.0F};
  }
  if (choices_.empty()) choices_.push_back({});
  return choices_;
}

float JointWalk::in_view_of(ActionSet& actions, int lookout) const {
  float mass = 0.0F;
  for (const int cell : actions.panorama(lookout)) mass += mass_[static_cast<std::size_t>(cell)];
  return mass;
}

/// The far lookouts with the best guesses: searches outward until no lookout further away can be among them.
void JointWalk::add_far_lookouts(int member) {
  if (mass_left_ <= kNothingLeft * total_) return;
  ActionSet& actions = *ground_->problem->members()[static_cast<std::size_t>(member)].actions;
  const auto most = static_cast<std::size_t>(options_.far_lookouts);
  guesses_.clear();
  actions.explore(members_[static_cast<std::size_t>(member)].place, [&](int lookout, double distance_m) {
    const auto way = static_cast<float>(std::pow(1.0 + distance_m, options_.exponent));
    if (guesses_.size() == most && guesses_.back().score >= std::min(best_view_, mass_left_) / way) return false;
    const float mass = in_view_of(actions, lookout);
    if (mass <= kNothingLeft * total_) return true;
    const Choice guess{lookout, mass / way, mass};
    if (guesses_.size() == most && !is_better(guess, guesses_.back())) return true;
    guesses_.insert(std::upper_bound(guesses_.begin(), guesses_.end(), guess, is_better), guess);
    if (guesses_.size() > most) guesses_.pop_back();
    return true;
  });
  for (const Choice& guess : guesses_) {
    if (std::ranges::find(choices_, guess.place, &Choice::place) != choices_.end()) continue;
    if (const Choice choice = appraised_far(member, guess.place); choice.score > 0.0F) choices_.push_back(choice);
  }
}

void JointWalk::go(int member, int place) {
  const auto m = static_cast<std::size_t>(member);
  const PreparedProblem::Member& who = ground_->problem->members()[m];
  Progress& progress = members_[m];
  LegBook& book = *ground_->books[m];
  const CompactLeg& leg = book.leg(progress.place, place);
  const double leg_s = leg_time_s(member, leg);
  const std::size_t cells = cells_until(leg, time_left_s(member) - (leg_s - leg.duration_s));
  mass_left_ -= take_detected(leg, cells, book.first_sight(), mass_);
  progress.busy_until_s += leg_s;
  progress.heading_rad = leg.final_heading_rad;
  if (progress.goal_ahead) {
    progress.detour_left_m -= who.actions->distance_m(progress.place, place);
    if (place == who.goal) progress.goal_ahead = false;
  }
  progress.place = place;
  routes_[m].push_back(place);
}

void JointWalk::choose(int member, int place) {
  const auto m = static_cast<std::size_t>(member);
  if (place < 0) {
    members_[m].busy_until_s = ground_->problem->members()[m].end_s;
    return;
  }
  ActionSet& actions = *ground_->problem->members()[m].actions;
  if (actions.is_near(members_[m].place, place)) {
    go(member, place);
  } else {
    for (const int stop : actions.joined(members_[m].place, {&place, 1})) go(member, stop);
  }
}

}  // namespace tandem
