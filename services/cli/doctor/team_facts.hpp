#pragma once

#include <filesystem>
#include <vector>

#include "services/cli/doctor/finding.hpp"
#include "services/common/site_config.hpp"
#include "services/common/time.hpp"

namespace tandem::cli {

/// Listens to the services of this host, and through its relay to the other's, for `listen`. `simulated`: there is no
/// link to a second machine whose clock could differ. Throws Interrupted on Ctrl-C.
[[nodiscard]] std::vector<Finding> listen_to_team(const std::filesystem::path& folder, const SiteConfig& site,
                                                  bool simulated, Duration listen);

}  // namespace tandem::cli
