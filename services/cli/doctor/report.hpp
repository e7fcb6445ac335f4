#pragma once

#include <string>
#include <vector>

#include "services/cli/doctor/finding.hpp"

namespace tandem::cli {

/// The lines for people, and a last one that sums up.
[[nodiscard]] std::string text_of(const std::vector<Finding>& findings);
/// The same as JSON: {"verdict", "lines": [{"what", "verdict", "found", "wanted", "fix"}]}.
[[nodiscard]] std::string json_of(const std::vector<Finding>& findings);
/// The worst of all.
[[nodiscard]] Verdict worst_of(const std::vector<Finding>& findings);

}  // namespace tandem::cli
