#include "services/planner/core/team/cell_prices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

Searcher sharp(double speed_mps) {
  Searcher person = test_person();
  person.detection_rate_per_s = std::numeric_limits<double>::infinity();
  person.view_max_m = 1.0;
  person.speed_mps = speed_mps;
  return person;
}

SearchCase random_case(Rng& rng, std::vector<Searcher> searchers) {
  std::vector<std::string> drawing(14, "#" + std::string(18, '.') + "#");
  drawing.front() = drawing.back() = std::string(20, '#');
  for (int column = 0; column < 10; ++column) drawing[1 + rng.index(12)][5 + rng.index(14)] = '#';
  SearchCase search(room(drawing), {1.5, 1.5}, std::move(searchers), 1.0);
  for (double& mass : search.problem.masses.front()) mass *= rng.uniform() < 0.3 ? 0.0 : rng.uniform();
  // Nothing near the start: the first legs show nothing at first.
  for (int cell = 0; rng.uniform() < 0.7 && cell < search.world().area().size(); ++cell) {
    if (search.world().area().point(cell).x() < 4.0)
      search.problem.masses.front()[static_cast<std::size_t>(cell)] = 0.0;
  }
  return search;
}

struct Priced {
  explicit Priced(const SearchProblem& problem)
      : prepared(problem),
        table(leg_table(prepared, near_legs(prepared), problem.masses.front())),
        prices(cell_prices(prepared, table, problem.masses.front())) {}
  PreparedProblem prepared;
  LegTable table;
  CellPrices prices;
};

std::vector<int> random_walk(const PreparedProblem::Member& member, double until_s, Rng& rng) {
  std::vector<int> route;
  double time_s = member.start_s;
  for (int place = member.start; time_s < until_s;) {
    const auto near = member.actions->near_lookouts(place);
    route.push_back(near[rng.index(near.size())]);
    time_s += std::max(0.1, member.actions->leg(place, route.back()).duration_s);
    place = route.back();
  }
  return route;
}

/// The price of what the looks detect until `time_s`.
double looked_at_s(const std::vector<Look>& looks, const std::vector<double>& price_s, double time_s) {
  std::vector<double> exposure(price_s.size(), 0.0);
  for (const Look& look : looks) {
    for (std::size_t i = 0; i < look.seen->size(); ++i) {
      const double from_s = look.start_s + look.seen->enter_s[i];
      const double to_s = std::min({time_s, look.until_s, look.start_s + look.seen->leave_s[i]});
      if (to_s > from_s) exposure[static_cast<std::size_t>(look.seen->cells[i])] += look.rate_per_s * (to_s - from_s);
    }
  }
  double sum_s = 0.0;
  for (std::size_t cell = 0; cell < price_s.size(); ++cell) sum_s += price_s[cell] * -std::expm1(-exposure[cell]);
  return sum_s;
}

/// The team of a robot that turns and two people, who differ in whether a look may miss the object.
SearchCase random_team(Rng& rng, std::uint64_t seed) {
  Searcher robot = test_robot();
  robot.view_max_m = 2.0;
  if (seed % 3 == 0) robot.detection_rate_per_s = std::numeric_limits<double>::infinity();
  return random_case(rng, {sharp(rng.uniform(0.5, 1.5)), test_person(), robot});
}

/// All pieces of walks of one capability, each checked against its time.
class Pieces {
 public:
  Pieces(SearchCase& search, const Priced& priced, const NearLegs& near)
      : near_(near),
        views_(search.world().views(near.searcher)),
        price_s_(priced.prices.price_s),
        member_(priced.prices.members[near.members.front()]),
        finds_(std::isinf(near.actions->searcher().detection_rate_per_s)),
        seen_(price_s_.size(), false) {}

