#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tandem::cli {

/// A file of a configuration folder: which service reads it, and how.
struct ConfigFile {
  std::string name;  ///< "base" for base.toml; "site" for what all services of a host share
  /// What the service gets from the file, every field, as TOML lines. Throws ConfigError.
  std::function<std::string(const std::filesystem::path&)> effective;
};

/// Every file that a configuration folder may hold, site.toml first.
[[nodiscard]] const std::vector<ConfigFile>& config_files();

/// One file looked at.
struct CheckedFile {
  std::filesystem::path file;
  std::string fault;  ///< what is wrong with it, with line and key; empty when it is sound
};

/// Looks at every TOML file of `folder`, at those that are missing for the role that its site.toml gives the host, and
/// at those that nobody reads. Throws std::runtime_error when there is no such folder.
[[nodiscard]] std::vector<CheckedFile> check_configs(const std::filesystem::path& folder);

/// A field of a configuration with where its value comes from.
struct OriginOfField {
  std::string field;   ///< "max_speed_mps = 0.5"
  std::string origin;  ///< "base.toml:7", or "default"
};

/// Every field of `file` as the service that reads it gets it. Throws ConfigError.
[[nodiscard]] std::vector<OriginOfField> origins(const ConfigFile& kind, const std::filesystem::path& file);

}  // namespace tandem::cli
