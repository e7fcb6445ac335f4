#include "services/planner/core/team/lower_bound.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "services/planner/core/team/cell_prices.hpp"

namespace tandem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSteps = 1000;
constexpr double kRounding = 1e-9;  ///< of sums of probabilities

/// What happens whether the team walks or not.
struct Course {
  double weight = 1.0;
  int astray = -1;  ///< the member that does not follow
  std::vector<Look> fixed_looks;
};

/// A share of a cell's mass that can be bought from `in_view_s` on and is given away at `given_s`.
struct Ware {
  double mass = 0.0;
  double price_s = 0.0;
  double in_view_s = kInfinity;
  double given_s = kInfinity;
};

/// Wares by mass per price, of which one buys the best on the market: sums over powers of two (Fenwick).
class Market {
 public:
  explicit Market(std::vector<Ware> wares)
      : wares_(std::move(wares)), mass_(wares_.size() + 1, 0.0), price_s_(mass_), on_sale_(wares_.size(), false) {}

  void add(std::size_t ware) { change(ware, 1.0); }
  void remove(std::size_t ware) {
    if (on_sale_[ware]) change(ware, -1.0);
  }
  /// The most mass to be had for `budget_s`: the last ware in part.
  [[nodiscard]] double mass_for(double budget_s) const {
    double mass = 0.0;
    std::size_t at = 0;
    for (std::size_t step = std::bit_floor(wares_.size()); step > 0; step /= 2) {
      if (at + step > wares_.size() || price_s_[at + step] > budget_s) continue;
      at += step;
      budget_s -= price_s_[at];
      mass += mass_[at];
    }
    if (at < wares_.size() && on_sale_[at]) mass += wares_[at].mass * std::min(1.0, budget_s / wares_[at].price_s);
    return mass;
  }

 private:
  void change(std::size_t ware, double sign) {
    on_sale_[ware] = sign > 0.0;
    for (std::size_t i = ware + 1; i <= wares_.size(); i += i & (~i + 1)) {
      mass_[i] += sign * wares_[ware].mass;
      price_s_[i] += sign * wares_[ware].price_s;
    }
  }

  std::vector<Ware> wares_;
  std::vector<double> mass_;
  std::vector<double> price_s_;
  std::vector<bool> on_sale_;
};

/// The most that can be found of one object, as time goes on.
class Finds {
 public:
  Finds(const LegTable& table, const CellPrices& prices, const std::vector<double>& mass, const Course& course)
      : wares_(wares_of(table, prices, mass, course)), market_(wares_) {
    for (std::size_t i = 0; i < wares_.size(); ++i) {
      events_.push_back({wares_[i].in_view_s, i, false});
      events_.push_back({wares_[i].given_s, i, true});
    }
    std::ranges::sort(events_, {}, [](const Event& event) { return std::pair{event.time_s, event.is_gift}; });
  }

  /// By `time_s`, which never falls, for a budget.
  [[nodiscard]] double by(double time_s, double budget_s) {
    for (; next_ < events_.size() && events_[next_].time_s <= time_s; ++next_) {
      const Event& event = events_[next_];
      if (!event.is_gift) {
        if (!is_given_[event.ware]) market_.add(event.ware);
        continue;
      }
      market_.remove(event.ware);
      is_given_[event.ware] = true;
      given_ += wares_[event.ware].mass;
    }
    return std::min(1.0, given_ + market_.mass_for(budget_s) + kRounding);
  }

 private:
  struct Event {
    double time_s;
    std::size_t ware;
    bool is_gift;
  };

  static std::vector<Ware> wares_of(const LegTable& table, const CellPrices& prices, const std::vector<double>& mass,
                                    const Course& course);

  std::vector<Ware> wares_;
  Market market_;
  std::vector<Event> events_;
  std::vector<bool> is_given_ = std::vector<bool>(wares_.size(), false);
  std::size_t next_ = 0;
  double given_ = 0.0;
};

