#include "services/planner/core/team/joint_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tandem {
namespace {

constexpr double kDetourFactor = 1.5;  ///< how much further than straight a member may walk to a fixed goal
constexpr double kDetour_m = 4.0;
constexpr float kWorthwhile = 0.004F;  ///< share of the mass left below which the neighbourhood is done
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
    if (member.goal && ground.books[m]->leg(member.start, *member.goal).possible) {
      progress.goal_ahead = true;
      progress.detour_left_m = kDetourFactor * member.actions->distance_m(*member.goal, member.start) + kDetour_m;
    }
    beginnings_.push_back(progress);
  }
  routes_.resize(beginnings_.size());
  restart();
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

double JointWalk::leg_time_s(int member, const CompactLeg& leg) const {
  const auto m = static_cast<std::size_t>(member);
  const Searcher& searcher = ground_->problem->members()[m].actions->searcher();
  return leg.duration_s + turning_time_s(searcher, members_[m].heading_rad, leg.initial_heading_rad);
}

Choice JointWalk::appraised(int member, int place) {
  const auto m = static_cast<std::size_t>(member);
  LegBook& book = *ground_->books[m];
  const CompactLeg& leg = book.leg(members_[m].place, place);
  Choice choice{place, 0.0F, 0.0F};
  if (!leg.possible) return choice;
  if (book.first_sight()) {
    for (const std::int32_t cell : leg.cells) choice.gain += mass_[static_cast<std::size_t>(cell)];
  } else {
    for (std::size_t i = 0; i < leg.cells.size(); ++i) {
      choice.gain += mass_[static_cast<std::size_t>(leg.cells[i])] * (1.0F - leg.kept[i]);
    }
  }
  choice.score = choice.gain / static_cast<float>(std::pow(leg_time_s(member, leg), options_.exponent));
  return choice;
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
    choices_.push_back(appraised(member, *who.goal));
    // However little is seen on the way, going there is always worth a try.
    const float best = std::ranges::max(choices_, {}, &Choice::score).score;
    choices_.back().score = std::max({choices_.back().score, 0.5F * best, 1e-12F});
  } else if (best_gain < kWorthwhile * mass_left_) {
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

void JointWalk::add_far_lookouts(int member) {
  const float total = std::accumulate(ground_->mass.begin(), ground_->mass.end(), 0.0F);
  if (mass_left_ <= kNothingLeft * total) return;
  ActionSet& actions = *ground_->problem->members()[static_cast<std::size_t>(member)].actions;
  const int from = members_[static_cast<std::size_t>(member)].place;
  guesses_.clear();
  for (int lookout = 0; lookout < actions.lookouts(); ++lookout) {
    if (lookout == from || !actions.is_connected(from, lookout)) continue;
    float mass = 0.0F;
    for (const int cell : actions.panorama(lookout)) mass += mass_[static_cast<std::size_t>(cell)];
    if (mass <= kNothingLeft * total) continue;
    const double way_m = 1.0 + actions.distance_m(from, lookout);
    guesses_.push_back({lookout, static_cast<float>(mass / std::pow(way_m, options_.exponent)), mass});
  }
  const auto count = std::min(guesses_.size(), static_cast<std::size_t>(options_.far_lookouts));
  std::partial_sort(guesses_.begin(), guesses_.begin() + static_cast<std::ptrdiff_t>(count), guesses_.end(), is_better);
  for (std::size_t i = 0; i < count; ++i) {
    const int lookout = guesses_[i].place;
    if (std::ranges::find(choices_, lookout, &Choice::place) != choices_.end()) continue;
    if (const Choice choice = appraised(member, lookout); choice.score > 0.0F) choices_.push_back(choice);
  }
}

void JointWalk::choose(int member, int place) {
  const auto m = static_cast<std::size_t>(member);
  const PreparedProblem::Member& who = ground_->problem->members()[m];
  Progress& progress = members_[m];
  if (place < 0) {
    progress.busy_until_s = who.end_s;
    return;
  }
  LegBook& book = *ground_->books[m];
  const CompactLeg& leg = book.leg(progress.place, place);
  mass_left_ -= take_detected(leg, book.first_sight(), mass_);
  progress.busy_until_s += leg_time_s(member, leg);
  progress.heading_rad = leg.final_heading_rad;
  if (progress.goal_ahead) {
    progress.detour_left_m -= who.actions->distance_m(progress.place, place);
    if (place == who.goal) progress.goal_ahead = false;
  }
  progress.place = place;
  routes_[m].push_back(place);
}

void JointWalk::follow(int member, std::span<const int> places) {
  for (const int place : places) {
    const auto m = static_cast<std::size_t>(member);
    if (place == members_[m].place || !ground_->books[m]->leg(members_[m].place, place).possible) continue;
    choose(member, place);
  }
}

}  // namespace tandem
