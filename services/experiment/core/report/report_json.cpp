#include "services/experiment/core/report/report_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace tandem::experiment {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWayStep_m = 0.3;  ///< of plans in the scrubber

/// To so many parts of one; not a number and infinite: null.
Json rounded(double value, double parts) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * parts) / parts;
}
/// For lines.
Json rounded(double value) {
  return rounded(value, 1e3);
}
/// For tables.
Json finely(double value) {
  return rounded(value, 1e6);
}
Json finely(const std::optional<double>& value) {
  return value ? finely(*value) : Json();
}

Json rounded(const std::optional<double>& value) {
  return value ? rounded(*value) : Json();
}

Json json_of(const EpisodeLog& episode, const EpisodeMetrics& metrics, double step_s) {
  Json values;
  for (const Measure& measure : measures()) values[std::string{measure.name}] = finely(measure.of(metrics));
  Json line = Json::array();
  for (const ExploredAt& at : explored_line(episode, step_s)) {
    line.push_back({rounded(at.time_s), rounded(at.by_robot), rounded(at.by_all)});
  }
  Json roles = Json::array();
  for (const RoleSpan& span : role_spans(episode)) {
    roles.push_back({rounded(span.from_s), rounded(span.to_s), name_of(span.role)});
  }
  Json presses = Json::array();
  for (const PressAt& press : episode.presses) presses.push_back({rounded(press.time_s), press.kind});
  Json stopped = Json::object();
  for (const auto& [reason, time_s] : metrics.stopped_s) {
    const auto times = metrics.stops.find(reason);
    stopped[reason] = {{"times", times == metrics.stops.end() ? 0 : times->second}, {"s", rounded(time_s)}};
  }
  Json fields = Json::object();
  for (const auto& [field, value] : episode.fields) fields[field] = value;
  return {{"name", episode.name},
          {"code", episode.code},
          {"fields", fields},
          {"outcome", episode.outcome},
          {"found_by", episode.found_by},
          {"duration_s", rounded(episode.duration_s)},
          {"first_expected_s", rounded(metrics.first_expected_s)},
          {"first_lower_bound_s", rounded(metrics.first_lower_bound_s)},
          {"round_trip_s", rounded(metrics.round_trip_s)},
          {"reminder_effect", rounded(metrics.reminder_effect)},
          {"teammate_time_to_collision_s", rounded(metrics.teammate.min_time_to_collision_s)},
          {"values", values},
          {"stops", stopped},
          {"explored", line},
          {"roles", roles},
          {"presses", presses},
          {"gaps", gaps_of(episode)}};
}

Json json_of(const GroupReport& group) {
  Json my_pose = Json::array();
  for (const RateRow& row : group.my_pose) {
    my_pose.push_back({{"until_s", rounded(row.until_s)},
                       {"episodes", row.rate.episodes},
                       {"per_min", finely(row.rate.per_min)},
                       {"deviation", finely(row.rate.per_min_deviation)},
                       {"within", finely(row.rate.within)},
                       {"with_messages", row.rate.with_messages}});
  }
  Json explored = Json::array();
  for (const MeanExploredAt& at : group.explored) {
    explored.push_back({rounded(at.time_s), at.ongoing, rounded(at.by_robot), rounded(at.by_all)});
  }
  Json roles = Json::array();
  for (const RolesAt& at : group.roles) roles.push_back({rounded(at.time_s), at.ongoing, at.in});
  return {{"name", group.name},
          {"episodes", group.episodes},
          {"found", group.found},
          {"my_pose", my_pose},
          {"matching_threshold_s", rounded(group.matching_threshold_s)},
          {"explored", explored},
          {"roles", roles}};
}

