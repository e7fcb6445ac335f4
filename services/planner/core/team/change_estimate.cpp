#include "services/planner/core/team/change_estimate.hpp"

#include <algorithm>
#include <numeric>

namespace tandem {
namespace {

constexpr std::size_t kLargestChange = 24;  ///< legs
constexpr std::int32_t kFixed = 0;          ///< the visit that stands for what is seen whatever the routes

}  // namespace

ChangeEstimate::ChangeEstimate(const TeamGround& ground)
    : ground_(&ground),
      end_s_(static_cast<float>(ground.problem->problem().horizon_s + ground.problem->problem().tail_s)),
      horizon_s_(static_cast<float>(ground.problem->problem().horizon_s)),
      total_(std::accumulate(ground.mass.begin(), ground.mass.end(), 0.0)),
      fixed_first_s_(ground.mass.size(), end_s_),
      legs_(ground.books.size()),
      seen_(ground.mass.size()),
      sights_(ground.mass.size()),
      trial_first_s_(ground.mass.size()),
      touched_in_(ground.mass.size(), 0) {
  for (const Look& look : ground.problem->fixed_looks()) {
    for (std::size_t i = 0; i < look.seen->size(); ++i) {
      float& first_s = fixed_first_s_[static_cast<std::size_t>(look.seen->cells[i])];
      first_s = std::min(first_s, static_cast<float>(look.start_s + look.seen->enter_s[i]));
    }
  }
}

std::int32_t ChangeEstimate::add_visit(const CompactLeg& leg, double start_s) {
  std::int32_t visit = 0;
  if (free_.empty()) {
    visit = static_cast<std::int32_t>(visits_.size());
    visits_.emplace_back();
    start_s_.emplace_back();
  } else {
    visit = free_.back();
    free_.pop_back();
  }
  visits_[static_cast<std::size_t>(visit)] = {&leg, 0.0, 0.0};
  start_s_[static_cast<std::size_t>(visit)] = static_cast<float>(start_s);
  for (std::size_t i = 0; i < leg.cells.size(); ++i) {
    seen_[static_cast<std::size_t>(leg.cells[i])].push_back({visit, leg.enter_s[i]});
  }
  return visit;
}

void ChangeEstimate::sort_out(std::size_t cell) {
  Seen first{kFixed, fixed_first_s_[cell]};
  Seen second{kFixed, end_s_};
  float first_s = first.enter_s;
  float second_s = end_s_;
  for (const Seen& seen : seen_[cell]) {
    const float seen_s = time_s(seen);
    if (seen_s < first_s) {
      if (seen.visit != first.visit) {
        second = first;
        second_s = first_s;
      }
      first = seen;
      first_s = seen_s;
    } else if (seen_s < second_s && seen.visit != first.visit) {
      second = seen;
      second_s = seen_s;
    }
  }
  sights_[cell] = {first, second};
  visits_[static_cast<std::size_t>(first.visit)].first_mass += ground_->mass[cell];
}

void ChangeEstimate::sort_in(std::size_t cell, const Seen& seen) {
  Sight& sight = sights_[cell];
  const float seen_s = time_s(seen);
  if (seen_s < time_s(sight.first)) {
    visits_[static_cast<std::size_t>(sight.first.visit)].first_mass -= ground_->mass[cell];
    visits_[static_cast<std::size_t>(seen.visit)].first_mass += ground_->mass[cell];
    sight.second = sight.first;
    sight.first = seen;
  } else if (seen_s < time_s(sight.second)) {
    sight.second = seen;
  }
}

void ChangeEstimate::sum_up() {
  for (const auto& legs : legs_) {
    double later = 0.0;
    for (auto visit = legs.rbegin(); visit != legs.rend(); ++visit) {
      Visit& leg = visits_[static_cast<std::size_t>(*visit)];
      leg.later_mass = later += leg.first_mass;
    }
  }
}

void ChangeEstimate::rebase(const Routes& routes) {
  base_ = routes;
  for (auto& seen : seen_) seen.clear();
  visits_.assign(1, {});
  start_s_.assign(1, 0.0F);
  free_.clear();
  for (std::size_t m = 0; m < routes.size(); ++m) {
    const PreparedProblem::Member& who = ground_->problem->members()[m];
    legs_[m].clear();
    double now_s = who.start_s;
    int place = who.start;
    for (const int next : routes[m]) {
      const CompactLeg& leg = ground_->books[m]->leg(place, next);
      legs_[m].push_back(add_visit(leg, now_s));
      now_s += leg.duration_s;
      place = next;
    }
  }
  for (std::size_t cell = 0; cell < sights_.size(); ++cell) sort_out(cell);
  sum_up();
}

std::optional<double> ChangeEstimate::change_s(const Routes& trial) {
  changes_.clear();
  for (std::size_t m = 0; m < trial.size(); ++m) {
    if (!find_change(m, trial[m])) return std::nullopt;
  }
  ++pass_;
  double later = 0.0;
  at_stake_ = 0.0;
  for (const Change& change : changes_) {
    const std::vector<std::int32_t>& legs = legs_[change.member];
    if (change.first < legs.size()) at_stake_ += visits_[static_cast<std::size_t>(legs[change.first])].later_mass;
  }
  for (Change& change : changes_) later += later_by(change, trial[change.member]);
  return later / total_;
}

bool ChangeEstimate::find_change(std::size_t member, const std::vector<int>& trial) {
  const std::vector<int>& base = base_[member];
  const auto [base_from, trial_from] = std::ranges::mismatch(base, trial);
  if (base_from == base.end() && trial_from == trial.end()) return true;
  auto base_to = base.end();
  auto trial_to = trial.end();
  while (base_to != base_from && trial_to != trial_from && base_to[-1] == trial_to[-1]) {
    --base_to;
    --trial_to;
  }
  const auto from = static_cast<std::size_t>(base_from - base.begin());
  Change change{member,
                from,
                static_cast<std::size_t>(base_to - base.begin()),
                from,
                static_cast<std::size_t>(trial_to - trial.begin()),
                0.0,
                0.0};
  if (change.last - change.first > kLargestChange || change.to - change.from > kLargestChange) return false;
  // The leg to the first place behind the change is another one, too.
  if (change.last < base.size()) {
    ++change.last;
    ++change.to;
  }
  changes_.push_back(change);
  return true;
}

double ChangeEstimate::later_by(Change& change, const std::vector<int>& trial) {
  const std::vector<std::int32_t>& legs = legs_[change.member];
  // Plain pointers: what is written below could be what vectors point with, as far as the compiler knows.
  const float* mass = ground_->mass.data();
  const Sight* sights = sights_.data();
  const float* start_s = start_s_.data();
  float* trial_first_s = trial_first_s_.data();
  std::uint32_t* touched_in = touched_in_.data();
  const std::uint32_t pass = pass_;
  const float horizon_s = horizon_s_;
  const float end_s = end_s_;
  const auto time_of = [=](const Seen& seen) {
    const float at_s = start_s[seen.visit] + seen.enter_s;
    return at_s < horizon_s ? at_s : end_s;
  };
  const auto first_of_trial = [=](std::int32_t cell) {
    return touched_in[cell] == pass ? trial_first_s[cell] : time_of(sights[cell].first);
  };
  double later = 0.0;
  for (std::size_t k = change.first; k < change.last; ++k) {
    float later_by_leg = 0.0F;
    for (const std::int32_t cell : visits_[static_cast<std::size_t>(legs[k])].leg->cells) {
      if (sights[cell].first.visit != legs[k]) continue;
      const float first_s = first_of_trial(cell);
      const float second_s = time_of(sights[cell].second);
      if (first_s >= second_s) continue;
      later_by_leg += mass[cell] * (second_s - first_s);
      trial_first_s[cell] = second_s;
      touched_in[cell] = pass;
    }
    later += later_by_leg;
  }
  const PreparedProblem::Member& who = ground_->problem->members()[change.member];
  LegBook& book = *ground_->books[change.member];
  double now_s = who.start_s;
  int place = who.start;
  if (change.first > 0) {
    const auto before = static_cast<std::size_t>(legs[change.first - 1]);
    now_s = static_cast<double>(start_s[before]) + visits_[before].leg->duration_s;
    place = trial[change.first - 1];
  }
  change.start_s = now_s;
  for (std::size_t k = change.from; k < change.to; ++k) {
    const CompactLeg& leg = book.leg(place, trial[k]);
    const auto leg_start_s = static_cast<float>(now_s);
    const std::int32_t* cells = leg.cells.data();
    const float* enter_s = leg.enter_s.data();
    float sooner_by_leg = 0.0F;
    for (std::size_t i = 0, count = leg.cells.size(); i < count; ++i) {
      const std::int32_t cell = cells[i];
      const float seen_s = leg_start_s + enter_s[i];
      const float first_s = first_of_trial(cell);
      if (seen_s >= first_s || seen_s >= horizon_s) continue;
      sooner_by_leg += mass[cell] * (first_s - seen_s);
      touched_in[cell] = pass;
      trial_first_s[cell] = seen_s;
    }
    later -= sooner_by_leg;
    now_s += leg.duration_s;
    place = trial[k];
  }
  if (change.last < legs.size()) {
    const auto behind = static_cast<std::size_t>(legs[change.last]);
    change.delay_s = now_s - start_s_[behind];
    later += change.delay_s * visits_[behind].later_mass;
  }
  return later;
}

void ChangeEstimate::replace_visits(const Change& change, const std::vector<int>& trial) {
  std::vector<std::int32_t>& legs = legs_[change.member];
  for (std::size_t k = change.first; k < change.last; ++k) {
    for (const std::int32_t c : visits_[static_cast<std::size_t>(legs[k])].leg->cells) {
      const auto cell = static_cast<std::size_t>(c);
      const auto seen = std::ranges::find(seen_[cell], legs[k], &Seen::visit);
      *seen = seen_[cell].back();
      seen_[cell].pop_back();
      const Sight& sight = sights_[cell];
      const bool counted = sight.first.visit == legs[k] || sight.second.visit == legs[k];
      if (!counted || touched_in_[cell] == pass_) continue;
      touched_in_[cell] = pass_;
      touched_.push_back(cell);
      visits_[static_cast<std::size_t>(sight.first.visit)].first_mass -= ground_->mass[cell];
    }
    free_.push_back(legs[k]);
  }
  const auto begin = legs.erase(legs.begin() + static_cast<std::ptrdiff_t>(change.first),
                                legs.begin() + static_cast<std::ptrdiff_t>(change.last));
  auto into = begin - legs.begin();
  double now_s = change.start_s;
  int place = change.first > 0 ? trial[change.first - 1] : ground_->problem->members()[change.member].start;
  for (std::size_t k = change.from; k < change.to; ++k) {
    const CompactLeg& leg = ground_->books[change.member]->leg(place, trial[k]);
    new_visits_.push_back(add_visit(leg, now_s));
    legs.insert(legs.begin() + into++, new_visits_.back());
    now_s += leg.duration_s;
    place = trial[k];
  }
  for (auto k = static_cast<std::size_t>(into); k < legs.size(); ++k) {
    start_s_[static_cast<std::size_t>(legs[k])] += static_cast<float>(change.delay_s);
  }
}

void ChangeEstimate::accept(const Routes& trial) {
  ++pass_;
  touched_.clear();
  new_visits_.clear();
  for (const Change& change : changes_) {
    replace_visits(change, trial[change.member]);
    base_[change.member] = trial[change.member];
  }
  for (const std::size_t cell : touched_) sort_out(cell);
  for (const std::int32_t visit : new_visits_) {
    const CompactLeg& leg = *visits_[static_cast<std::size_t>(visit)].leg;
    for (std::size_t i = 0; i < leg.cells.size(); ++i) {
      const auto cell = static_cast<std::size_t>(leg.cells[i]);
      if (touched_in_[cell] != pass_) sort_in(cell, {visit, leg.enter_s[i]});
    }
  }
  sum_up();
}

}  // namespace tandem