std::vector<Ware> Finds::wares_of(const LegTable& table, const CellPrices& prices, const std::vector<double>& mass,
                                  const Course& course) {
  struct Gift {
    std::int32_t cell;
    double time_s;
    double detected;
  };
  std::vector<Gift> gifts;
  for (const Look& look : course.fixed_looks) {
    for (std::size_t i = 0; i < look.seen->size(); ++i) {
      const double stay_s = look.seen->leave_s[i] - look.seen->enter_s[i];
      gifts.push_back({look.seen->cells[i], look.start_s + look.seen->enter_s[i],
                       std::isinf(look.rate_per_s) ? 1.0 : -std::expm1(-look.rate_per_s * stay_s)});
    }
  }
  std::ranges::sort(gifts, {}, [](const Gift& gift) { return std::pair{gift.cell, gift.time_s}; });
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  std::vector<Ware> wares;
  auto gift = gifts.begin();
  for (std::size_t cell = 0; cell < mass.size(); ++cell) {
    double left = 1.0;
    const auto add = [&](double share, double given_s) {
      if (share * mass[cell] <= 0.0) return;
      wares.push_back({share * mass[cell] / total, share * prices.price_s[cell], table.in_view_s[cell], given_s});
    };
    for (; gift != gifts.end() && static_cast<std::size_t>(gift->cell) == cell; ++gift) {
      add(left * gift->detected, gift->time_s);
      left *= 1.0 - gift->detected;
    }
    add(left, kInfinity);
  }
  std::ranges::sort(wares, std::less<>{}, [](const Ware& ware) { return ware.price_s / ware.mass; });
  return wares;
}

/// The time of the team that those who follow have for looks, on average from `from_s` to `to_s`.
double team_time_s(const CellPrices& prices, const Course& course, double from_s, double to_s) {
  double time_s = 0.0;
  for (std::size_t m = 0; m < prices.members.size(); ++m) {
    const CellPrices::Member& member = prices.members[m];
    if (static_cast<int>(m) == course.astray || to_s <= member.from_s) continue;
    const double since_s = std::max(from_s, member.from_s);
    const double share_of_step = to_s > from_s ? (to_s - since_s) / (to_s - from_s) : 1.0;
    time_s += member.ahead_s + member.share * share_of_step * (0.5 * (since_s + to_s) - member.from_s);
  }
  return time_s;
}

double bound_of_course_s(const SearchProblem& search, const LegTable& table, const CellPrices& prices,
                         const Course& course) {
  std::vector<Finds> finds;
  for (const auto& mass : search.masses) finds.emplace_back(table, prices, mass, course);
  const auto left = [&](double time_s, double budget_s) {
    double all_found = 1.0;
    for (Finds& object : finds) all_found *= object.by(time_s, budget_s);
    return 1.0 - all_found;
  };
  const double step_s = search.horizon_s / kSteps;
  double integral_s = 0.0;
  for (int step = 1; step <= kSteps; ++step) {
    // What is found grows, so cells in view at the end of a step count for all of it. Of one object it is a concave
    // function of the budget, whose mean may stand for it.
    const double to_s = step * step_s;
    const double from_s = finds.size() == 1 ? to_s - step_s : to_s;
    integral_s += step_s * left(to_s, team_time_s(prices, course, from_s, to_s));
  }
  return integral_s +
         search.tail_s * left(search.horizon_s, team_time_s(prices, course, search.horizon_s, search.horizon_s));
}

}  // namespace

double lower_bound_s(const PreparedProblem& problem) {
  const SearchProblem& search = problem.problem();
  std::vector<double> mass(search.masses.front().size(), 0.0);
  for (const auto& object : search.masses) {
    if (std::accumulate(object.begin(), object.end(), 0.0) <= 0.0) return 0.0;
    std::ranges::transform(mass, object, mass.begin(), std::plus{});
  }
  const std::vector<NearLegs> near = near_legs(problem);
  if (!std::ranges::all_of(near, &NearLegs::complete)) return 0.0;
  const LegTable table = leg_table(problem, near, mass);
  const CellPrices prices = cell_prices(problem, table, mass);

  double bound_s = 0.0;
  Course course{1.0, -1, problem.fixed_looks()};
  for (std::size_t m = 0; m < search.members.size(); ++m) {
    const SearchMember& who = search.members[m];
    for (const PathHypothesis& hypothesis : who.hypotheses) {
      const Sightings seen = sightings_along(hypothesis.path, who.pose.heading, search.world->views(who.searcher));
      Course otherwise{hypothesis.probability, static_cast<int>(m), problem.fixed_looks()};
      otherwise.fixed_looks.push_back({&seen, 0.0, search.world->searcher(who.searcher).detection_rate_per_s});
      bound_s += otherwise.weight * bound_of_course_s(search, table, prices, otherwise);
      course.weight -= otherwise.weight;
    }
  }
  return bound_s + course.weight * bound_of_course_s(search, table, prices, course);
}

}  // namespace tandem
