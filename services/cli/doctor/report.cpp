#include "services/cli/doctor/report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Ok:
      return "ok";
    case Verdict::NotApplicable:
      return "n/a";
    case Verdict::Warning:
      return "warning";
    case Verdict::Error:
      return "error";
  }
  return "";
}

int count_of(const std::vector<Finding>& findings, Verdict verdict) {
  return static_cast<int>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& line) { return line.verdict == verdict; }));
}

}  // namespace

std::string text_of(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& line : findings) {
    text += formatted("%-8s %-24s %s\n", name_of(line.verdict), line.what.c_str(), line.found.c_str());
    if (!line.wanted.empty()) text += formatted("%33s wanted: %s\n", "", line.wanted.c_str());
    if (!line.fix.empty()) text += formatted("%33s to do:  %s\n", "", line.fix.c_str());
  }
  return text + formatted("%d lines: %d errors, %d warnings\n", static_cast<int>(findings.size()),
                          count_of(findings, Verdict::Error), count_of(findings, Verdict::Warning));
}

std::string json_of(const std::vector<Finding>& findings) {
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  for (const Finding& line : findings) {
    lines.push_back({{"what", line.what},
                     {"verdict", name_of(line.verdict)},
                     {"found", line.found},
                     {"wanted", line.wanted},
                     {"fix", line.fix}});
  }
  return nlohmann::ordered_json{{"verdict", name_of(worst_of(findings))}, {"lines", lines}}.dump(2);
}

Verdict worst_of(const std::vector<Finding>& findings) {
  Verdict worst = Verdict::Ok;
  for (const Finding& line : findings) {
    if (line.verdict != Verdict::NotApplicable) worst = std::max(worst, line.verdict);
  }
  return worst;
}

}  // namespace tandem::cli
