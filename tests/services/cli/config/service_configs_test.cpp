#include "services/cli/config/service_configs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/cli/up/run_folder.hpp"
#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

std::string fault_in(const std::vector<CheckedFile>& files, const std::string& name) {
  for (const CheckedFile& checked : files) {
    if (checked.file.filename() == name) return checked.fault;
  }
  return "not looked at";
}

TEST(ServiceConfigs, KnowTheFileOfEveryService) {
  for (const std::string& service : services_of("both")) {
    EXPECT_TRUE(std::any_of(config_files().begin(), config_files().end(), [&](const ConfigFile& file) {
      return file.name == service;
    })) << service;
  }
}

TEST(ServiceConfigs, FindNothingWrongWithWhatIsShipped) {
  for (const char* folder : {"lab/robot", "lab/laptop", "simulation/robot", "simulation/laptop"}) {
    const auto files = check_configs(fs::path{TANDEM_SOURCE_DIR} / "config" / folder);
    EXPECT_GT(files.size(), 4u) << folder;
    for (const CheckedFile& checked : files) EXPECT_EQ(checked.fault, "");
  }
}

TEST(ServiceConfigs, NameWhatIsWrongMissingAndUnread) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "site.toml", "role = \"laptop\"\n");
  write_file_atomically(folder / "relay.toml", "# as it is\nheartbeat_timeout = 1.5\n");
  write_file_atomically(folder / "recorder.toml", "");
  write_file_atomically(folder / "map-server.toml", "map = \"lab.yaml\"\n");
  write_file_atomically(folder / "gateway.toml", "port = 99999\n");
  write_file_atomically(folder / "plannr.toml", "");
  const auto files = check_configs(folder.path());
  EXPECT_EQ(fault_in(files, "site.toml"), "");
  EXPECT_EQ(fault_in(files, "relay.toml"), (folder / "relay.toml").string() +
                                               ":2: heartbeat_timeout: unknown key; the nearest known key is "
                                               "heartbeat_timeout_s");
  EXPECT_EQ(fault_in(files, "gateway.toml"),
            (folder / "gateway.toml").string() + ":1: port: 99999 is outside [0, 65535]");
  EXPECT_EQ(fault_in(files, "planner.toml"),
            (folder / "planner.toml").string() + ": missing; tandem-planner would not start");
  EXPECT_EQ(fault_in(files, "plannr.toml"), (folder / "plannr.toml").string() + ": no service reads it");
  EXPECT_EQ(fault_in(files, "base.toml"), "not looked at") << "a laptop has no base";
}

TEST(ServiceConfigs, SayWhereEachValueComesFrom) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "relay.toml", "# ours\n\nheartbeat_timeout_s = 1.25\n");
  const auto& kind = *std::find_if(config_files().begin(), config_files().end(),
                                   [](const ConfigFile& file) { return file.name == "relay"; });
  std::size_t defaults = 0;
  bool seen = false;
  for (const auto& [field, origin] : origins(kind, folder / "relay.toml")) {
    if (field == "heartbeat_timeout_s = 1.25") seen = origin == "relay.toml:3";
    defaults += origin == "default" ? 1 : 0;
  }
  EXPECT_TRUE(seen);
  EXPECT_GT(defaults, 0u);
}

}  // namespace
}  // namespace tandem::cli
