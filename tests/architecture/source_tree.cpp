#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <fstream>

namespace tandem::test {

std::filesystem::path source_root() {
  return TANDEM_SOURCE_DIR;
}

std::vector<std::string> files_below(const std::string& folder, const std::string& ending) {
  std::vector<std::string> files;
  const auto root = source_root();
  if (!std::filesystem::exists(root / folder)) return files;
  for (auto entry = std::filesystem::recursive_directory_iterator(root / folder);
       entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    if (entry->path().filename() == "node_modules") {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && entry->path().string().ends_with(ending)) {
      files.push_back(std::filesystem::relative(entry->path(), root).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<SourceLine> lines_of_sources(const std::vector<std::string>& folders) {
  std::vector<SourceLine> lines;
  for (const auto& folder : folders) {
    for (const auto* ending : {".hpp", ".cpp"}) {
      for (const auto& file : files_below(folder, ending)) {
        std::ifstream stream{source_root() / file};
        std::string text;
        for (int number = 1; std::getline(stream, text); ++number) lines.push_back({file, number, text});
      }
    }
  }
  return lines;
}

}  // namespace tandem::test
