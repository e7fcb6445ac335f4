#include "services/planner/core/team/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr std::size_t kLongestPiece = 5;
constexpr std::size_t kLongestReversal = 12;

auto at(std::vector<int>& places, std::size_t position) {
  return places.begin() + static_cast<std::ptrdiff_t>(position);
}

}  // namespace

Refinement::Refinement(const TeamGround& ground, RouteValue& value, const RefinementOptions& options)
    : ground_(&ground), value_(&value), options_(options), translation_(ground) {}

void Refinement::restart(const Routes& routes, double value_s) {
  current_ = best_ = routes;
  current_s_ = best_s_ = value_s;
  moves_ = 0;
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
  } kMoves[] = {{Move::Replace, 0.22}, {Move::Relocate, 0.22}, {Move::Insert, 0.12}, {Move::Remove, 0.12},
                {Move::Piece, 0.12},   {Move::Reverse, 0.10},  {Move::Swap, 0.05},   {Move::Tails, 0.05}};
  const double before_s = best_s_;
  for (int i = 0; i < moves; ++i, ++moves_) {
    if (moves_ > 0 && moves_ % options_.cycle == 0) {
      current_ = best_;
      current_s_ = best_s_;
    }
    double u = rng.uniform();
    std::size_t kind = 0;
    while (kind + 1 < std::size(kMoves) && u >= kMoves[kind].share) u -= kMoves[kind++].share;
    trial_ = current_;
    if (!make_trial(kMoves[kind].move, rng)) continue;
    if (!stays_near() && rng.uniform() >= options_.far_legs) continue;
    const double trial_s = value_->value_s(trial_);
    const double progress = static_cast<double>(moves_ % options_.cycle) / options_.cycle;
    const double temperature_s = best_s_ * options_.warmth * std::pow(options_.coldness / options_.warmth, progress);
    if (trial_s > current_s_ && rng.uniform() >= std::exp((current_s_ - trial_s) / temperature_s)) continue;
    std::swap(current_, trial_);
    current_s_ = trial_s;
    if (current_s_ < best_s_ - 1e-9) {
      best_ = current_;
      best_s_ = current_s_;
    }
  }
  return best_s_ < before_s;
}

bool Refinement::stays_near() const {
  for (std::size_t m = 0; m < trial_.size(); ++m) {
    const std::vector<int>& route = trial_[m];
    int from = ground_->problem->members()[m].start;
    for (std::size_t i = 0; i < route.size(); from = route[i++]) {
      const bool as_before =
          i < current_[m].size() && route[i] == current_[m][i] && (i == 0 || route[i - 1] == current_[m][i - 1]);
      if (as_before || from == route[i]) continue;
      const auto& near = ground_->books[m]->actions().nearest_lookouts(from);
      if (std::ranges::find(near, route[i]) == near.end()) return false;
    }
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
