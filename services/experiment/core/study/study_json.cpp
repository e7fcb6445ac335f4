#include "services/experiment/core/study/study_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace tandem::experiment {
namespace {

using Json = nlohmann::ordered_json;

double hundredths(double value) {
  return std::round(value * 100.0) / 100.0;
}
double share(double value) {
  return std::round(value * 10'000.0) / 10'000.0;
}

Json json_of(const EpisodeResult& episode) {
  Json roles = Json::array();
  for (const RoleSince& role : episode.roles) roles.push_back({hundredths(role.time_s), name_of(role.role)});
  return {{"seed", episode.seed},
          {"found", episode.found},
          {"time_s", hundredths(episode.time_s)},
          {"found_by", episode.found_by},
          {"explored", share(episode.explored)},
          {"explored_robot", share(episode.explored_robot)},
          {"explored_human", share(episode.explored_human)},
          {"stops", episode.robot.stops},
          {"collisions", episode.robot.collisions},
          {"near_collisions", episode.robot.near_collisions},
          {"longest_idle_s", hundredths(episode.robot.longest_idle_s)},
          {"robot_distance_m", hundredths(episode.robot.distance_m)},
          {"human_distance_m", hundredths(episode.human_distance_m)},
          {"plans", episode.plans},
          {"messages", episode.messages},
          {"roles", roles}};
}

EpisodeResult episode_of(const Json& json) {
  EpisodeResult episode;
  json.at("seed").get_to(episode.seed);
  json.at("found").get_to(episode.found);
  json.at("time_s").get_to(episode.time_s);
  json.at("found_by").get_to(episode.found_by);
  json.at("explored").get_to(episode.explored);
  json.at("explored_robot").get_to(episode.explored_robot);
  json.at("explored_human").get_to(episode.explored_human);
  json.at("stops").get_to(episode.robot.stops);
  json.at("collisions").get_to(episode.robot.collisions);
  json.at("near_collisions").get_to(episode.robot.near_collisions);
  json.at("longest_idle_s").get_to(episode.robot.longest_idle_s);
  json.at("robot_distance_m").get_to(episode.robot.distance_m);
  json.at("human_distance_m").get_to(episode.human_distance_m);
  json.at("plans").get_to(episode.plans);
  json.at("messages").get_to(episode.messages);
  for (const Json& entry : json.at("roles")) {
    const auto role = role_named(entry.at(1).get<std::string>());
    if (role) episode.roles.push_back({entry.at(0).get<double>(), *role});
  }
  return episode;
}

Json json_of(const StudySettings& settings) {
  Json json{{"scenario", settings.scenario},
            {"planner", settings.planner},
            {"human", settings.human},
            {"seed", settings.seed}};
  if (settings.budget_ms > 0.0) {
    json["budget_ms"] = settings.budget_ms;
  } else {
    json["rollouts"] = settings.rollouts;
  }
  json["config_hash"] = settings.config_hash;
  return json;
}

Json rounded_values(const std::map<std::string, double>& values) {
  Json json = Json::object();
  for (const auto& [key, value] : values) json[key] = share(value);
  return json;
}

}  // namespace

std::string settings_line(const StudySettings& settings) {
  return Json{{"study", json_of(settings)}}.dump();
}

std::string episode_line(const EpisodeResult& episode) {
  return json_of(episode).dump();
}

std::optional<EpisodeResult> parse_episode_line(std::string_view line) {
  try {
    return episode_of(Json::parse(line));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string study_json(const StudySettings& settings, std::span<const EpisodeResult> episodes) {
  const StudySummary summary = summary_of(episodes);
  Json json = json_of(settings);
  Json list = Json::array();
  for (const EpisodeResult& episode : episodes) list.push_back(json_of(episode));
  json["episodes"] = std::move(list);
  json["mean_time_s"] = hundredths(summary.time_s.mean);
  json["ci95_s"] = {hundredths(summary.time_s.low), hundredths(summary.time_s.high)};
  json["explored_at_find"] = share(summary.explored_at_find);
  json["explored_robot_at_find"] = share(summary.explored_robot);
  json["explored_human_at_find"] = share(summary.explored_human);
  json["found"] = summary.found;
  json["stops_per_episode"] = hundredths(summary.stops);
  json["near_collisions_per_episode"] = hundredths(summary.near_collisions);
  json["collisions"] = summary.collisions;
  json["longest_idle_s"] = hundredths(summary.longest_idle_s);
  json["messages_per_min"] = rounded_values(summary.messages_per_min);
  json["role_shares"] = rounded_values(summary.role_shares);
  return json.dump(2);
}

std::string study_csv(std::span<const EpisodeResult> episodes) {
  static constexpr const char* kColumns[] = {"seed",
                                             "found",
                                             "time_s",
                                             "found_by",
                                             "explored",
                                             "explored_robot",
                                             "explored_human",
                                             "stops",
                                             "collisions",
                                             "near_collisions",
                                             "longest_idle_s",
                                             "robot_distance_m",
                                             "human_distance_m",
                                             "plans"};
  static constexpr const char* kMessages[] = {"my_pose", "my_goal", "replan"};
  std::string text;
  for (const char* column : kColumns) text += std::string{text.empty() ? "" : ","} + column;
  for (const char* kind : kMessages) text += std::string{","} + kind;
  text += "\n";
  for (const EpisodeResult& episode : episodes) {
    const Json json = json_of(episode);
    std::string row;
    for (const char* column : kColumns) {
      const Json& value = json.at(column);
      row += (row.empty() ? "" : ",") + (value.is_string() ? value.get<std::string>() : value.dump());
    }
    for (const char* kind : kMessages) row += "," + std::to_string(json.at("messages").value(kind, 0));
    text += row + "\n";
  }
  return text;
}

}  // namespace tandem::experiment
