#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem::cli {

/// What goes into a bundle, and from where.
struct BundlePlan {
  std::filesystem::path config_folder;  ///< its TOML files alone: keys and pairing links lie in other files
  std::filesystem::path log_folder;     ///< files *.log; empty: none
  std::filesystem::path recordings;     ///< of whose newest recording the end is taken; empty: none
  Duration recording_length = std::chrono::minutes{5};
};

/// Copies what `plan` names into `folder`, which must exist, and gives what was left out and why.
[[nodiscard]] std::vector<std::string> fill_bundle(const BundlePlan& plan, const std::filesystem::path& folder);

/// The newest *.mcap of `folder`; empty if there is none.
[[nodiscard]] std::filesystem::path newest_recording(const std::filesystem::path& folder);

/// Runs a program and keeps what it prints in `file`; false if it is not there or failed.
bool keep_output(const std::vector<std::string>& words, const std::filesystem::path& file);

}  // namespace tandem::cli
