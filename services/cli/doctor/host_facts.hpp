#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "services/cli/doctor/host_checks.hpp"
#include "services/common/site_config.hpp"

namespace tandem::cli {

/// Looks at this machine: system, network, disk, devices, and the configuration in `folder`; about a second.
/// `simulated`: there is no hardware to look for, and no Wi-Fi.
[[nodiscard]] std::vector<Finding> look_at_host(const std::filesystem::path& folder, const SiteConfig& site,
                                                bool simulated);

}  // namespace tandem::cli
