#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "gateway/server/core/gateway_config.hpp"
#include "robot/camera/core/camera_config.hpp"
#include "robot/laser/core/laser_config.hpp"
#include "robot/pioneer/base_config.hpp"
#include "services/common/config.hpp"
#include "services/common/site_config.hpp"
#include "services/localization/core/localization_config.hpp"
#include "services/mapping/core/map_server_config.hpp"
#include "services/navigator/core/navigator_config.hpp"
#include "services/planner/core/planner_config.hpp"
#include "services/recorder/core/recorder_config.hpp"
#include "services/relay/core/relay_config.hpp"
#include "services/simulator/core/simulator_config.hpp"
#include "services/tracking/core/tracking_config.hpp"
#include "tests/architecture/source_tree.hpp"

namespace tandem::test {
namespace {

template <typename Config>
void load(const std::filesystem::path& file) {
  const Config config = load_config<Config>(file);
  EXPECT_EQ(write_config(parse_config<Config>(write_config(config))), write_config(config)) << file;
}

/// Which struct each config file is for, by its name.
const std::map<std::string, std::function<void(const std::filesystem::path&)>>& loaders() {
  static const std::map<std::string, std::function<void(const std::filesystem::path&)>> by_name{
      {"camera.toml", load<CameraConfig>},
      {"base.toml", load<BaseConfig>},
      {"gateway.toml", load<gateway::GatewayConfig>},
      {"laser.toml", load<LaserConfig>},
      {"localization.toml", load<LocalizationConfig>},
      {"map-server.toml", load<MapServerConfig>},
      {"navigator.toml", load<navigator::NavigatorConfig>},
      {"planner.toml", load<PlannerConfig>},
      {"recorder.toml", load<recorder::RecorderConfig>},
      {"relay.toml", load<RelayConfig>},
      {"site.toml", load<SiteConfig>},
      {"simulator.toml", load<simulator::SimulatorConfig>},
      {"tracker.toml", load<tracking::TrackingConfig>},
  };
  return by_name;
}

TEST(ConfigFiles, EveryShippedFileLoads) {
  for (const auto& file : files_below("config", ".toml")) {
    const auto loader = loaders().find(std::filesystem::path{file}.filename().string());
    ASSERT_NE(loader, loaders().end()) << file << " is the config of no service known to config_files_test.cpp";
    EXPECT_NO_THROW(loader->second(source_root() / file)) << file;
  }
}

}  // namespace
}  // namespace tandem::test
