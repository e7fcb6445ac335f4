#pragma once

#include <filesystem>
#include <string>

namespace tandem::cli {

/// The file of the scenario `named` on the command line: a file, or a name in `config_root`/scenarios. Throws WrongUse,
/// naming the scenarios there are.
[[nodiscard]] std::filesystem::path scenario_file(const std::string& named, const std::filesystem::path& config_root);

}  // namespace tandem::cli
