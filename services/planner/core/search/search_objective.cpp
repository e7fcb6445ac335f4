#include "services/planner/core/search/search_objective.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace tandem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCurveStep_s = 0.25;

/// The detection rate in one cell over time, and what is left there; walks from change to change.
class Decay {
 public:
  /// Goes on to `time_s` and gives the integral of what is left over that time.
  double advance(double time_s) {
    const double duration_s = time_s - now_s_;
    now_s_ = time_s;
    if (infinite_ > 0) {
      left_ = 0.0;
      return 0.0;
    }
    if (finite_ == 0 || left_ == 0.0) return left_ * duration_s;
    const double exposure = rate_per_s_ * duration_s;
    const double before = left_;
    left_ *= std::exp(-exposure);
    return before * -std::expm1(-exposure) / rate_per_s_;
  }
  void change(double rate_per_s) {
    if (std::isinf(rate_per_s)) {
      infinite_ += rate_per_s > 0.0 ? 1 : -1;
      if (infinite_ > 0) left_ = 0.0;
      return;
    }
    finite_ += rate_per_s > 0.0 ? 1 : -1;
    rate_per_s_ = finite_ == 0 ? 0.0 : rate_per_s_ + rate_per_s;
  }
  [[nodiscard]] double left() const { return left_; }

 private:
  double now_s_ = 0.0;
  double left_ = 1.0;
  double rate_per_s_ = 0.0;
  int finite_ = 0;    ///< agents that look
  int infinite_ = 0;  ///< of those to whom seen is found
};

}  // namespace

SearchObjective::SearchObjective(std::vector<std::vector<double>> masses, double horizon_s, double tail_s)
    : masses_(std::move(masses)), horizon_s_(horizon_s), tail_s_(tail_s) {
  assert(!masses_.empty() && horizon_s > 0.0 && tail_s >= 0.0);
  for (const auto& mass : masses_) totals_.push_back(std::accumulate(mass.begin(), mass.end(), 0.0));
  first_s_.assign(masses_.front().size(), kInfinity);
  counts_.assign(masses_.front().size(), 0);
}

Forecast SearchObjective::forecast(std::span<const Look> looks) {
  if (std::ranges::any_of(totals_, [](double total) { return total <= 0.0; })) return {};
  const bool first_sight = std::ranges::all_of(looks, [](const Look& look) { return std::isinf(look.rate_per_s); });
  if (masses_.size() == 1 && first_sight) return forecast_of_first_sight(looks);
  if (masses_.size() > 1) return forecast_of_several(looks);
  collect(looks);
  return forecast_of_one();
}

/// Sum over cells of mass times the time of first sight.
Forecast SearchObjective::forecast_of_first_sight(std::span<const Look> looks) {
  touched_.clear();
  for (const Look& look : looks) {
    const Sightings& seen = *look.seen;
    const double end_s = std::min(look.until_s, horizon_s_);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double time_s = look.start_s + seen.enter_s[i];
      if (time_s >= end_s) break;  // ascending
      double& first_s = first_s_[static_cast<std::size_t>(seen.cells[i])];
      if (first_s == kInfinity) touched_.push_back(seen.cells[i]);
      first_s = std::min(first_s, time_s);
    }
  }
  const std::vector<double>& mass = masses_.front();
  double found = 0.0;
  double saved_s = 0.0;
  for (const std::int32_t cell : touched_) {
    double& first_s = first_s_[static_cast<std::size_t>(cell)];
    found += mass[static_cast<std::size_t>(cell)];
    saved_s += mass[static_cast<std::size_t>(cell)] * (horizon_s_ + tail_s_ - first_s);
    first_s = kInfinity;
  }
  return {horizon_s_ + tail_s_ - saved_s / totals_.front(), found / totals_.front()};
}

/// Sorts what is seen by cell: a counting sort, as there are many sightings of few cells.
void SearchObjective::collect(std::span<const Look> looks) {
  touched_.clear();
  offsets_.clear();
  const auto each = [&](const auto& use) {
    for (const Look& look : looks) {
      const Sightings& seen = *look.seen;
      const double end_s = std::min(look.until_s, horizon_s_);
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const double from_s = look.start_s + seen.enter_s[i];
        if (from_s >= end_s) break;  // ascending
        use(static_cast<std::size_t>(seen.cells[i]),
            Exposure{from_s, std::min(look.start_s + seen.leave_s[i], end_s), look.rate_per_s});
      }
    }
  };
  each([&](std::size_t cell, const Exposure&) {
    if (counts_[cell]++ == 0) touched_.push_back(static_cast<std::int32_t>(cell));
  });
  std::uint32_t offset = 0;
  for (const std::int32_t cell : touched_) {
    std::uint32_t& count = counts_[static_cast<std::size_t>(cell)];
    offsets_.push_back(offset);
    offset += std::exchange(count, offset);
  }
  offsets_.push_back(offset);
  exposures_.resize(offset);
  each([&](std::size_t cell, const Exposure& exposure) { exposures_[counts_[cell]++] = exposure; });
  for (const std::int32_t cell : touched_) counts_[static_cast<std::size_t>(cell)] = 0;
}

