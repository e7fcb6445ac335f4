#pragma once

#include <string>

namespace tandem {

/// Sends spdlog to standard error, each line with time, level and the service's name. Call once, first thing in main.
void start_logging(const std::string& service, const std::string& level);

}  // namespace tandem
