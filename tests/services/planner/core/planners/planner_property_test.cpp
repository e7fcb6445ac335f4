// Laws that every planner of the registry keeps (digest, section 3).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "services/planner/core/planners/registry.hpp"
#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr int kRollouts = 40;

/// The planner of this name; trees of the paper's planner are kept small, as there are many plans to be made.
std::unique_ptr<Planner> small_planner(const std::string& name, const std::string& option = "") {
  const std::string nodes = name.starts_with("paper") ? "nodes=400,goal_nodes=100" : "";
  const std::string options = nodes + (nodes.empty() || option.empty() ? "" : ",") + option;
  return make_planner(options.empty() ? name : name + ":" + options);
}

class EveryPlanner : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] JointPlan plan(const SearchProblem& problem, std::uint64_t seed = 1) const {
    return plan_with(*small_planner(GetParam()), problem, kRollouts, seed);
  }
};

/// A hall with pillars.
std::vector<std::string> hall_drawing(std::uint64_t seed) {
  Rng rng{seed};
  std::vector<std::string> drawing(20, "#" + std::string(28, '.') + "#");
  drawing.front() = drawing.back() = std::string(30, '#');
  for (int pillar = 0; pillar < 8; ++pillar) drawing[1 + rng.index(12)][8 + rng.index(20)] = '#';
  return drawing;
}

/// In it everywhere as likely as chance says: no two choices are worth the same.
SearchCase hall(std::uint64_t seed, std::vector<Searcher> searchers = {test_robot(), test_person()}) {
  Rng rng{seed};
  SearchCase search(room(hall_drawing(seed)), {2, 2}, std::move(searchers));
  for (double& mass : search.problem.masses.front()) mass *= rng.uniform();
  search.problem.horizon_s = 60.0;
  return search;
}

void expect_same(const JointPlan& a, const JointPlan& b, const std::string& what) {
  ASSERT_EQ(a.paths.size(), b.paths.size()) << what;
  for (std::size_t m = 0; m < a.paths.size(); ++m) {
    ASSERT_EQ(a.paths[m].points.size(), b.paths[m].points.size()) << what << ", member " << m;
    for (std::size_t i = 0; i < a.paths[m].points.size(); ++i) {
      EXPECT_EQ(a.paths[m].points[i].time_s, b.paths[m].points[i].time_s) << what;
      EXPECT_EQ(a.paths[m].points[i].point_in_map, b.paths[m].points[i].point_in_map) << what;
    }
  }
}

TEST_P(EveryPlanner, T24GoesTheSameRoutesHoweverTheMassesAreScaled) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SearchCase search = hall(seed);
    const JointPlan as_it_is = plan(search.problem);
    const std::vector<double> mass = search.problem.masses.front();
    for (const double scale : {0x1p-20, 0x1p20}) {  // powers of two, so that every rounding stays the same
      std::ranges::transform(mass, search.problem.masses.front().begin(), [&](double one) { return scale * one; });
      expect_same(plan(search.problem), as_it_is, "seed " + std::to_string(seed));
    }
  }
}

/// The plan of a planner that has planned `before` on the same world, then `change` happens to it.
template <typename Change>
void expect_as_from_fresh(const std::string& name, const Change& change, const std::string& what) {
  SearchCase used = hall(1);
  const auto planner = small_planner(name);
  (void)plan_with(*planner, used.problem, kRollouts, 3);
  change(used);
  SearchCase fresh = hall(1);
  change(fresh);
  expect_same(plan_with(*planner, used.problem, kRollouts, 1),
              plan_with(*small_planner(name), fresh.problem, kRollouts, 1), what);
}

