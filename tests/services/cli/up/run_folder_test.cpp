#include "services/cli/up/run_folder.hpp"

#include <gtest/gtest.h>

#include <set>

#include "services/common/site_config.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

TEST(RunFolder, HoldsTheConfigsOfBothHostsWithTheRunsOwnDomainsAndPorts) {
  const test::TemporaryFolder home;
  SimulatedRun run;
  run.config_root = std::filesystem::path{TANDEM_SOURCE_DIR} / "config";
  run.folder = home / "run";
  run.scenario = run.config_root / "scenarios" / "quick.json";
  run.map = run.config_root / "maps" / "room.yaml";
  run.robot_domain = 31;
  run.laptop_domain = 32;
  run.link_domain = 33;
  run.robot = "robot7";
  run.recording_folder = run.folder;

  const RunFolder folder = make_run_folder(run);

  const auto robot = load_config<SiteConfig>(folder.robot_config / "site.toml");
  const auto laptop = load_config<SiteConfig>(folder.laptop_config / "site.toml");
  EXPECT_EQ(robot.role, "robot");
  EXPECT_EQ(laptop.role, "laptop");
  EXPECT_EQ(robot.robot, "robot7");
  EXPECT_EQ(laptop.robot, "robot7");
  EXPECT_EQ(robot.host_domain, 31);
  EXPECT_EQ(laptop.host_domain, 32);
  EXPECT_EQ(robot.link_domain, 33);
  EXPECT_EQ(laptop.link_domain, 33);
  EXPECT_NE(robot.host, laptop.host);
  for (const auto& service : services_of("robot")) {
    EXPECT_TRUE(std::filesystem::exists(folder.robot_config / (service + ".toml"))) << service;
  }
  for (const auto& service : services_of("laptop")) {
    EXPECT_TRUE(std::filesystem::exists(folder.laptop_config / (service + ".toml"))) << service;
  }
}

TEST(RunFolder, OneHostForEverythingRunsEachServiceOnce) {
  const auto services = services_of("both");
  EXPECT_EQ(std::set<std::string>(services.begin(), services.end()).size(), services.size());
  for (const auto& role : {"robot", "laptop"}) {
    for (const auto& service : services_of(role)) {
      EXPECT_NE(std::find(services.begin(), services.end(), service), services.end()) << service;
    }
  }
}

}  // namespace
}  // namespace tandem::cli
