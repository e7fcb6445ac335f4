#include "services/cli/doctor/team_facts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "robot/pioneer/base_config.hpp"
#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/bus/stop_reasons.hpp"
#include "services/cli/command.hpp"
#include "services/cli/doctor/team_checks.hpp"
#include "services/cli/up/run_folder.hpp"
#include "services/common/version.hpp"

namespace tandem::cli {
namespace {

BaseLimits limits_in(const std::filesystem::path& folder) {
  try {
    const auto gate = load_config<BaseConfig>(folder / "base.toml").gate;
    return {gate.max_watchdog_s, gate.battery_warning_v, gate.battery_stop_v};
  } catch (const ConfigError&) {  // named among the configurations already
    return {};
  }
}

BaseFact fact_of(const msg::BaseStatus& status) {
  BaseFact fact{status.connected(), status.model(),         status.watchdog_ms(),
                status.battery_v(), status.estop_pressed(), ""};
  for (const msg::StopReason reason : status.stop_reasons()) {
    fact.stop_reasons += (fact.stop_reasons.empty() ? "" : ", ") + bus::words_of(reason);
  }
  return fact;
}

double valid_share(const msg::LaserScan& scan) {
  std::size_t valid = 0;
  for (const float range_m : scan.ranges_m()) valid += std::isfinite(range_m) ? 1 : 0;
  return scan.ranges_m().empty() ? 0.0 : static_cast<double>(valid) / static_cast<double>(scan.ranges_m().size());
}

}  // namespace

std::vector<Finding> listen_to_team(const std::filesystem::path& folder, const SiteConfig& site, bool simulated,
                                    Duration listen) {
  bus::Bus bus{bus::host_domain(site, "doctor")};
  auto signs = bus.in_order(topic::kServiceHealth);
  auto links = bus.latest(topic::kLinkStatus);
  auto bases = bus.latest(topic::kBaseStatus);
  auto maps = bus.latest(topic::kMap);
  auto scans = bus.in_order(topic::kScan);
  bus::ServiceRoster roster;
  std::optional<Time> first_scan;
  Time last_scan{};
  int scan_count = 0;
  double least_valid = 1.0;
  const Time end = bus.clock().now() + listen;
  while (bus.clock().now() < end) {
    if (stop_requested()) throw Interrupted();
    bus.wait(std::chrono::milliseconds{50});
    for (const auto& sign : signs.take()) roster.heard(bus::sign_of(sign.message), sign.received);
    for (const auto& scan : scans.take()) {
      if (!first_scan) first_scan = scan.received;
      last_scan = scan.received;
      least_valid = std::min(least_valid, valid_share(scan.message));
      ++scan_count;
    }
  }

  const auto heard = roster.alive(bus.clock().now());
  std::vector<Finding> lines = check_services(site.host, services_of(site.role), heard);
  lines.push_back(check_versions(heard, contract_hash(), version()));
  std::set<std::string> hashes;
  for (const auto& map : maps.each()) hashes.insert(map.message.sha256());
  lines.push_back(check_maps(hashes));
  if (site.role != "both") {
    std::optional<LinkFact> link;
    for (const auto& status : links.each()) {
      const msg::LinkStatus& said = status.message;
      if (said.host() != site.host) continue;
      link = {said.peer(), said.up(), said.one_way(), said.round_trip_s(), said.loss(), said.clock_offset_s()};
    }
    lines.push_back(check_link(link));
    if (!simulated) lines.push_back(check_clock_offset(link));
  }
  if (site.role != "laptop") {
    std::optional<BaseFact> base;
    for (const auto& status : bases.each()) {
      if (status.message.robot() == site.robot) base = fact_of(status.message);
    }
    const auto of_base = check_base(base, limits_in(folder));
    lines.insert(lines.end(), of_base.begin(), of_base.end());
    std::optional<ScanFact> laser;
    if (scan_count > 1) {
      const double span_s = to_seconds(last_scan - *first_scan);
      laser = ScanFact{span_s > 0.0 ? (scan_count - 1) / span_s : 0.0, least_valid};
    }
    lines.push_back(check_laser(laser));
  }
  return lines;
}

}  // namespace tandem::cli
