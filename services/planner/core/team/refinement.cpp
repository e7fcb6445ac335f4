#include "services/planner/core/team/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

constexpr std::size_t kLongestPiece = 5;
constexpr std::size_t kLongestReversal = 12;
constexpr double kSame_s = 1e-9;
constexpr double kHeating = 3.0;           ///< after a cycle that found nothing better, the next begins so much warmer
constexpr double kHottest = 4.0;           ///< times the warmth at first
constexpr int kMovesOfLookout = 75;        ///< in the first cycle, for each member
constexpr double kPlacesOfWarmth = 100.0;  ///< longer routes begin a cycle colder ...
constexpr double kCoolingOfPlaces = 3.0;   ///< ... by this power of their length: one move changes a smaller share
constexpr int kMostFruitless = 2;          ///< cycles
constexpr int kMovesOfWarmth = 16;         ///< made at one temperature
constexpr int kMostDrift = 200;            ///< changes accepted by estimate until the value is made exact again

auto at(std::vector<int>& places, std::size_t position) {
  return places.begin() + static_cast<std::ptrdiff_t>(position);
}

}  // namespace

Refinement::Refinement(const TeamGround& ground, RouteValue& value, const RefinementOptions& options)
    : ground_(&ground), value_(&value), options_(options), translation_(ground) {
  const SearchProblem& search = ground.problem->problem();
  const bool is_plain = std::ranges::all_of(
      search.members, [&](const auto& who) { return who.hypotheses.empty() && who.battery_s >= search.horizon_s; });
  if (ground.first_sight && search.masses.size() == 1 && is_plain && search.rejected.empty()) {
    estimate_.emplace(ground);
  }
}

void Refinement::take(const Routes& routes, double value_s) {
  current_ = routes;
  current_s_ = value_s;
  drifted_ = 0;
  if (estimate_) estimate_->rebase(current_);
}

void Refinement::begin_cycle() {
  best_before_s_ = best_s_;
  in_cycle_ = 0;
  std::size_t places = 1;
  for (const auto& route : best_) places += route.size();
  warmest_ = options_.warmth * std::min(1.0, std::pow(kPlacesOfWarmth / static_cast<double>(places), kCoolingOfPlaces));
}

void Refinement::restart(const Routes& routes, double value_s) {
  best_ = routes;
  best_s_ = value_s;
  take(best_, best_s_);
  int lookouts = 0;
  for (LegBook* book : ground_->books) lookouts += book->actions().lookouts();
  cycle_ = std::min(options_.cycle, kMovesOfLookout * std::max(1, lookouts));
  heat_ = 1.0;
  fruitless_ = 0;
  begin_cycle();
  fixed_.assign(routes.size(), 0);
  for (std::size_t m = 0; m < routes.size(); ++m) {
    const auto& goal = ground_->problem->members()[m].goal;
    if (!goal) continue;
    const auto reached = std::ranges::find(routes[m], *goal);
    if (reached != routes[m].end()) fixed_[m] = static_cast<std::size_t>(reached - routes[m].begin()) + 1;
  }
}

bool Refinement::improve(int moves, Rng& rng) {
  // How often each kind is tried, of 100; what was measured to help.
  static constexpr struct {
    Move move;
    double share;
  } kMoves[] = {{Move::Replace, 0.23}, {Move::Relocate, 0.23}, {Move::Insert, 0.12}, {Move::Remove, 0.12},
                {Move::Piece, 0.12},   {Move::Reverse, 0.10},  {Move::Swap, 0.05},   {Move::Tails, 0.03}};
  const double before_s = best_s_;
  double warmth = 0.0;
  for (int i = 0; i < moves; ++i, ++in_cycle_) {
    if (in_cycle_ == cycle_) {
      const bool is_fruitful = best_s_ < best_before_s_ - 1e-9;
      fruitless_ = is_fruitful ? 0 : fruitless_ + 1;
      heat_ = is_fruitful ? 1.0 : std::min(kHottest, kHeating * heat_);
      cycle_ *= 2;
      begin_cycle();
      take(best_, best_s_);
    }
    if (i % kMovesOfWarmth == 0) warmth = warmth_now();
    double u = rng.uniform();
    std::size_t kind = 0;
    while (kind + 1 < std::size(kMoves) && u >= kMoves[kind].share) u -= kMoves[kind++].share;
    trial_ = current_;
    if (!make_trial(kMoves[kind].move, rng) || !join(rng)) continue;
    judge(best_s_ * warmth, rng.uniform());
  }
  if (drifted_ > 0 && current_s_ < best_s_ - 1e-9) {
    current_s_ = value_->value_s(current_);
    keep_best();
  }
  return best_s_ < before_s;
}