TEST_P(EveryPlanner, T23APlanAfterAChangeIsThePlanOfTheWorldAsItIsThen) {
  const std::string& name = GetParam();
  const std::vector<BlockedDisc> hole{{Vector2d{6.0, 3.0}, 1.0}};
  const auto block = [](SearchCase& search, const std::vector<BlockedDisc>& discs) {
    for (const int who : {0, 1}) search.world().block(who, discs, {2, 2});
  };
  expect_as_from_fresh(
      name, [&](SearchCase& search) { block(search, hole); }, "a place to avoid is drawn");
  expect_as_from_fresh(
      name, [](SearchCase& search) { search.problem.members[0].battery_s = 15.0; }, "a battery gets empty");
  expect_as_from_fresh(
      name,
      [](SearchCase& search) {
        search.problem.members[1].pose = {11.0, 6.0, 1.0};
      },
      "the person is elsewhere");
  expect_as_from_fresh(
      name,
      [](SearchCase& search) {
        const SearchArea& area = search.world().area();
        for (int cell = 0; cell < area.size(); ++cell) {
          if (area.point(cell).x() > 8.0) search.problem.masses.front()[static_cast<std::size_t>(cell)] *= 10.0;
        }
      },
      "it is likely on the right");

  SearchCase never = hall(1);
  SearchCase removed = hall(1);
  block(removed, hole);
  (void)plan(removed.problem);
  block(removed, {});
  expect_same(plan(removed.problem), plan(never.problem), "what was drawn is removed");
}

TEST_P(EveryPlanner, T23NobodyGoesOnWhenTheirBatteryIsEmptyAndTheOtherDoes) {
  SearchCase search = hall(1);
  search.problem.members[0].battery_s = 12.0;
  const JointPlan two = plan(search.problem);
  EXPECT_LE(two.paths[0].duration_s(), 12.0 + 1e-9);
  EXPECT_GT(two.paths[1].duration_s(), 12.0);
  EXPECT_DOUBLE_EQ(two.value_s, evaluated(search.problem, two.paths).value_s);
  search.problem.members[0].battery_s = 0.0;
  const JointPlan one = plan(search.problem);
  EXPECT_EQ(one.paths[0].duration_s(), 0.0);
  EXPECT_GT(one.forecast.probability_found, 0.1);
}

TEST_P(EveryPlanner, T23WhatOneDoesNotReachAnyMoreIsLeftToTheOther) {
  // All of it lies 5.5 m ahead; at 1 m/s the first one gets 1 m far.
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.0, 10.25, 1.0);
  search.problem.members[0].battery_s = 1.0;
  EXPECT_DOUBLE_EQ(plan(search.problem).forecast.probability_found, 1.0);
}

/// The hall with everybody so many times as fast, and their sight too.
SearchCase hall_at_speed(double factor) {
  Searcher robot = test_robot();
  Searcher person = test_person();
  for (Searcher* who : {&robot, &person}) {
    who->speed_mps *= factor;
    who->turn_rate_radps *= factor;
    who->detection_rate_per_s *= factor;
  }
  SearchCase search = hall(1, {robot, person});
  search.problem.horizon_s /= factor;
  search.problem.tail_s /= factor;
  return search;
}

TEST_P(EveryPlanner, T24TwiceAsFastItTakesHalfTheTime) {
  const SearchCase slow = hall_at_speed(1.0);
  const SearchCase fast = hall_at_speed(2.0);
  const JointPlan a = plan(slow.problem);
  const std::string dearer_time = GetParam() == "paper_travel" ? "travel_cost=0.004" : "";
  const JointPlan b = plan_with(*small_planner(GetParam(), dearer_time), fast.problem, kRollouts, 1);
  EXPECT_NEAR(b.forecast.expected_time_s, 0.5 * a.forecast.expected_time_s, 1e-9);
  for (std::size_t m = 0; m < a.paths.size(); ++m) {
    ASSERT_EQ(a.paths[m].points.size(), b.paths[m].points.size()) << m;
    for (std::size_t i = 0; i < a.paths[m].points.size(); ++i) {
      EXPECT_NEAR(b.paths[m].points[i].time_s, 0.5 * a.paths[m].points[i].time_s, 1e-9);
      EXPECT_EQ(b.paths[m].points[i].point_in_map, a.paths[m].points[i].point_in_map);
    }
  }
}

/// A way to look at a map: in a mirror, or turned a quarter to the left.
enum class Symmetry { Mirrored, Turned };

std::vector<std::string> seen(Symmetry symmetry, const std::vector<std::string>& drawing) {
  std::vector<std::string> lines = drawing;
  if (symmetry == Symmetry::Mirrored) {
    for (std::string& line : lines) std::ranges::reverse(line);
    return lines;
  }
  lines.assign(drawing.front().size(), std::string(drawing.size(), ' '));
  for (std::size_t row = 0; row < drawing.size(); ++row) {
    for (std::size_t column = 0; column < drawing[row].size(); ++column) {
      lines[lines.size() - 1 - column][row] = drawing[row][column];
    }
  }
  return lines;
}

