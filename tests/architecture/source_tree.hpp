#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tandem::test {

/// A line of a source file, for messages that name the place.
struct SourceLine {
  std::string file;  ///< relative to the root of the repository
  int number = 0;
  std::string text;
};

[[nodiscard]] std::filesystem::path source_root();

/// Every line of every C++ file below `folders` (relative to the root).
[[nodiscard]] std::vector<SourceLine> lines_of_sources(const std::vector<std::string>& folders);

/// Files below `folder` whose name ends in `ending`, relative to the root, sorted.
[[nodiscard]] std::vector<std::string> files_below(const std::string& folder, const std::string& ending);

}  // namespace tandem::test