Json json_of(const Comparison& comparison) {
  Json groups = Json::array();
  for (const GroupValue& value : comparison.groups) {
    groups.push_back({{"n", value.n},
                      {"mean", finely(value.mean)},
                      {"deviation", finely(value.deviation)},
                      {"median", finely(value.median)}});
  }
  Json pairs = Json::array();
  for (const PairComparison& pair : comparison.pairs) {
    pairs.push_back({{"a", pair.a},
                     {"b", pair.b},
                     {"p", finely(pair.p)},
                     {"p_holm", finely(pair.p_holm)},
                     {"pairs", pair.pairs},
                     {"g", finely(pair.effect.g)},
                     {"low", finely(pair.effect.low)},
                     {"high", finely(pair.effect.high)}});
  }
  const Anova& anova = comparison.anova;
  return {{"measure", comparison.measure},
          {"groups", groups},
          {"anova",
           {{"f", finely(anova.f)},
            {"between", anova.between},
            {"within", anova.within},
            {"p", finely(anova.p)},
            {"eta_squared", finely(anova.eta_squared)}}},
          {"pairs", pairs}};
}

double centimetres(double value_m) {
  return std::round(value_m * 100.0) / 100.0;
}

Json ways_of(const std::vector<PoseAt>& poses, double step_s) {
  Json way = Json::array();
  double next_s = -1e9;
  for (const PoseAt& pose : poses) {
    if (pose.time_s < next_s) continue;
    next_s = pose.time_s + step_s;
    way.push_back({std::round(pose.time_s * 10.0) / 10.0, centimetres(pose.map_from_agent.x),
                   centimetres(pose.map_from_agent.y), centimetres(pose.map_from_agent.heading)});
  }
  return way;
}

Json path_of(const PlanAt::Path& path) {
  Json points = Json::array();
  for (std::size_t i = 0; i < path.points_in_map.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == path.points_in_map.size();
    if (!is_end && !points.empty() &&
        std::hypot(path.points_in_map[i].x() - points.back()[0].get<double>(),
                   path.points_in_map[i].y() - points.back()[1].get<double>()) < kWayStep_m) {
      continue;
    }
    points.push_back({centimetres(path.points_in_map[i].x()), centimetres(path.points_in_map[i].y())});
  }
  return points;
}

Json map_of(const OccupancyGrid& grid) {
  std::string cells;
  for (const CellState cell : grid.cells()) {
    cells += cell == CellState::Free ? '.' : cell == CellState::Occupied ? '#' : '?';
  }
  const Pose2& corner = grid.map_from_grid();
  return {{"width", grid.width()},
          {"height", grid.height()},
          {"resolution_m", grid.resolution_m()},
          {"map_from_grid", {corner.x, corner.y, corner.heading}},
          {"cells", cells}};
}

