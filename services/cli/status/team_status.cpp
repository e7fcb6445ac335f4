#include "services/cli/status/team_status.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string row(const std::string& name, const std::string& words) {
  return formatted("%-10s %s", name.c_str(), words.c_str());
}

std::string words_of(const Pose2& pose) {
  return formatted("(%.2f, %.2f) m", pose.x, pose.y);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "; ") + word;
  return text;
}

std::string link_words(const LinkView& link) {
  if (!link.up) return "DOWN" + (link.peer.empty() ? std::string{": nobody heard"} : " to " + link.peer);
  return "up to " + link.peer + (link.one_way ? ", ONE WAY" : "") +
         formatted(", round trip %.0f ms, %.0f %% lost, clocks %+.0f ms", 1e3 * link.round_trip_s, 100.0 * link.loss,
                   1e3 * link.clock_offset_s);
}

std::string robot_words(const TeamStatus& status) {
  const RobotStatus& robot = *status.robot_status;
  std::string words = robot.map_from_base
                          ? "at " + words_of(*robot.map_from_base) + ", localization " + robot.localization +
                                formatted(" (%.0f %% of beams fit)", 100.0 * robot.agreement)
                          : std::string{"nobody knows where"};
  if (!robot.connected) words += ", controller SILENT";
  if (!robot.stop_reasons.empty()) words += ", stopped: " + joined(robot.stop_reasons);
  if (robot.latched) words += " (needs tandem resume)";
  if (robot.stop_reasons.empty() && !status.execution.empty()) words += ", " + status.execution;
  return words + formatted(", battery %.1f V, at most %.2f m/s", robot.battery_v, robot.speed_limit_mps);
}

Json pose_json(const Pose2& pose) {
  return {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}};
}

}  // namespace

bool is_troubled(const TeamStatus& status) {
  return status.services.empty() || (status.link && !status.link->up) ||
         std::ranges::any_of(status.services, [](const ServiceStatus& one) { return one.state != "ok"; });
}

std::vector<std::string> lines_of(const TeamStatus& status) {
  std::vector<std::string> lines;
  lines.push_back(row("link", status.link ? link_words(*status.link) : "no relay on this host"));
  lines.push_back(row(status.robot, status.robot_status ? robot_words(status) : "not heard"));
  lines.push_back(row(status.agent, !status.person           ? "not heard"
                                    : status.person->tracked ? "tracked at " + words_of(status.person->map_from_agent)
                                                             : formatted("lost for %.0f s", status.person->age_s)));
  if (status.session) {
    const SessionView& session = *status.session;
    lines.push_back(row("session", session.code + " " + session.phase + formatted(", %.0f s", session.time_s) +
                                       (session.outcome.empty() ? "" : ", " + session.outcome) +
                                       (session.condition.empty() ? "" : ", condition " + session.condition)));
  } else {
    lines.push_back(row("session", "none"));
  }
  if (status.plan) {
    lines.push_back(row("plan", status.plan->state + ", " + status.plan->role +
                                    formatted(", %.0f s expected", status.plan->expected_time_s) +
                                    (status.plan->reason.empty() ? "" : ": " + status.plan->reason)));
  }
  if (status.explored) lines.push_back(row("explored", formatted("%.0f %%", 100.0 * *status.explored)));
  lines.emplace_back();
  if (status.services.empty()) lines.emplace_back("No service is heard on this host: do they run (tandem doctor)?");
  for (const ServiceStatus& service : status.services) {
    lines.push_back(formatted("%-14s %-14s %-9s %-10s %s", service.host.c_str(), service.service.c_str(),
                              service.state.c_str(), service.version.c_str(), service.reason.c_str()));
  }
  return lines;
}

std::string json_of(const TeamStatus& status) {
  Json json{{"host", status.host}, {"robot", status.robot}, {"agent", status.agent}, {"troubled", is_troubled(status)}};
  json["services"] = Json::array();
  for (const ServiceStatus& service : status.services) {
    json["services"].push_back({{"host", service.host},
                                {"service", service.service},
                                {"state", service.state},
                                {"reason", service.reason},
                                {"version", service.version}});
  }
  if (status.link) {
    json["link"] = {{"peer", status.link->peer},       {"up", status.link->up},
                    {"one_way", status.link->one_way}, {"round_trip_s", status.link->round_trip_s},
                    {"loss", status.link->loss},       {"clock_offset_s", status.link->clock_offset_s}};
  }
  if (status.robot_status) {
    const RobotStatus& robot = *status.robot_status;
    json["robot_status"] = {
        {"localization", robot.localization},       {"agreement", robot.agreement}, {"connected", robot.connected},
        {"stop_reasons", robot.stop_reasons},       {"latched", robot.latched},     {"battery_v", robot.battery_v},
        {"speed_limit_mps", robot.speed_limit_mps}, {"execution", status.execution}};
    if (robot.map_from_base) json["robot_status"]["map_from_base"] = pose_json(*robot.map_from_base);
  }
  if (status.person) {
    json["person"] = {{"tracked", status.person->tracked},
                      {"age_s", status.person->age_s},
                      {"map_from_agent", pose_json(status.person->map_from_agent)}};
  }
  if (status.session) {
    json["session"] = {{"code", status.session->code},
                       {"phase", status.session->phase},
                       {"condition", status.session->condition},
                       {"time_s", status.session->time_s},
                       {"outcome", status.session->outcome}};
  }
  if (status.plan) {
    json["plan"] = {{"state", status.plan->state},
                    {"role", status.plan->role},
                    {"expected_time_s", status.plan->expected_time_s},
                    {"reason", status.plan->reason}};
  }
  if (status.explored) json["explored"] = *status.explored;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tandem::cli
