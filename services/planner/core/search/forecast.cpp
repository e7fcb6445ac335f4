#include "services/planner/core/search/forecast.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace tandem {
namespace {

/// For each set of agents that look at a cell: what is left after a step, and the mean of what is there during it.
struct Decay {
  std::array<double, 256> kept{};
  std::array<double, 256> mean{};
};

Decay decay_of(std::span<const AgentViews> agents, double step_s) {
  Decay decay;
  for (std::size_t set = 0; set < (std::size_t{1} << agents.size()); ++set) {
    double rate_per_s = 0.0;
    for (std::size_t a = 0; a < agents.size(); ++a) {
      if ((set >> a & 1U) != 0) rate_per_s += agents[a].detection_rate_per_s;
    }
    const double exposure = rate_per_s * step_s;
    decay.kept[set] = std::exp(-exposure);
    decay.mean[set] = exposure > 0.0 ? -std::expm1(-exposure) / exposure : 1.0;
  }
  return decay;
}

}  // namespace

Forecast SearchForecaster::forecast(const std::vector<double>& mass, std::span<const AgentViews> agents,
                                    int horizon_steps) {
  assert(agents.size() <= 8);
  const Decay decay = decay_of(agents, step_s_);
  mass_ = mass;
  seen_by_.resize(mass.size(), 0);
  const double start = std::accumulate(mass.begin(), mass.end(), 0.0);
  survival_.assign(1, 1.0);
  if (start <= 0.0) return {};
  double left = start;
  double integral_s = 0.0;
  for (std::size_t step = 0; step < static_cast<std::size_t>(horizon_steps); ++step) {
    touched_.clear();
    for (std::size_t a = 0; a < agents.size(); ++a) {
      if (step >= agents[a].steps.size() || agents[a].steps[step] == nullptr) continue;
      for (const int cell : *agents[a].steps[step]) {
        std::uint8_t& seen_by = seen_by_[static_cast<std::size_t>(cell)];
        if (seen_by == 0) touched_.push_back(cell);
        seen_by = static_cast<std::uint8_t>(seen_by | (1U << a));
      }
    }
    double mean_left = left;
    for (const int cell : touched_) {
      const auto i = static_cast<std::size_t>(cell);
      const double before = mass_[i];
      mass_[i] = before * decay.kept[seen_by_[i]];
      mean_left -= before * (1.0 - decay.mean[seen_by_[i]]);
      left -= before - mass_[i];
      seen_by_[i] = 0;
    }
    integral_s += mean_left * step_s_;
    survival_.push_back(left / start);
  }
  return {(integral_s + left * tail_s_) / start, 1.0 - left / start};
}

}  // namespace tandem
