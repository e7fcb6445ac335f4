#include "services/cli/config/service_configs.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "gateway/server/core/gateway_config.hpp"
#include "robot/camera/core/camera_config.hpp"
#include "robot/laser/core/laser_config.hpp"
#include "robot/pioneer/base_config.hpp"
#include "services/cli/up/run_folder.hpp"
#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/common/site_config.hpp"
#include "services/localization/core/localization_config.hpp"
#include "services/mapping/core/map_server_config.hpp"
#include "services/navigator/core/navigator_config.hpp"
#include "services/planner/core/planner_config.hpp"
#include "services/recorder/core/recorder_config.hpp"
#include "services/relay/core/relay_config.hpp"
#include "services/simulator/core/simulator_config.hpp"
#include "services/tracking/core/tracking_config.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

template <typename Config>
ConfigFile file_of(std::string name) {
  return {std::move(name), [](const fs::path& file) { return write_config(load_config<Config>(file)); }};
}

std::string fault_of(const ConfigFile& kind, const fs::path& file) {
  try {
    std::ignore = kind.effective(file);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

/// The services whose file must be there; none while site.toml does not say.
std::set<std::string> needed_services(const fs::path& folder) {
  try {
    const auto services = services_of(load_config<SiteConfig>(folder / "site.toml").role);
    return {services.begin(), services.end()};
  } catch (const ConfigError&) {
    return {};
  }
}

}  // namespace

const std::vector<ConfigFile>& config_files() {
  static const std::vector<ConfigFile> files{
      file_of<SiteConfig>("site"),
      file_of<BaseConfig>("base"),
      file_of<LaserConfig>("laser"),
      file_of<CameraConfig>("camera"),
      file_of<LocalizationConfig>("localization"),
      file_of<tracking::TrackingConfig>("tracker"),
      file_of<navigator::NavigatorConfig>("navigator"),
      file_of<PlannerConfig>("planner"),
      file_of<gateway::GatewayConfig>("gateway"),
      file_of<RelayConfig>("relay"),
      file_of<MapServerConfig>("map-server"),
      file_of<recorder::RecorderConfig>("recorder"),
      file_of<simulator::SimulatorConfig>("simulator"),
  };
  return files;
}

std::vector<CheckedFile> check_configs(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + " is no folder; name it with --config");
  const std::set<std::string> needed = needed_services(folder);
  std::vector<CheckedFile> checked;
  for (const ConfigFile& kind : config_files()) {
    const fs::path file = folder / (kind.name + ".toml");
    if (fs::exists(file)) {
      checked.push_back({file, fault_of(kind, file)});
    } else if (kind.name == "site" || needed.contains(kind.name)) {
      checked.push_back({file, file.string() + ": missing; tandem-" + kind.name + " would not start"});
      if (kind.name == "site") checked.back().fault = file.string() + ": missing; it says which host this is";
    }
  }
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator{folder}) {
    const bool is_known = std::any_of(config_files().begin(), config_files().end(),
                                      [&](const ConfigFile& kind) { return entry.path().stem() == kind.name; });
    if (entry.path().extension() == ".toml" && !is_known) others.push_back(entry.path());
  }
  std::sort(others.begin(), others.end());
  for (const fs::path& file : others) checked.push_back({file, file.string() + ": no service reads it"});
  return checked;
}

std::vector<OriginOfField> origins(const ConfigFile& kind, const fs::path& file) {
  std::istringstream fields{kind.effective(file)};
  const std::map<std::string, int> lines = config_lines(read_file(file));
  std::vector<OriginOfField> all;
  for (std::string field; std::getline(fields, field);) {
    const auto line = lines.find(field.substr(0, field.find(' ')));
    all.push_back(
        {field, line == lines.end() ? "default" : file.filename().string() + ":" + std::to_string(line->second)});
  }
  return all;
}

}  // namespace tandem::cli