/// A point on a map of this drawing.
Vector2d seen(Symmetry symmetry, const std::vector<std::string>& drawing, const Vector2d& point) {
  constexpr double kSign_m = 0.5;
  if (symmetry == Symmetry::Mirrored) {
    return {kSign_m * static_cast<double>(drawing.front().size()) - point.x(), point.y()};
  }
  return {kSign_m * static_cast<double>(drawing.size()) - point.y(), point.x()};
}

/// A search on a map of this drawing, looked at this way.
SearchCase seen(Symmetry symmetry, const std::vector<std::string>& drawing, SearchCase& search,
                double lookout_range_m) {
  const Vector2d start = search.problem.members.front().pose.position();
  SearchCase there(room(seen(symmetry, drawing)), seen(symmetry, drawing, start), search.world().searchers(),
                   lookout_range_m);
  for (int cell = 0; cell < search.world().area().size(); ++cell) {
    const Vector2d point = seen(symmetry, drawing, search.world().area().point(cell));
    there.problem.masses.front()[static_cast<std::size_t>(there.world().area().cell_at(point).value())] =
        search.problem.masses.front()[static_cast<std::size_t>(cell)];
  }
  for (SearchMember& member : there.problem.members) {
    member.pose.heading = symmetry == Symmetry::Mirrored ? std::numbers::pi : 0.5 * std::numbers::pi;
  }
  there.problem.horizon_s = search.problem.horizon_s;
  return there;
}

TEST_P(EveryPlanner, T24APlanSeenInAMirrorOrTurnedIsWorthTheSame) {
  const auto drawing = hall_drawing(1);
  SearchCase search = hall(1);
  const JointPlan here = plan(search.problem);
  for (const Symmetry symmetry : {Symmetry::Mirrored, Symmetry::Turned}) {
    std::vector<TimedPath> paths = here.paths;
    for (TimedPath& path : paths) {
      for (TimedPoint& point : path.points) point.point_in_map = seen(symmetry, drawing, point.point_in_map);
    }
    // Ways along the border of two search cells are in the upper or right one: in the other one, seen in a mirror.
    const double border_s = 0.02 * here.value_s;
    EXPECT_NEAR(evaluated(seen(symmetry, drawing, search, 2.5).problem, paths).value_s, here.value_s, border_s);
  }
}

/// Whether `path` comes within sight of `one` before it does of `other`.
bool comes_first(const TimedPath& path, const Vector2d& one, const Vector2d& other) {
  for (double time_s = 0.0; time_s <= path.duration_s(); time_s += 0.1) {
    const Vector2d at = pose_at(path, time_s).position();
    if ((at - one).norm() < 0.7) return true;
    if ((at - other).norm() < 0.7) return false;
  }
  return false;
}

TEST_P(EveryPlanner, T24InAMirrorOrTurnedItFindsTheSameInTheSameOrder) {
  const Vector2d kLeft{2.75, 1.0};
  const Vector2d kRight{10.25, 1.0};
  const bool is_paper = GetParam().starts_with("paper");
  std::vector<std::string> drawing(4, "#" + std::string(24, '.') + "#");
  drawing.front() = drawing.back() = std::string(26, '#');
  SearchCase search = corridor(1);
  place_mass(search, kLeft.x(), 0.1, kRight.x(), 0.9);
  search.problem.horizon_s = 30.0;
  const JointPlan here = plan(search.problem);
  for (const Symmetry symmetry : {Symmetry::Mirrored, Symmetry::Turned}) {
    SearchCase there = seen(symmetry, drawing, search, 0.6);
    const JointPlan found = plan(there.problem);
    // A lookout lies up to 0.6 m before its place or behind it, there and back.
    EXPECT_NEAR(found.value_s, here.value_s, 2.0 * 2.0 * 0.6);
    if (is_paper) continue;  // its plans are worth the same to it in any order
    EXPECT_EQ(comes_first(found.paths[0], seen(symmetry, drawing, kLeft), seen(symmetry, drawing, kRight)),
              comes_first(here.paths[0], kLeft, kRight));
  }
}

INSTANTIATE_TEST_SUITE_P(EachByName, EveryPlanner, ::testing::ValuesIn(planner_names()),
                         [](const auto& named) { return named.param; });

}  // namespace
}  // namespace tandem
