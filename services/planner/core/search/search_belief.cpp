#include "services/planner/core/search/search_belief.hpp"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace tandem {

SearchBelief::SearchBelief(std::vector<double> prior)
    : mass_(std::move(prior)), exposure_(mass_.size(), 0.0), first_seen_by_(mass_.size(), -1) {}

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
