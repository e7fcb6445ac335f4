#include "services/planner/core/team/change_estimate.hpp"

#include <algorithm>
#include <numeric>

namespace tandem {
namespace {

constexpr std::size_t kLargestChange = 24;  ///< legs
constexpr std::int32_t kFixed = 0;          ///< the visit that stands for what is seen whatever the routes

LegCells cells_of(const CompactLeg& leg) {
  return {leg.cells.data(), leg.enter_s.data(), leg.cells.size()};
}

}  // namespace

ChangeEstimate::ChangeEstimate(const TeamGround& ground)
    : ground_(&ground),
      end_s_(static_cast<float>(ground.problem->problem().horizon_s + ground.problem->problem().tail_s)),
      horizon_s_(static_cast<float>(ground.problem->problem().horizon_s)),
      total_(std::accumulate(ground.mass.begin(), ground.mass.end(), 0.0)),
      fixed_first_s_(ground.mass.size(), end_s_),
      legs_(ground.books.size()),
      seen_(ground.mass.size()),
      times_(ground.mass.size()),
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
  std::int32_t first = kFixed;
  std::int32_t second = kFixed;
  float first_s = fixed_first_s_[cell];
  float second_s = end_s_;
  for (const Seen& seen : seen_[cell]) {
    const float seen_s = time_s(seen);
    if (seen_s < first_s) {
      if (seen.visit != first) {
        second = first;
        second_s = first_s;
      }
      first = seen.visit;
      first_s = seen_s;
    } else if (seen_s < second_s && seen.visit != first) {
      second = seen.visit;
      second_s = seen_s;
    }
  }
  times_.first[cell] = first;
  times_.first_s[cell] = first_s;
  times_.second[cell] = second;
  times_.second_s[cell] = second_s;
  visits_[static_cast<std::size_t>(first)].first_mass += ground_->mass[cell];
}

void ChangeEstimate::sort_in(std::size_t cell, const Seen& seen) {
  const float seen_s = time_s(seen);
  if (seen_s < times_.first_s[cell]) {
    visits_[static_cast<std::size_t>(times_.first[cell])].first_mass -= ground_->mass[cell];
    visits_[static_cast<std::size_t>(seen.visit)].first_mass += ground_->mass[cell];
    times_.second[cell] = times_.first[cell];
    times_.second_s[cell] = times_.first_s[cell];
    times_.first[cell] = seen.visit;
    times_.first_s[cell] = seen_s;
  } else if (seen_s < times_.second_s[cell]) {
    times_.second[cell] = seen.visit;
    times_.second_s[cell] = seen_s;
  }
}