  void check() {
    const double far_m = kPieceOfViews * near_.actions->searcher().view_max_m;
    for (std::size_t place = 0; place < near_.earliest_s.size(); ++place) {
      if (std::isinf(near_.earliest_s[place])) continue;
      const std::vector<std::size_t> before = see_on_arrival(static_cast<int>(place));
      go_on(static_cast<int>(place), near_.earliest_s[place], near_.earliest_s[place], 0.0, 1,
            finds_ ? far_m / near_.actions->searcher().speed_mps : 0.0);
      for (const std::size_t cell : before) seen_[cell] = false;
    }
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  std::vector<std::size_t> see_on_arrival(int place) {
    std::vector<std::size_t> cells;
    if (!finds_ || !near_.actions->searcher().sees_all_around()) return cells;
    const Eigen::Vector2d& point = near_.actions->place(place);
    for (const std::int32_t cell : sightings_of_stay({point.x(), point.y(), 0.0}, views_).cells) {
      if (see(cell)) cells.push_back(static_cast<std::size_t>(cell));
    }
    return cells;
  }
  bool see(std::int32_t cell) {
    const bool is_new = !seen_[static_cast<std::size_t>(cell)];
    seen_[static_cast<std::size_t>(cell)] = true;
    return is_new;
  }
  /// What the leg shows of cells that the piece has not shown before.
  double shown_s(const Leg& leg, std::vector<std::size_t>& cells) {
    if (!finds_) return looked_at_s({{&leg.seen, 0.0, near_.actions->searcher().detection_rate_per_s}}, price_s_, 1e9);
    double sum_s = 0.0;
    for (const Sightings* sightings : {&leg.seen, &leg.stay}) {
      for (const std::int32_t cell : sightings->cells) {
        if (!see(cell)) continue;
        cells.push_back(static_cast<std::size_t>(cell));
        sum_s += price_s_[static_cast<std::size_t>(cell)];
      }
    }
    return sum_s;
  }
  void go_on(int place, double begin_s, double time_s, double shown, std::size_t legs, double length_s) {
    for (const NearLegs::Entry& entry : near_.legs) {
      if (entry.from != place) continue;
      std::vector<std::size_t> cells;
      const double all_s = shown + shown_s(*entry.leg, cells);
      const double end_s = time_s + entry.leg->duration_s;
      const double paid_s = member_.share * std::max(0.0, end_s - std::max(begin_s, member_.from_s));
      // Time in which nothing can be in view yet is no part of a piece.
      if (legs == kMostLegsOfPiece || end_s - std::max(begin_s, member_.from_s) >= length_s) {
        ++count_;
        EXPECT_LE(all_s, paid_s + 1e-6) << "from " << place << ", " << legs << " legs";
      } else {
        EXPECT_LE(all_s, paid_s + member_.ahead_s) << "from " << place << ", " << legs << " legs";
        go_on(entry.to, begin_s, end_s, all_s, legs + 1, length_s);
      }
      for (const std::size_t cell : cells) seen_[cell] = false;
    }
  }

  const NearLegs& near_;
  ViewTable& views_;
  const std::vector<double>& price_s_;
  const CellPrices::Member& member_;
  bool finds_;
  std::vector<bool> seen_;
  int count_ = 0;
};

TEST(CellPrices, NoPieceOfAWalkShowsMoreThanItsTimePaysFor) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Rng rng{seed};
    SearchCase search = random_team(rng, seed);
    const Priced priced(search.problem);
    for (const NearLegs& near : near_legs(priced.prepared)) {
      SCOPED_TRACE("world " + std::to_string(seed));
      Pieces pieces(search, priced, near);
      pieces.check();
      EXPECT_GT(pieces.count(), 0);
    }
  }
}

TEST(CellPrices, NoPieceOfAWalkThroughAHallWithColumnsShowsMoreThanItsTimePaysFor) {
  Searcher person = sharp(1.0);
  person.view_max_m = 2.0;
  std::vector<std::string> drawing(18, "#" + std::string(24, '.') + "#");
  drawing.front() = drawing.back() = std::string(26, '#');
  for (const std::size_t row : {4U, 5U, 11U, 12U}) {
    for (const std::size_t column : {6U, 7U, 13U, 14U, 20U}) drawing[row][column] = '#';
  }
  SearchCase search(room(drawing), {1.5, 1.5}, {person}, 1.6);
  const Priced priced(search.problem);
  const std::vector<NearLegs> near = near_legs(priced.prepared);
  Pieces pieces(search, priced, near.front());
  pieces.check();
  EXPECT_GT(pieces.count(), 100);
}

