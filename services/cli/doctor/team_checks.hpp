#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/bus/core/service_roster.hpp"
#include "services/cli/doctor/finding.hpp"

/// What `tandem doctor` makes of what the services of the team say. Facts in, lines out; team_facts.hpp listens.
namespace tandem::cli {

/// The link to another host as this host's relay measures it.
struct LinkFact {
  std::string peer;
  bool up = false;
  bool one_way = false;
  double round_trip_s = 0.0;
  double loss = 0.0;
  double clock_offset_s = 0.0;
};

/// What the base says of itself.
struct BaseFact {
  bool connected = false;
  std::string model;
  std::uint32_t watchdog_ms = 0;
  double battery_v = 0.0;
  bool estop_pressed = false;
  std::string stop_reasons;
};

/// The limits of base.toml that the lines are held against.
struct BaseLimits {
  double max_watchdog_s = 1.0;
  double battery_warning_v = 11.8;
  double battery_stop_v = 11.2;
};

/// A few seconds of scans.
struct ScanFact {
  double rate_hz = 0.0;
  double valid_share = 0.0;
};

/// Every needed service of this host: heard or not, and how it is.
[[nodiscard]] std::vector<Finding> check_services(const std::string& host, const std::vector<std::string>& needed,
                                                  const std::vector<bus::ServiceSign>& heard);
/// Whether all that were heard speak one contract.
[[nodiscard]] Finding check_versions(const std::vector<bus::ServiceSign>& heard, const std::string& own_contract,
                                     const std::string& own_version);
[[nodiscard]] Finding check_link(const std::optional<LinkFact>& link);
/// The two hosts' clocks: within 50 ms is good, beyond 250 ms no mission starts (faults T2).
[[nodiscard]] Finding check_clock_offset(const std::optional<LinkFact>& link);
/// The maps that were heard on this host: its map server's, or the one that came over the link.
[[nodiscard]] Finding check_maps(const std::set<std::string>& sha256);

[[nodiscard]] std::vector<Finding> check_base(const std::optional<BaseFact>& base, const BaseLimits& limits);
[[nodiscard]] Finding check_laser(const std::optional<ScanFact>& scans);

}  // namespace tandem::cli
