#include "services/planner/core/team/sight_times.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem {
namespace {

/// Ten cells: even ones are first shown by visit 1 at 10 s and by visit 2 at 14 s, odd ones by visit 2 at 12 s and
/// never (100 s) by another.
SightTimes ten_cells() {
  SightTimes times(10);
  for (std::size_t cell = 0; cell < 10; ++cell) {
    const bool even = cell % 2 == 0;
    times.first[cell] = even ? 1 : 2;
    times.first_s[cell] = even ? 10.0F : 12.0F;
    times.second[cell] = even ? 2 : 0;
    times.second_s[cell] = even ? 14.0F : 100.0F;
  }
  return times;
}

struct Leg {
  std::vector<std::int32_t> cells;
  std::vector<float> enter_s;
  [[nodiscard]] LegCells view() const { return {cells.data(), enter_s.data(), cells.size()}; }
};

TEST(SightTimes, ALegTakesTheCellsThatItShowsSooner) {
  SightTimes times = ten_cells();
  Overwritten overwritten;
  const std::vector<float> mass(10, 0.5F);
  const Leg leg{{9, 8, 1}, {0.0F, 1.0F, 4.0F}};
  // From 9 s on: cell 9 3 s sooner, cell 8 at 10 s is no sooner, cell 1 at 13 s neither.
  EXPECT_FLOAT_EQ(take_sooner(leg.view(), 9.0F, 90.0F, mass, times, overwritten), 0.5F * 3.0F);
  EXPECT_FLOAT_EQ(times.first_s[9], 9.0F);
  EXPECT_FLOAT_EQ(times.first_s[8], 10.0F);
  overwritten.put_back(times.first_s);
  EXPECT_EQ(times.first_s, ten_cells().first_s);
}

TEST(SightTimes, WhatIsShownAtTheHorizonDoesNotCount) {
  SightTimes times = ten_cells();
  Overwritten overwritten;
  const Leg leg{{0, 1, 2}, {0.0F, 0.5F, 1.0F}};
  EXPECT_FLOAT_EQ(take_sooner(leg.view(), 8.0F, 8.5F, std::vector<float>(10, 1.0F), times, overwritten), 2.0F);
}

TEST(SightTimes, WithoutAVisitTheSecondToShowACellIsFirst) {
  SightTimes times = ten_cells();
  Overwritten overwritten;
  const std::vector<float> mass(10, 1.0F);
  const Leg leg{{0, 1, 2}, {0.0F, 0.5F, 1.0F}};
  EXPECT_FLOAT_EQ(take_later(leg.view(), 1, mass, times, overwritten), 8.0F);  // cells 0 and 2, 4 s each
  EXPECT_FLOAT_EQ(times.first_s[2], 14.0F);
  EXPECT_FLOAT_EQ(times.first_s[1], 12.0F);
  // A leg that shows them in between takes them from the second.
  EXPECT_FLOAT_EQ(take_sooner(leg.view(), 11.0F, 90.0F, mass, times, overwritten), 3.0F + 0.5F + 2.0F);
  overwritten.put_back(times.first_s);
  EXPECT_EQ(times.first_s, ten_cells().first_s);
}

/// One leg, cell by cell, as its description says.
double sooner_by_hand(const Leg& leg, float start_s, float horizon_s, const std::vector<float>& mass,
                      std::vector<float>& first_s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < leg.cells.size(); ++i) {
    const auto cell = static_cast<std::size_t>(leg.cells[i]);
    const float seen_s = start_s + leg.enter_s[i];
    if (seen_s >= first_s[cell] || seen_s >= horizon_s) continue;
    sum += static_cast<double>(mass[cell]) * (first_s[cell] - seen_s);
    first_s[cell] = seen_s;
  }
  return sum;
}

TEST(SightTimes, LongLegsAreSummedAsShortOnes) {
  Rng rng{3};
  for (int trial = 0; trial < 200; ++trial) {
    constexpr std::size_t kCells = 300;
    SightTimes times(kCells);
    std::vector<float> mass(kCells);
    Leg leg;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      times.first[cell] = static_cast<std::int32_t>(rng.index(4));
      times.first_s[cell] = static_cast<float>(rng.uniform(0.0, 60.0));
      times.second_s[cell] = times.first_s[cell] + static_cast<float>(rng.uniform(0.0, 20.0));
      mass[cell] = static_cast<float>(rng.uniform());
      if (rng.uniform() < 0.3) continue;
      leg.cells.push_back(static_cast<std::int32_t>(cell));
      leg.enter_s.push_back(0.01F * static_cast<float>(leg.cells.size()));
    }
    const SightTimes before = times;
    Overwritten overwritten;
    std::vector<float> first_s = before.first_s;
    const double sooner = sooner_by_hand(leg, 20.0F, 22.0F, mass, first_s);
    EXPECT_NEAR(take_sooner(leg.view(), 20.0F, 22.0F, mass, times, overwritten), sooner, 1e-4 * (1.0 + sooner));
    EXPECT_EQ(times.first_s, first_s);
    overwritten.put_back(times.first_s);
    double later = 0.0;
    for (const std::int32_t c : leg.cells) {
      const auto cell = static_cast<std::size_t>(c);
      if (before.first[cell] == 2) later += mass[cell] * (before.second_s[cell] - before.first_s[cell]);
    }
    EXPECT_NEAR(take_later(leg.view(), 2, mass, times, overwritten), later, 1e-4 * (1.0 + later));
    overwritten.put_back(times.first_s);
    EXPECT_EQ(times.first_s, before.first_s);
  }
}

}  // namespace
}  // namespace tandem
