#include "services/planner/remote/remote_messages.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "services/mapping/core/ray_casting.hpp"
#include "services/planner/remote/remote_planner.hpp"

namespace tandem::remote {
namespace {

using Eigen::Vector2d;
using nlohmann::json;

constexpr double kStartTolerance_m = 0.05;
constexpr double kSpeedTolerance = 1.01;

json point(const Vector2d& p) {
  return json::array({p.x(), p.y()});
}

json finite_or_null(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json timed_points(const TimedPath& path) {
  json points = json::array();
  for (const TimedPoint& p : path.points) points.push_back({p.time_s, p.point_in_map.x(), p.point_in_map.y()});
  return points;
}

json layer(const OccupancyGrid& map) {
  json rows = json::array();
  for (int row = 0; row < map.height(); ++row) {
    std::string text;
    for (int column = 0; column < map.width(); ++column) {
      const CellState cell = map.at(CellIndex{column, row});
      text += cell == CellState::Free ? '.' : cell == CellState::Occupied ? '#' : '?';
    }
    rows.push_back(text);
  }
  const Pose2& corner = map.map_from_grid();
  return {
      {"resolution_m", map.resolution_m()}, {"corner_in_map", {corner.x, corner.y, corner.heading}}, {"rows", rows}};
}

json member_json(const SearchMember& member, const Searcher& searcher) {
  return {{"id", searcher.id},
          {"pose", {member.pose.x, member.pose.y, member.pose.heading}},
          {"speed_mps", searcher.speed_mps},
          {"turn_rate_radps", searcher.turn_rate_radps},
          {"radius_m", searcher.radius_m},
          {"view_max_m", searcher.view_max_m},
          {"field_of_view_rad", searcher.field_of_view_rad},
          {"detection_rate_per_s", finite_or_null(searcher.detection_rate_per_s)},
          {"battery_s", finite_or_null(member.battery_s)},
          {"layer", searcher.layer},
          {"committed", timed_points(member.committed)},
          {"goal", member.goal ? point(*member.goal) : json(nullptr)}};
}

[[noreturn]] void refuse(const std::string& id, const std::string& what) {
  throw RemotePlannerError("the path of '" + id + "' " + what);
}

TimedPath checked_path(const json& points, const SearchMember& member, const Searcher& searcher,
                       const OccupancyGrid& map) {
  TimedPath path;
  for (const json& p : points) {
    path.points.push_back({p.at(0).get<double>(), {p.at(1).get<double>(), p.at(2).get<double>()}});
  }
  if (path.points.empty()) refuse(searcher.id, "is empty; who is to wait has its pose alone");
  if (path.points.front().time_s != 0.0 ||
      (path.points.front().point_in_map - member.pose.position()).norm() > kStartTolerance_m) {
    refuse(searcher.id, "does not begin at time 0 at its pose");
  }
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const TimedPoint& from = path.points[i - 1];
    const TimedPoint& to = path.points[i];
    const std::string where = "between its points " + std::to_string(i - 1) + " and " + std::to_string(i);
    if (!(to.time_s >= from.time_s) || !std::isfinite(to.time_s)) refuse(searcher.id, "goes back in time " + where);
    const double length_m = (to.point_in_map - from.point_in_map).norm();
    if (!(length_m <= kSpeedTolerance * searcher.speed_mps * (to.time_s - from.time_s) + 1e-6)) {
      refuse(searcher.id, "is faster than " + std::to_string(searcher.speed_mps) + " m/s " + where);
    }
    if (!line_of_sight(map, from.point_in_map, to.point_in_map)) refuse(searcher.id, "leads through a wall " + where);
  }
  for (const TimedPoint& p : member.committed.points) {
    if ((pose_at(path, p.time_s).position() - p.point_in_map).norm() > kStartTolerance_m) {
      refuse(searcher.id, "does not begin with the committed one");
    }
  }
  return path;
}

}  // namespace

std::string world_message(SearchWorld& world) {
  const SearchArea& area = world.area();
  json cells = json::array();
  for (int cell = 0; cell < area.size(); ++cell) {
    cells.push_back({area.point(cell).x(), area.point(cell).y(), area.floor_m2(cell)});
  }
  json layers = json::array();
  int count = 1;
  for (const Searcher& searcher : world.searchers()) count = std::max(count, searcher.layer + 1);
  for (int i = 0; i < count; ++i) layers.push_back(layer(world.map(i)));
  return json{{"type", "world"},
              {"protocol", 1},
              {"layers", layers},
              {"cells", cells},
              {"cell_size_m", area.cell_size_m()},
              {"cells_corner_in_map", point(area.origin_in_map())}}
      .dump();
}

std::string plan_message(const SearchProblem& problem, double budget_s, std::uint64_t seed) {
  json members = json::array();
  for (const SearchMember& member : problem.members) {
    members.push_back(member_json(member, problem.world->searcher(member.searcher)));
  }
  json others = json::array();
  for (const OthersPath& other : problem.others) {
    others.push_back({{"id", problem.world->searcher(other.searcher).id}, {"path", timed_points(other.path)}});
  }
  json rejected = json::array();
  for (const auto& plan : problem.rejected) {
    json paths = json::array();
    for (const TimedPath& path : plan) paths.push_back(timed_points(path));
    rejected.push_back(paths);
  }
  json current = json::array();
  for (const TimedPath& path : problem.current) current.push_back(timed_points(path));
  return json{{"type", "plan"},
              {"budget_s", budget_s},
              {"seed", seed},
              {"horizon_s", problem.horizon_s},
              {"tail_s", problem.tail_s},
              {"members", members},
              {"masses", problem.masses},
              {"others", others},
              {"rejected", rejected},
              {"current", current}}
      .dump();
}

std::vector<TimedPath> paths_of_answer(std::string_view line, const SearchProblem& problem) {
  try {
    const json answer = json::parse(line);
    const json& paths = answer.at("paths");
    if (paths.size() != problem.members.size()) {
      throw RemotePlannerError("the answer has " + std::to_string(paths.size()) + " paths for " +
                               std::to_string(problem.members.size()) + " members");
    }
    std::vector<TimedPath> checked;
    for (std::size_t m = 0; m < problem.members.size(); ++m) {
      const Searcher& searcher = problem.world->searcher(problem.members[m].searcher);
      checked.push_back(checked_path(paths.at(m), problem.members[m], searcher, problem.world->map(searcher.layer)));
    }
    return checked;
  } catch (const json::exception& error) {
    throw RemotePlannerError(std::string("the answer is no plan: ") + error.what());
  }
}

}  // namespace tandem::remote