Json replay_of(const EpisodeLog& episode, const PageOptions& options) {
  Json plans = Json::array();
  std::set<std::string> drawn;
  for (const PlanAt& plan : episode.plans) {
    static constexpr std::array kStates{"proposed", "accepted", "rejected", "superseded"};
    Json entry{{"t", rounded(plan.time_s)},
               {"id", plan.id},
               {"state", kStates[static_cast<std::size_t>(plan.state)]},
               {"role", name_of(plan.role)},
               {"expected_s", rounded(plan.expected_time_s)}};
    if (drawn.insert(plan.id).second) {
      Json paths = Json::object();
      for (const PlanAt::Path& path : plan.paths) paths[path.agent] = path_of(path);
      entry["paths"] = paths;
    }
    plans.push_back(entry);
  }
  Json beliefs = Json::array();
  double next_s = -1e9;
  for (std::size_t i = 0; i < episode.beliefs.size(); ++i) {
    const BeliefAt& belief = episode.beliefs[i];
    if (belief.time_s < next_s && i + 1 < episode.beliefs.size()) continue;
    next_s = belief.time_s + options.belief_step_s;
    beliefs.push_back({{"t", rounded(belief.time_s)},
                       {"width", belief.width},
                       {"height", belief.height},
                       {"resolution_m", belief.resolution_m},
                       {"origin", {belief.origin_in_map.x(), belief.origin_in_map.y()}},
                       {"cells", belief.cells}});
  }
  Json presses = Json::array();
  for (const PressAt& press : episode.presses) {
    Json entry{{"t", rounded(press.time_s)}, {"kind", press.kind}};
    if (press.point_in_map) entry["at"] = {centimetres(press.point_in_map->x()), centimetres(press.point_in_map->y())};
    presses.push_back(entry);
  }
  Json passers_by = Json::array();
  next_s = -1e9;
  for (const PassersByAt& sighting : episode.passers_by) {
    if (sighting.time_s < next_s) continue;
    next_s = sighting.time_s + options.pose_step_s;
    Json points = Json::array();
    for (const auto& point : sighting.points_in_map) points.push_back({centimetres(point.x()), centimetres(point.y())});
    passers_by.push_back({rounded(sighting.time_s), points});
  }
  Json stops = Json::array();
  for (const BaseAt& base : episode.base) stops.push_back({rounded(base.time_s), base.stop_reasons});
  Json replay{{"robot", ways_of(episode.robot_poses, options.pose_step_s)},
              {"human", ways_of(episode.human_poses, options.pose_step_s)},
              {"robot_name", episode.robot},
              {"human_name", episode.agent},
              {"plans", plans},
              {"beliefs", beliefs},
              {"presses", presses},
              {"passers_by", passers_by},
              {"stops", stops}};
  if (episode.object_in_map) {
    replay["object"] = {centimetres(episode.object_in_map->x()), centimetres(episode.object_in_map->y())};
  }
  return replay;
}

/// The maps of the episodes, each once, and which is whose (-1: none).
std::pair<Json, std::vector<int>> maps_of(std::span<const EpisodeLog> episodes) {
  std::pair<Json, std::vector<int>> maps{Json::array(), {}};
  std::vector<const OccupancyGrid*> kept;
  for (const EpisodeLog& episode : episodes) {
    if (!episode.map) {
      maps.second.push_back(-1);
      continue;
    }
    const auto same = std::ranges::find_if(kept, [&](const OccupancyGrid* grid) { return *grid == *episode.map; });
    maps.second.push_back(static_cast<int>(same - kept.begin()));
    if (same != kept.end()) continue;
    kept.push_back(&*episode.map);
    maps.first.push_back(map_of(*episode.map));
  }
  return maps;
}

}  // namespace

std::string report_json(std::span<const EpisodeLog> episodes, const Report& report, const PageOptions& options) {
  Json page;
  page["title"] = options.title;
  page["by"] = report.options.by;
  page["pair"] = report.options.pair;
  page["threshold_s"] = report.options.threshold_s;
  page["baseline"] = report.options.baseline;
  page["step_s"] = report.options.step_s;
  page["measures"] = Json::array();
  for (const Measure& measure : measures()) {
    page["measures"].push_back({{"name", measure.name}, {"unit", measure.unit}, {"words", measure.words}});
  }
  page["episodes"] = Json::array();
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    page["episodes"].push_back(json_of(episodes[i], report.episodes[i], report.options.step_s));
  }
  for (const char* part : {"groups", "comparisons", "questions"}) page[part] = Json::array();
  for (const GroupReport& group : report.groups) page["groups"].push_back(json_of(group));
  for (const Comparison& comparison : report.measures) page["comparisons"].push_back(json_of(comparison));
  for (const Comparison& comparison : report.questions) page["questions"].push_back(json_of(comparison));
  if (options.with_replay) {
    auto [maps, map_of_episode] = maps_of(episodes);
    page["maps"] = std::move(maps);
    page["replays"] = Json::array();
    for (std::size_t i = 0; i < episodes.size(); ++i) {
      Json replay = replay_of(episodes[i], options);
      replay["map"] = map_of_episode[i];
      page["replays"].push_back(std::move(replay));
    }
  }
  // Names of sessions are written by people, in any encoding.
  return page.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tandem::experiment
