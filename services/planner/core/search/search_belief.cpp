#include "services/planner/core/search/search_belief.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace tandem {

SearchBelief::SearchBelief(std::vector<double> prior)
    : prior_(std::move(prior)),
      weight_(prior_.size(), 1.0),
      mass_(prior_),
      exposure_(prior_.size(), 0.0),
      first_seen_by_(prior_.size(), -1) {}

void SearchBelief::look(std::size_t agent, const View& view, double detection_rate_per_s, double duration_s) {
  assert(duration_s >= 0.0);
  if (duration_s == 0.0) return;
  const double kept = std::exp(-detection_rate_per_s * duration_s);
  for (const int cell : view) {
    const auto i = static_cast<std::size_t>(cell);
    mass_[i] *= kept;
    exposure_[i] += detection_rate_per_s * duration_s;
    if (first_seen_by_[i] < 0) first_seen_by_[i] = static_cast<int>(agent);
  }
}

void SearchBelief::weigh(const std::vector<int>& cells, double weight) {
  assert(weight > 0.0);
  for (const int cell : cells) weight_[static_cast<std::size_t>(cell)] = weight;
  renew_mass();
}

void SearchBelief::claim_look(std::size_t agent, const std::vector<int>& cells, double exposure) {
  for (const int cell : cells) {
    const auto i = static_cast<std::size_t>(cell);
    exposure_[i] = std::max(exposure_[i], exposure);
    if (first_seen_by_[i] < 0) first_seen_by_[i] = static_cast<int>(agent);
  }
  renew_mass();
}

void SearchBelief::look_again(const std::vector<int>& cells) {
  for (const int cell : cells) {
    const auto i = static_cast<std::size_t>(cell);
    exposure_[i] = 0.0;
    first_seen_by_[i] = -1;
    weight_[i] = std::max(weight_[i], 1.0);
  }
  renew_mass();
}

void SearchBelief::renew_mass() {
  const double sum = std::inner_product(prior_.begin(), prior_.end(), weight_.begin(), 0.0);
  if (!(sum > 0.0)) return;
  for (std::size_t i = 0; i < mass_.size(); ++i) mass_[i] = prior_[i] * weight_[i] / sum * std::exp(-exposure_[i]);
}

double SearchBelief::probability_left() const {
  return std::accumulate(mass_.begin(), mass_.end(), 0.0);
}

std::vector<double> SearchBelief::posterior() const {
  std::vector<double> posterior = mass_;
  const double sum = probability_left();
  if (sum > 0.0) {
    for (double& probability : posterior) probability /= sum;
  }
  return posterior;
}

bool SearchBelief::is_explored(int cell, double probability) const {
  return -std::expm1(-exposure(cell)) >= probability;
}

ExploredShares explored_shares(const SearchArea& area, const SearchBelief& belief, std::size_t agents,
                               double probability) {
  ExploredShares shares;
  shares.by_agent.assign(agents, 0.0);
  if (area.area_m2() <= 0.0) return shares;
  for (int cell = 0; cell < area.size(); ++cell) {
    const int agent = belief.first_seen_by(cell);
    if (agent < 0 || !belief.is_explored(cell, probability)) continue;
    const double share = area.floor_m2(cell) / area.area_m2();
    shares.all += share;
    shares.by_agent[static_cast<std::size_t>(agent)] += share;
  }
  return shares;
}

}  // namespace tandem