std::span<const SearchObjective::Exposure> SearchObjective::exposures_of(std::size_t touched) const {
  return std::span{exposures_}.subspan(offsets_[touched], offsets_[touched + 1] - offsets_[touched]);
}

void SearchObjective::order_changes(std::span<const Exposure> exposures) {
  changes_.clear();
  for (const Exposure& exposure : exposures) {
    if (exposure.to_s <= exposure.from_s && !std::isinf(exposure.rate_per_s)) continue;
    changes_.push_back({exposure.from_s, exposure.rate_per_s});
    changes_.push_back({exposure.to_s, -exposure.rate_per_s});
  }
  std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    return a.time_s != b.time_s ? a.time_s < b.time_s : a.rate_per_s > b.rate_per_s;
  });
}

Forecast SearchObjective::forecast_of_one() {
  const std::vector<double>& mass = masses_.front();
  double found = 0.0;
  double saved_s = 0.0;  // against never looking
  for (std::size_t t = 0; t < touched_.size(); ++t) {
    Decay decay;
    double integral_s = 0.0;
    order_changes(exposures_of(t));
    for (const Change& change : changes_) {
      integral_s += decay.advance(change.time_s);
      decay.change(change.rate_per_s);
    }
    integral_s += decay.advance(horizon_s_);
    const double here = mass[static_cast<std::size_t>(touched_[t])];
    found += here * (1.0 - decay.left());
    saved_s += here * (horizon_s_ - integral_s + (1.0 - decay.left()) * tail_s_);
  }
  return {horizon_s_ + tail_s_ - saved_s / totals_.front(), found / totals_.front()};
}

/// P(object not found) at each step, for the exposures collected last.
std::vector<double> SearchObjective::survival_of(std::size_t object, double step_s) {
  const auto steps = static_cast<std::size_t>(std::floor(horizon_s_ / step_s + 1e-9));
  std::vector<double> found(steps + 1, 0.0);
  for (std::size_t t = 0; t < touched_.size(); ++t) {
    const double here = masses_[object][static_cast<std::size_t>(touched_[t])] / totals_[object];
    if (here == 0.0) continue;
    Decay decay;
    order_changes(exposures_of(t));
    std::size_t next = 0;
    for (std::size_t step = 0; step <= steps; ++step) {
      const double time_s = static_cast<double>(step) * step_s;
      for (; next < changes_.size() && changes_[next].time_s <= time_s; ++next) {
        decay.advance(changes_[next].time_s);
        decay.change(changes_[next].rate_per_s);
      }
      decay.advance(time_s);
      found[step] += here * (1.0 - decay.left());
    }
  }
  for (double& probability : found) probability = 1.0 - probability;
  return found;
}

std::vector<double> SearchObjective::survival(std::span<const Look> looks, double step_s) {
  if (std::ranges::any_of(totals_, [](double total) { return total <= 0.0; })) return {1.0};
  collect(looks);
  std::vector<double> all_found;
  for (std::size_t object = 0; object < masses_.size(); ++object) {
    const std::vector<double> left = survival_of(object, step_s);
    if (all_found.empty()) all_found.assign(left.size(), 1.0);
    for (std::size_t step = 0; step < left.size(); ++step) all_found[step] *= 1.0 - left[step];
  }
  for (double& probability : all_found) probability = 1.0 - probability;
  return all_found;
}

Forecast SearchObjective::forecast_of_several(std::span<const Look> looks) {
  const std::vector<double> left = survival(looks, kCurveStep_s);
  double integral_s = 0.0;
  for (std::size_t step = 1; step < left.size(); ++step) {
    integral_s += 0.5 * kCurveStep_s * (left[step - 1] + left[step]);
  }
  integral_s += left.back() * (horizon_s_ - kCurveStep_s * static_cast<double>(left.size() - 1));
  return {integral_s + left.back() * tail_s_, 1.0 - left.back()};
}

}  // namespace tandem
