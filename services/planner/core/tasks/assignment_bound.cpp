#include "services/planner/core/tasks/assignment_bound.hpp"

#include <algorithm>
#include <utility>

namespace tandem {
namespace {

constexpr int kRounds = 1;
constexpr int kSteps = 9;
constexpr double kGolden = 0.6180339887498949;

/// Where a convex function on [0, high] is lowest, and its value there, by golden section; not on from a value of at
/// most `enough`.
template <typename Function>
std::pair<double, double> lowest_of(const Function& function, double high, double enough) {
  double low = 0.0;
  double x = high - kGolden * (high - low);
  double y = low + kGolden * (high - low);
  double of_x = function(x);
  double of_y = function(y);
  for (int i = 0; i < kSteps && std::min(of_x, of_y) > enough; ++i) {
    if (of_x <= of_y) {
      high = y;
      y = x;
      of_y = of_x;
      x = high - kGolden * (high - low);
      of_x = function(x);
    } else {
      low = x;
      x = y;
      of_x = of_y;
      y = low + kGolden * (high - low);
      of_y = function(y);
    }
  }
  return of_x <= of_y ? std::pair{x, of_x} : std::pair{y, of_y};
}

}  // namespace

/// The bound at the prices at hand.
double AssignmentBound::priced(const std::vector<PoolItems>& groups, const std::vector<double>& time_left_s) const {
  const std::size_t agents = time_left_s.size();
  double sum = 0.0;
  for (std::size_t a = 0; a < agents; ++a) sum += price_per_s_[a] * std::max(0.0, time_left_s[a]);
  for (const PoolItems& group : groups) {
    double of_group = 0.0;
    for (const PoolItem& item : group.items) {
      std::array<std::pair<double, double>, kMaxTaskAgents> gains;  // per whole pool, and share; best first
      std::size_t gainful = 0;
      for (std::size_t a = 0; a < agents; ++a) {
        const double gain = item.offers[a].value - price_per_s_[a] * item.offers[a].time_s;
        if (gain <= 0.0 || item.offers[a].share <= 0.0) continue;
        std::size_t at = gainful++;
        for (; at > 0 && gains[at - 1].first < gain; --at) gains[at] = gains[at - 1];
        gains[at] = {gain, item.offers[a].share};
      }
      double rest = item.is_limited ? 1.0 : static_cast<double>(agents);
      for (std::size_t k = 0; k < gainful && rest > 0.0; ++k) {
        const double share = std::min(rest, gains[k].second);
        of_group += share * gains[k].first;
        rest -= share;
      }
    }
    sum += std::min(of_group, group.most);
  }
  return sum;
}

double AssignmentBound::operator()(const std::vector<PoolItems>& groups, const std::vector<double>& time_left_s,
                                   double enough) {
  price_per_s_.fill(0.0);
  double best = priced(groups, time_left_s);
  double highest = 0.0;
  std::size_t items = 0;
  for (const PoolItems& group : groups) {
    items += group.items.size();
    for (const PoolItem& item : group.items) {
      for (const PoolOffer& offer : item.offers) {
        if (offer.time_s > 0.0) highest = std::max(highest, offer.value / offer.time_s);
      }
    }
  }
  if (items < 2 || best <= enough) return best;
  // One price for all first, then one agent's after the other.
  std::array<double, kMaxTaskAgents> prices{};
  const auto look_for_better = [&](std::size_t first, std::size_t last) {
    const auto at = [&](double price) {
      price_per_s_ = prices;
      std::fill(price_per_s_.begin() + static_cast<std::ptrdiff_t>(first),
                price_per_s_.begin() + static_cast<std::ptrdiff_t>(last), price);
      return priced(groups, time_left_s);
    };
    const auto [price, value] = lowest_of(at, highest, enough);
    if (value >= best) return;
    best = value;
    std::fill(prices.begin() + static_cast<std::ptrdiff_t>(first), prices.begin() + static_cast<std::ptrdiff_t>(last),
              price);
  };
  look_for_better(0, time_left_s.size());
  if (time_left_s.size() == 1) return best;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t a = 0; a < time_left_s.size() && best > enough; ++a) look_for_better(a, a + 1);
  }
  return best;
}

}  // namespace tandem
