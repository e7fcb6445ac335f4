#include "services/planner/core/baselines/lawnmower_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace tandem {
namespace {

using Eigen::Vector2d;

/// Unseen cells in the order of mowing.
struct Field {
  std::vector<int> cells;
  std::vector<double> share;  ///< per search cell: how much of the work is done in its middle, (0, 1); -1 if seen
};

double lane_width_m(const PreparedProblem& problem) {
  double width_m = std::numeric_limits<double>::infinity();
  for (const auto& member : problem.members()) {
    width_m = std::min(width_m, 2.0 * member.actions->searcher().view_max_m);
  }
  return width_m;
}

Field field_of(const PreparedProblem& problem, const TeamWalk& walk) {
  const SearchArea& area = problem.problem().world->area();
  Field field;
  std::vector<int> unseen;
  std::vector<Vector2d> points;
  for (int cell = 0; cell < area.size(); ++cell) {
    if (!walk.counts(walk.mass()[static_cast<std::size_t>(cell)])) continue;
    unseen.push_back(cell);
    points.push_back(area.point(cell));
  }
  field.share.assign(walk.mass().size(), -1.0);
  for (const int index : mowing_order(points, lane_width_m(problem))) {
    const int cell = unseen[static_cast<std::size_t>(index)];
    field.share[static_cast<std::size_t>(cell)] =
        (static_cast<double>(field.cells.size()) + 0.5) / static_cast<double>(unseen.size());
    field.cells.push_back(cell);
  }
  return field;
}

/// The share of the work at which each piece begins, and 1, when the members take pieces in the order `members`.
std::vector<double> piece_starts(const PreparedProblem& problem, const std::vector<int>& members) {
  std::vector<double> starts{0.0};
  for (const int m : members) {
    const PreparedProblem::Member& who = problem.members()[static_cast<std::size_t>(m)];
    const Searcher& searcher = who.actions->searcher();
    const double time_s = who.start < 0 ? 0.0 : std::max(0.0, who.end_s - who.start_s);
    starts.push_back(starts.back() + time_s * searcher.speed_mps * searcher.view_max_m);
  }
  const double sum = starts.back();
  for (double& start : starts) start = sum > 0.0 ? start / sum : 1.0;
  return starts;
}

/// The order of members along the field with the shortest walks to their pieces.
std::vector<int> nearest_order(const PreparedProblem& problem, const Field& field) {
  const SearchArea& area = problem.problem().world->area();
  const auto point_at = [&](double share) {
    const auto index = static_cast<std::size_t>(share * static_cast<double>(field.cells.size()));
    return area.point(field.cells[std::min(index, field.cells.size() - 1)]);
  };
  std::vector<int> members(problem.members().size());
  std::iota(members.begin(), members.end(), 0);
  std::vector<int> best;
  double best_m = std::numeric_limits<double>::infinity();
  do {
    const auto starts = piece_starts(problem, members);
    double walked_m = 0.0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const PreparedProblem::Member& who = problem.members()[static_cast<std::size_t>(members[k])];
      if (who.start < 0) continue;
      const Vector2d& from = who.actions->place(who.start);
      walked_m += std::min((point_at(starts[k]) - from).norm(), (point_at(starts[k + 1]) - from).norm());
    }
    if (walked_m >= best_m) continue;
    best_m = walked_m;
    best = members;
  } while (std::ranges::next_permutation(members).found);
  return best;
}

/// The lookouts of one piece in the order of mowing, from the end that `member` is nearer to.
std::vector<int> lane_of(const PreparedProblem& problem, const Field& field, int member, double from_share,
                         double to_share) {
  const SearchArea& area = problem.problem().world->area();
  const PreparedProblem::Member& who = problem.members()[static_cast<std::size_t>(member)];
  if (who.start < 0) return {};
  std::vector<std::pair<double, int>> order;
  for (int lookout = 0; lookout < who.actions->lookouts(); ++lookout) {
    // It belongs where the unseen cell nearest to it lies.
    double nearest_m = std::numeric_limits<double>::infinity();
    double share = -1.0;
    for (const int cell : who.actions->panorama(lookout)) {
      const double distance_m = (area.point(cell) - who.actions->place(lookout)).norm();
      if (field.share[static_cast<std::size_t>(cell)] < 0.0 || distance_m >= nearest_m) continue;
      nearest_m = distance_m;
      share = field.share[static_cast<std::size_t>(cell)];
    }
    if (share >= from_share && share < to_share) order.emplace_back(share, lookout);
  }
  std::ranges::sort(order);
  std::vector<int> lane;
  for (const auto& [share, lookout] : order) lane.push_back(lookout);
  if (lane.empty()) return lane;
  const Vector2d& from = who.actions->place(who.start);
  const auto walk_m = [&](int lookout) { return (who.actions->place(lookout) - from).norm(); };
  if (walk_m(lane.back()) < walk_m(lane.front())) std::ranges::reverse(lane);
  return lane;
}

}  // namespace

std::vector<int> mowing_order(const std::vector<Vector2d>& points, double lane_width_m) {
  if (points.empty()) return {};
  Vector2d low = points.front();
  Vector2d high = points.front();
  for (const Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Index along = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
  std::vector<std::tuple<int, double, double, int>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int lane = static_cast<int>(std::floor((points[i](1 - along) - low(1 - along)) / lane_width_m));
    const double forward_m = lane % 2 == 0 ? points[i](along) : -points[i](along);
    order.emplace_back(lane, forward_m, points[i](1 - along), static_cast<int>(i));
  }
  std::ranges::sort(order);
  std::vector<int> indices;
  for (const auto& entry : order) indices.push_back(std::get<3>(entry));
  return indices;
}

Routes lawnmower_routes(const PreparedProblem& problem) {
  TeamWalk walk(problem, 1);
  const Field field = field_of(problem, walk);
  if (field.cells.empty()) return walk.routes();
  const std::vector<int> order = nearest_order(problem, field);
  const std::vector<double> starts = piece_starts(problem, order);
  std::vector<std::vector<int>> ahead(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    ahead[static_cast<std::size_t>(order[k])] = lane_of(problem, field, order[k], starts[k], starts[k + 1]);
  }
  std::vector<std::size_t> next(order.size(), 0);
  for (int member = walk.next_member(); member >= 0; member = walk.next_member()) {
    const auto m = static_cast<std::size_t>(member);
    const auto is_worth_going = [&](int lookout) {
      return walk.counts(walk.mass_around(member, lookout)) && walk.option(member, lookout).time_s > 0.0;
    };
    while (next[m] < ahead[m].size() && !is_worth_going(ahead[m][next[m]])) ++next[m];
    if (const auto& goal = problem.members()[m].goal) {
      walk.go(member, *goal);
    } else if (next[m] < ahead[m].size()) {
      walk.go(member, ahead[m][next[m]]);
    } else {
      walk.stay(member);
    }
  }
  return walk.routes();
}

}  // namespace tandem
