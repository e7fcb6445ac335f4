#include "services/cli/doctor/team_checks.hpp"

#include <algorithm>
#include <cmath>

#include "services/common/format.hpp"

namespace tandem::cli {
std::vector<Finding> check_services(const std::string& host, const std::vector<std::string>& needed,
                                    const std::vector<bus::ServiceSign>& heard) {
  std::vector<Finding> lines;
  for (const std::string& service : needed) {
    const std::string what = "service " + service;
    const auto sign = std::find_if(heard.begin(), heard.end(), [&](const bus::ServiceSign& candidate) {
      return candidate.host == host && candidate.service == service;
    });
    if (sign == heard.end()) {
      lines.push_back(
          fault(what, "silent", "running", "systemctl status tandem-" + service + "; journalctl -u tandem-" + service));
    } else if (sign->state == "ok") {
      lines.push_back(fine(what, "ok"));
    } else {
      const Verdict verdict = sign->state == "failed" ? Verdict::Error : Verdict::Warning;
      lines.push_back({what, verdict, sign->state + (sign->reason.empty() ? "" : ": " + sign->reason), "ok",
                       "journalctl -u tandem-" + service});
    }
  }
  return lines;
}

Finding check_versions(const std::vector<bus::ServiceSign>& heard, const std::string& own_contract,
                       const std::string& own_version) {
  if (heard.empty()) return not_applicable("versions", "no service was heard");
  std::set<std::string> others;
  for (const bus::ServiceSign& sign : heard) {
    if (sign.contract_hash != own_contract) others.insert(sign.host + "/" + sign.service + " " + sign.version);
  }
  const std::string own = own_version + ", contract " + own_contract;
  if (others.empty()) return fine("versions", own);
  std::string names;
  for (const std::string& other : others) names += (names.empty() ? "" : ", ") + other;
  return fault("versions", names + " speak another contract", own + " everywhere",
               "install the same packages on both hosts");
}

Finding check_link(const std::optional<LinkFact>& link) {
  const std::string what = "link to the other host";
  const std::string wanted = "up both ways, under 200 ms there and back, under 10 % lost";
  if (!link) return fault(what, "the relay is silent", wanted, "systemctl status tandem-relay");
  if (link->peer.empty()) {
    return fault(what, "no other host was heard", wanted,
                 "start the other host; is it on this network, and named in peers?");
  }
  if (link->one_way) {
    return fault(what, "one way alone to " + link->peer, wanted,
                 "a firewall, or the access point isolates its clients");
  }
  if (!link->up) return fault(what, link->peer + " is no longer heard", wanted, "is the other host on, and in reach?");
  const std::string found = link->peer + formatted(": %.0f ms there and back", 1000.0 * link->round_trip_s) +
                            formatted(", %.0f %% lost", 100.0 * link->loss);
  if (link->round_trip_s < 0.2 && link->loss < 0.1) return fine(what, found);
  return warning(what, found, wanted, "another channel or a nearer access point; docs/network.md");
}

Finding check_clock_offset(const std::optional<LinkFact>& link) {
  const std::string what = "clocks of the hosts";
  if (!link || !link->up) return not_applicable(what, "no link to compare over");
  const double offset_ms = 1000.0 * std::abs(link->clock_offset_s);
  const std::string found = formatted("%.0f ms apart", offset_ms);
  if (offset_ms <= 50.0) return fine(what, found);
  const std::string fix = "let chrony keep both: docs/deployment.md";
  if (offset_ms <= 250.0) return warning(what, found, "50 ms at most", fix);
  return fault(what, found, "50 ms at most", fix);
}

Finding check_maps(const std::set<std::string>& sha256) {
  if (sha256.empty()) return fault("map on the bus", "no map was heard", "one", "systemctl status tandem-map-server");
  if (sha256.size() == 1) return fine("map on the bus", sha256.begin()->substr(0, 12));
  std::string names;
  for (const std::string& sha : sha256) names += (names.empty() ? "" : ", ") + sha.substr(0, 12);
  return fault("map on the bus", names, "one", "one map server a host: `tandem topics` names both");
}

std::vector<Finding> check_base(const std::optional<BaseFact>& base, const BaseLimits& limits) {
  if (!base || !base->connected) {
    const std::string found = base ? "the controller does not answer" : "the base is silent";
    return {fault("base", found, "a controller that answers",
                  "switch the robot on; `systemctl status tandem-base` says more")};
  }
  std::vector<Finding> lines;
  lines.push_back(fine("base", base->model + " answers" +
                                   (base->stop_reasons.empty() ? "" : ", stands still for: " + base->stop_reasons)));
  const std::string watchdog = std::to_string(base->watchdog_ms) + " ms";
  const std::string wanted = formatted("%.0f ms at most", 1000.0 * limits.max_watchdog_s);
  if (base->watchdog_ms == 0) {
    lines.push_back(warning("firmware's watchdog", "not known: the gate drives slowly", wanted,
                            "update the firmware, or set it with the maker's tool"));
  } else if (base->watchdog_ms > 1000.0 * limits.max_watchdog_s) {
    lines.push_back(warning("firmware's watchdog", watchdog + ": the gate drives slowly", wanted,
                            "set it in the controller's FLASH; docs/safety.md"));
  } else {
    lines.push_back(fine("firmware's watchdog", watchdog));
  }
  const std::string voltage = formatted("%.1f V", base->battery_v);
  const std::string enough = formatted("above %.1f V", limits.battery_warning_v);
  if (base->battery_v <= limits.battery_stop_v) {
    lines.push_back(fault("battery", voltage, enough, "charge it: the robot does not drive"));
  } else if (base->battery_v <= limits.battery_warning_v) {
    lines.push_back(warning("battery", voltage, enough, "charge it before the next search"));
  } else {
    lines.push_back(fine("battery", voltage));
  }
  if (base->estop_pressed) {
    lines.push_back(warning("emergency stop", "pressed", "released", "turn the button, then resume on the phone"));
  } else {
    lines.push_back(fine("emergency stop", "released; press it once a day to see that it works"));
  }
  return lines;
}

Finding check_laser(const std::optional<ScanFact>& scans) {
  const std::string wanted = "at least 5 scans a second, 70 % of the beams valid";
  if (!scans) return fault("laser", "no scan was heard", wanted, "systemctl status tandem-laser; is it plugged in?");
  const std::string found = formatted("%.1f scans a second", scans->rate_hz) +
                            formatted(", %.0f %% of the beams valid", 100.0 * scans->valid_share);
  if (scans->rate_hz >= 5.0 && scans->valid_share >= 0.7) return fine("laser", found);
  return warning("laser", found, wanted,
                 "clean its window; in a hall larger than its range raise max_invalid_share in base.toml");
}

}  // namespace tandem::cli