double Refinement::warmth_now() const {
  const double progress = static_cast<double>(in_cycle_) / static_cast<double>(cycle_);
  const double warmest = std::max(options_.coldness, heat_ * warmest_);
  return warmest * std::pow(options_.coldness / warmest, progress);
}

bool Refinement::is_stuck() const {
  return fruitless_ >= kMostFruitless;
}

void Refinement::judge(double temperature_s, double u) {
  ++judged_;
  const auto change_s = estimate_ ? estimate_->change_s(trial_) : std::nullopt;
  const double trial_s = change_s ? current_s_ + *change_s : value_->value_s(trial_);
  // A late change decides on little; at one temperature for all, nearly every one of them would be taken.
  if (change_s) temperature_s *= estimate_->share_at_stake();
  if (trial_s > current_s_ - temperature_s * std::log(1.0 - u)) return;
  if (std::abs(trial_s - current_s_) < kSame_s && is_longer()) return;  // places that nobody needs would pile up
  std::swap(current_, trial_);
  if (change_s && drifted_ < kMostDrift) {
    estimate_->accept(current_);
    ++drifted_;
    current_s_ = trial_s;
    return;
  }
  take(current_, change_s ? value_->value_s(current_) : trial_s);
  keep_best();
}

void Refinement::keep_best() {
  if (current_s_ >= best_s_ - 1e-9) return;
  best_ = current_;
  best_s_ = current_s_;
}

bool Refinement::is_longer() const {
  std::size_t places = 0;
  std::size_t before = 0;
  for (const auto& route : trial_) places += route.size();
  for (const auto& route : current_) before += route.size();
  return places > before;
}

bool Refinement::is_walk(std::size_t member) const {
  const std::vector<int>& route = trial_[member];
  const std::vector<int>& before = current_[member];
  // Only legs between what stayed at the beginning and what stayed at the end are new.
  const auto begin = std::ranges::mismatch(route, before).in1;
  auto end = route.end();
  for (auto old = before.end(); end != begin && old != before.begin() && end[-1] == old[-1]; --old) --end;
  if (end != route.end()) ++end;
  ActionSet& actions = ground_->books[member]->actions();
  int from = begin == route.begin() ? ground_->problem->members()[member].start : begin[-1];
  return std::all_of(begin, end, [&](int to) { return actions.is_near(std::exchange(from, to), to); });
}

bool Refinement::join(Rng& rng) {
  for (std::size_t m = 0; m < trial_.size(); ++m) {
    if (is_walk(m)) continue;
    if (rng.uniform() >= options_.far_legs) return false;
    trial_[m] = ground_->books[m]->actions().joined(ground_->problem->members()[m].start, trial_[m]);
  }
  return true;
}

std::size_t Refinement::free_places(std::size_t member) const {
  return current_[member].size() - fixed_[member];
}

/// A free position, the earlier the likelier: what comes first weighs most.
std::size_t Refinement::position(std::size_t member, Rng& rng) const {
  const double u = rng.uniform();
  return fixed_[member] + static_cast<std::size_t>(u * std::sqrt(u) * static_cast<double>(free_places(member)));
}

int Refinement::neighbour(std::size_t member, int place, Rng& rng) const {
  const auto& near = ground_->books[member]->actions().nearest_lookouts(place);
  if (near.empty()) return -1;
  return near[rng.index(std::min(near.size(), static_cast<std::size_t>(options_.neighbours)))];
}

Refinement::Spot Refinement::spot_near(std::size_t member, int place, Rng& rng) const {
  const int wanted = neighbour(member, place, rng);
  const std::size_t first = rng.index(trial_.size());
  for (std::size_t k = 0; wanted >= 0 && k < trial_.size(); ++k) {
    const std::size_t m = (first + k) % trial_.size();
    const int there = translation_.translated(member, m, wanted);
    const auto begin = trial_[m].begin() + static_cast<std::ptrdiff_t>(std::min(fixed_[m], trial_[m].size()));
    const auto found = std::find(begin, trial_[m].end(), there);
    if (found != trial_[m].end()) return {m, static_cast<std::size_t>(found - trial_[m].begin())};
  }
  return {trial_.size(), 0};
}

