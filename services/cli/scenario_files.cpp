#include "services/cli/scenario_files.hpp"

#include "services/cli/command.hpp"

namespace tandem::cli {

namespace fs = std::filesystem;

fs::path scenario_file(const std::string& named, const fs::path& config_root) {
  if (fs::is_regular_file(named)) return named;
  const fs::path file = config_root / "scenarios" / (named + ".json");
  if (fs::exists(file)) return file;
  std::string names;
  for (const auto& entry : fs::directory_iterator(config_root / "scenarios")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".json") && name.find("schema") == std::string::npos) {
      names += (names.empty() ? "" : ", ") + entry.path().stem().string();
    }
  }
  throw WrongUse("no scenario '" + named + "'; there are: " + names);
}

}  // namespace tandem::cli