void ChangeEstimate::shift(std::int32_t visit) {
  const CompactLeg& leg = *visits_[static_cast<std::size_t>(visit)].leg;
  for (std::size_t i = 0; i < leg.cells.size(); ++i) {
    const auto cell = static_cast<std::size_t>(leg.cells[i]);
    if (times_.first[cell] == visit) times_.first_s[cell] = time_s({visit, leg.enter_s[i]});
    if (times_.second[cell] == visit) times_.second_s[cell] = time_s({visit, leg.enter_s[i]});
    if (times_.first_s[cell] <= times_.second_s[cell] || touched_in_[cell] == pass_) continue;
    touched_in_[cell] = pass_;
    touched_.push_back(cell);
    visits_[static_cast<std::size_t>(times_.first[cell])].first_mass -= ground_->mass[cell];
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
  for (std::size_t cell = 0; cell < times_.first.size(); ++cell) sort_out(cell);
  sum_up();
}

std::optional<double> ChangeEstimate::change_s(const Routes& trial) {
  changes_.clear();
  for (std::size_t m = 0; m < trial.size(); ++m) {
    if (!find_change(m, trial[m])) return std::nullopt;
  }
  double later = 0.0;
  at_stake_ = 0.0;
  for (const Change& change : changes_) {
    const std::vector<std::int32_t>& legs = legs_[change.member];
    if (change.first < legs.size()) at_stake_ += visits_[static_cast<std::size_t>(legs[change.first])].later_mass;
  }
  new_legs_.clear();
  for (Change& change : changes_) fetch(change, trial[change.member]);
  for (const Change& change : changes_) later += later_without(change);
  for (Change& change : changes_) later -= sooner_with(change);
  overwritten_.put_back(times_.first_s);
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
                0,
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

void ChangeEstimate::fetch(Change& change, const std::vector<int>& trial) {
  const std::vector<std::int32_t>& legs = legs_[change.member];
  const auto fetch_cells = [](const CompactLeg& leg) {
    __builtin_prefetch(leg.cells.data());
    __builtin_prefetch(leg.enter_s.data());
  };
  for (std::size_t k = change.first; k < change.last; ++k) {
    fetch_cells(*visits_[static_cast<std::size_t>(legs[k])].leg);
  }
  change.new_leg = new_legs_.size();
  int place = change.first > 0 ? trial[change.first - 1] : ground_->problem->members()[change.member].start;
  for (std::size_t k = change.from; k < change.to; ++k) {
    new_legs_.push_back(&ground_->books[change.member]->leg(place, trial[k]));
    fetch_cells(*new_legs_.back());
    place = trial[k];
  }
}

double ChangeEstimate::later_without(const Change& change) {
  double later = 0.0;
  for (std::size_t k = change.first; k < change.last; ++k) {
    const std::int32_t visit = legs_[change.member][k];
    const CompactLeg& leg = *visits_[static_cast<std::size_t>(visit)].leg;
    later += take_later(cells_of(leg), visit, ground_->mass, times_, overwritten_);
  }
  return later;
}

double ChangeEstimate::sooner_with(Change& change) {
  const std::vector<std::int32_t>& legs = legs_[change.member];
  const PreparedProblem::Member& who = ground_->problem->members()[change.member];
  double now_s = who.start_s;
  if (change.first > 0) {
    const auto before = static_cast<std::size_t>(legs[change.first - 1]);
    now_s = static_cast<double>(start_s_[before]) + visits_[before].leg->duration_s;
  }
  change.start_s = now_s;
  double sooner = 0.0;
  for (std::size_t k = change.from; k < change.to; ++k) {
    const CompactLeg& leg = *new_legs_[change.new_leg + k - change.from];
    sooner += take_sooner(cells_of(leg), static_cast<float>(now_s), horizon_s_, ground_->mass, times_, overwritten_);
    now_s += leg.duration_s;
  }
  if (change.last < legs.size()) {
    const auto behind = static_cast<std::size_t>(legs[change.last]);
    change.delay_s = now_s - start_s_[behind];
    sooner -= change.delay_s * visits_[behind].later_mass;
  }
  return sooner;
}

void ChangeEstimate::replace_visits(const Change& change) {
  std::vector<std::int32_t>& legs = legs_[change.member];
  for (std::size_t k = change.first; k < change.last; ++k) {
    for (const std::int32_t c : visits_[static_cast<std::size_t>(legs[k])].leg->cells) {
      const auto cell = static_cast<std::size_t>(c);
      const auto seen = std::ranges::find(seen_[cell], legs[k], &Seen::visit);
      *seen = seen_[cell].back();
      seen_[cell].pop_back();
      const bool counted = times_.first[cell] == legs[k] || times_.second[cell] == legs[k];
      if (!counted || touched_in_[cell] == pass_) continue;
      touched_in_[cell] = pass_;
      touched_.push_back(cell);
      visits_[static_cast<std::size_t>(times_.first[cell])].first_mass -= ground_->mass[cell];
    }
    free_.push_back(legs[k]);
  }
  const auto begin = legs.erase(legs.begin() + static_cast<std::ptrdiff_t>(change.first),
                                legs.begin() + static_cast<std::ptrdiff_t>(change.last));
  auto into = begin - legs.begin();
  double now_s = change.start_s;
  for (std::size_t k = change.from; k < change.to; ++k) {
    const CompactLeg& leg = *new_legs_[change.new_leg + k - change.from];
    new_visits_.push_back(add_visit(leg, now_s));
    legs.insert(legs.begin() + into++, new_visits_.back());
    now_s += leg.duration_s;
  }
  for (auto k = static_cast<std::size_t>(into); k < legs.size(); ++k) {
    start_s_[static_cast<std::size_t>(legs[k])] += static_cast<float>(change.delay_s);
    shift(legs[k]);
  }
}

void ChangeEstimate::accept(const Routes& trial) {
  ++pass_;
  touched_.clear();
  new_visits_.clear();
  for (const Change& change : changes_) {
    replace_visits(change);
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
