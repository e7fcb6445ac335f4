#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"

/// What `tandem status` shows, as values. What has not been heard is none or empty.
namespace tandem::cli {

struct ServiceStatus {
  std::string host;
  std::string service;
  std::string state;   ///< "ok", "starting", "degraded", "failed", "gone": its last word, and nobody is there
  std::string reason;  ///< of anything but ok
  std::string version;
};

struct LinkView {
  std::string peer;
  bool up = false;
  bool one_way = false;
  double round_trip_s = 0.0;
  double loss = 0.0;  ///< [0, 1]
  double clock_offset_s = 0.0;
};

struct RobotStatus {
  std::optional<Pose2> map_from_base = {};
  std::string localization = {};               ///< "ok", "uncertain", "lost"
  double agreement = 0.0;                      ///< [0, 1] share of beams that fit the map
  bool connected = false;                      ///< its controller answers
  std::vector<std::string> stop_reasons = {};  ///< most urgent first
  bool latched = false;                        ///< needs a resume
  double battery_v = 0.0;
  double speed_limit_mps = 0.0;
};

struct PersonStatus {
  Pose2 map_from_agent;
  bool tracked = false;
  double age_s = 0.0;  ///< since somebody saw them or they said where they are
};

struct SessionView {
  std::string code;
  std::string phase;  ///< "preparing", "running", "ended", "without a leader"
  std::string condition;
  double time_s = 0.0;  ///< since it began, or as long as it lasted
  std::string outcome;
};

struct PlanView {
  std::string state;  ///< "proposed", "accepted", "rejected", "superseded"
  std::string role;
  double expected_time_s = 0.0;
  std::string reason;
};

struct TeamStatus {
  std::string host = {};
  std::string robot = {};
  std::string agent = {};
  std::vector<ServiceStatus> services = {};  ///< by host and name
  std::optional<LinkView> link = {};
  std::optional<RobotStatus> robot_status = {};
  std::optional<PersonStatus> person = {};
  std::optional<SessionView> session = {};
  std::optional<PlanView> plan = {};
  std::optional<double> explored = {};  ///< [0, 1]
  std::string execution = {};           ///< what the navigator does: "moving", or why not
};

/// Nobody is heard, a service is not well, or the link is down.
[[nodiscard]] bool is_troubled(const TeamStatus& status);

/// The status for people, a line each.
[[nodiscard]] std::vector<std::string> lines_of(const TeamStatus& status);

/// The status as JSON, on one line.
[[nodiscard]] std::string json_of(const TeamStatus& status);

}  // namespace tandem::cli
