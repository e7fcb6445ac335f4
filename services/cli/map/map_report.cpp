#include "services/cli/map/map_report.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "services/cli/command.hpp"
#include "services/mapping/core/map_check.hpp"
#include "services/mapping/core/map_file.hpp"

namespace tandem::cli {
namespace {

const char* word_of(Severity severity) {
  return severity == Severity::Fault ? "fault" : "hint";
}

nlohmann::ordered_json json_of(const std::string& file, const OccupancyGrid& map, const MapCheck& check) {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const MapFinding& finding : check.findings) {
    findings.push_back({{"fault", name_of(finding.fault)},
                        {"severity", word_of(finding.severity)},
                        {"what", finding.what},
                        {"where", finding.where},
                        {"advice", finding.advice}});
  }
  const MapSummary& s = check.summary;
  return {{"map", file},
          {"ok", !has_faults(check)},
          {"resolution_m", map.resolution_m()},
          {"width_m", s.width_m},
          {"height_m", s.height_m},
          {"free_m2", s.free_m2},
          {"occupied_m2", s.occupied_m2},
          {"unknown_m2", s.unknown_m2},
          {"largest_free_m2", s.largest_free_m2},
          {"wall_thickness_m", s.wall_thickness_m},
          {"widest_m", s.widest_m},
          {"findings", findings}};
}

void print_text(const std::string& file, const OccupancyGrid& map, const MapCheck& check) {
  const MapSummary& s = check.summary;
  std::printf("%s: %.1f x %.1f m in cells of %g m, %.0f m2 free\n", file.c_str(), s.width_m, s.height_m,
              map.resolution_m(), s.free_m2);
  for (const MapFinding& finding : check.findings) {
    std::printf("%s: %s: %s%s%s\n       %s\n", word_of(finding.severity), name_of(finding.fault), finding.what.c_str(),
                finding.where.empty() ? "" : ", ", finding.where.c_str(), finding.advice.c_str());
  }
  if (check.findings.empty()) std::puts("nothing wrong");
}

}  // namespace

void run_map_check(const MapCheckOptions& options) {
  const OccupancyGrid map = load_map(options.file);
  const MapCheck check = check_map(map);
  if (options.json) {
    std::puts(json_of(options.file, map, check).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    print_text(options.file, map, check);
  }
  if (has_faults(check)) throw Failed{};
}

}  // namespace tandem::cli