bool Refinement::translate(std::size_t from, std::size_t to, std::vector<int>& places) const {
  const int lookouts = ground_->books[from]->actions().lookouts();
  for (int& place : places) {
    if (place >= lookouts) return false;
    place = translation_.translated(from, to, place);
    if (place < 0) return false;
  }
  return true;
}

bool Refinement::relocate(std::size_t a, std::size_t i, std::size_t length, Rng& rng) {
  length = std::min(length, trial_[a].size() - i);
  const int place = trial_[a][i];
  if (place >= ground_->books[a]->actions().lookouts()) return false;
  piece_.assign(at(trial_[a], i), at(trial_[a], i + length));
  trial_[a].erase(at(trial_[a], i), at(trial_[a], i + length));
  const Spot spot = spot_near(a, place, rng);
  if (spot.member == trial_.size() || !translate(a, spot.member, piece_)) return false;
  if (length > 1 && rng.uniform() < 0.5) std::reverse(piece_.begin(), piece_.end());
  const std::size_t where = spot.position + (rng.uniform() < 0.5 ? 1 : 0);
  trial_[spot.member].insert(at(trial_[spot.member], where), piece_.begin(), piece_.end());
  return true;
}

bool Refinement::swap_tails(std::size_t a, std::size_t i, Rng& rng) {
  if (trial_.size() < 2 || trial_[a][i] >= ground_->books[a]->actions().lookouts()) return false;
  const Spot spot = spot_near(a, trial_[a][i], rng);
  if (spot.member == trial_.size() || spot.member == a) return false;
  const std::size_t b = spot.member;
  piece_.assign(at(trial_[a], i + 1), trial_[a].end());
  other_piece_.assign(at(trial_[b], spot.position), trial_[b].end());
  if (!translate(a, b, piece_) || !translate(b, a, other_piece_)) return false;
  trial_[a].resize(i + 1);
  trial_[b].resize(spot.position);
  trial_[a].insert(trial_[a].end(), other_piece_.begin(), other_piece_.end());
  trial_[b].insert(trial_[b].end(), piece_.begin(), piece_.end());
  return true;
}

bool Refinement::make_trial(Move move, Rng& rng) {
  const std::size_t a = rng.index(trial_.size());
  if (free_places(a) == 0) return false;
  const std::size_t i = position(a, rng);
  std::vector<int>& route = trial_[a];
  switch (move) {
    case Move::Insert: {
      const int place = neighbour(a, route[i], rng);
      if (place < 0) return false;
      route.insert(at(route, i + (rng.uniform() < 0.5 ? 1 : 0)), place);
      return true;
    }
    case Move::Remove:
      route.erase(at(route, i));
      return true;
    case Move::Relocate:
      return relocate(a, i, 1, rng);
    case Move::Piece:
      return relocate(a, i, 2 + rng.index(kLongestPiece - 1), rng);
    case Move::Replace: {
      const int place = neighbour(a, route[i], rng);
      if (place < 0) return false;
      route[i] = place;
      return true;
    }
    case Move::Swap: {
      const Spot spot = spot_near(a, route[i], rng);
      if (spot.member == trial_.size()) return false;
      const int lookouts_a = ground_->books[a]->actions().lookouts();
      int& other = trial_[spot.member][spot.position];
      if (route[i] >= lookouts_a || other >= ground_->books[spot.member]->actions().lookouts()) return false;
      const int there = translation_.translated(a, spot.member, route[i]);
      const int here = translation_.translated(spot.member, a, other);
      if (there < 0 || here < 0) return false;
      other = there;
      route[i] = here;
      return true;
    }
    case Move::Reverse: {
      const std::size_t length = 2 + rng.index(kLongestReversal - 1);
      if (i + 2 > route.size()) return false;
      std::reverse(at(route, i), at(route, std::min(route.size(), i + length)));
      return true;
    }
    case Move::Tails:
      return swap_tails(a, i, rng);
  }
  return false;
}

}  // namespace tandem