TEST(CellPrices, ToTurnShowsNoMoreThanItsTimePaysFor) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    if (seed % 3 == 0) continue;
    Rng rng{seed};
    SearchCase search = random_team(rng, seed);
    const Priced priced(search.problem);
    const NearLegs near = near_legs(priced.prepared).back();
    const double rate_per_s = near.actions->searcher().detection_rate_per_s;
    for (const NearLegs::Entry& entry : near.legs) {
      EXPECT_LE(looked_at_s({{&entry.leg->stay, 0.0, rate_per_s}}, priced.prices.price_s, 1e-3),
                1e-3 * priced.prices.members.back().share + 1e-9);
    }
  }
}

TEST(CellPrices, NoWalkEverLooksAtMoreThanItsTimePaysFor) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng{seed};
    SearchCase search = random_team(rng, seed);
    const Priced priced(search.problem);
    for (int i = 0; i < 12; ++i) {
      const auto m = static_cast<std::size_t>(i % 3);
      const CellPrices::Member& member = priced.prices.members[m];
      std::vector<Look> looks;
      priced.prepared.add_looks(m, random_walk(priced.prepared.members()[m], 30.0, rng), looks);
      for (double time_s = 0.1; time_s < 30.0; time_s += 0.1) {
        const double paid_s = time_s <= member.from_s ? 0.0 : member.share * (time_s - member.from_s) + member.ahead_s;
        ASSERT_LE(looked_at_s(looks, priced.prices.price_s, time_s), paid_s + 1e-6)
            << "world " << seed << ", member " << m << ", " << time_s << " s";
      }
    }
  }
}

TEST(CellPrices, NearlyEachCellLiesOnALegThatLeavesLittleOver) {
  Rng rng{1};
  SearchCase search = random_case(rng, {sharp(1.0)});
  const Priced priced(search.problem);
  std::vector<double> highest(priced.prices.price_s.size(), 0.0);
  for (const LegTable::Row& row : priced.table.rows) {
    double shown_s = 0.0;
    double load = 0.0;
    for (std::size_t i = row.begin; i < row.end; ++i) {
      shown_s += priced.prices.price_s[static_cast<std::size_t>(priced.table.cells[i])];
      load = std::max(load, shown_s - priced.table.time_s[i] > 0.9 * priced.prices.members[0].ahead_s ? 1.0 : 0.0);
    }
    load = std::max(load, shown_s / row.budget_s);
    for (std::size_t i = row.begin; i < row.end; ++i) {
      double& cell = highest[static_cast<std::size_t>(priced.table.cells[i])];
      cell = std::max(cell, load);
    }
  }
  std::size_t priced_cells = 0;
  std::size_t bound_cells = 0;
  for (std::size_t cell = 0; cell < highest.size(); ++cell) {
    if (priced.prices.price_s[cell] <= 0.0) continue;
    ++priced_cells;
    if (highest[cell] > 0.8) ++bound_cells;
  }
  EXPECT_GT(static_cast<double>(bound_cells), 0.8 * static_cast<double>(priced_cells));
}

TEST(CellPrices, WhatIsInViewAtTheStartCostsNothing) {
  SearchCase search(empty_room(8, 6), {3.25, 3.25}, {sharp(1.0)}, 0.8);
  const Priced priced(search.problem);
  const auto price_at_s = [&](double x, double y) {
    return priced.prices.price_s[static_cast<std::size_t>(*search.world().area().cell_at({x, y}))];
  };
  EXPECT_DOUBLE_EQ(price_at_s(3.25, 3.25), 0.0);
  EXPECT_DOUBLE_EQ(price_at_s(3.75, 3.25), 0.0);
  EXPECT_GT(price_at_s(6.25, 3.25), 0.0);
}

}  // namespace
}  // namespace tandem
