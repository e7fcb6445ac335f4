#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/common/site_config.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string output;  ///< standard output and error
};

/// Runs `tandem secure`.
Outcome secure(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((TANDEM_BINARY_DIR "/bin/tandem secure " + arguments + " 2>&1").c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// A lab with an authority, and the config of its robot.
class SecureCommands : public testing::Test {
 protected:
  SecureCommands() {
    site_.host = "robot1";
    site_.secure_link = true;
    site_.security_folder = (lab_ / "authority/hosts/robot1").string();
  }
  Outcome init() { return secure("init --folder " + authority()); }
  Outcome add(const std::string& arguments) { return secure("add " + arguments + " --folder " + authority()); }
  Outcome check(const std::string& more = "") {
    write_file_atomically(lab_ / "site.toml", write_config(site_));
    return secure("check --config " + lab_.path().string() + " " + more);
  }
  [[nodiscard]] std::string authority() const { return (lab_ / "authority").string(); }

  test::TemporaryFolder lab_;
  SiteConfig site_;
};

TEST_F(SecureCommands, WhatIsMadeForAHostIsUsableThere) {
  ASSERT_EQ(init().code, 0);
  ASSERT_EQ(add("robot1 --role robot --robot robot1 --days 100").code, 0);

  const Outcome good = check("--json");
  EXPECT_EQ(good.code, 0);
  const auto report = nlohmann::json::parse(good.output);
  EXPECT_EQ(report.at("usable"), true);
  EXPECT_EQ(report.at("problems"), nlohmann::json::array());
  EXPECT_EQ(report.at("days_left"), 99);  // and some hours
}

TEST_F(SecureCommands, OpensslAgreesWithTheChainAndTheSignatures) {
  ASSERT_EQ(init().code, 0);
  ASSERT_EQ(add("robot1 --role robot").code, 0);
  const fs::path host = site_.security_folder;
  const std::string trusted = " -CAfile " + (host / "authority.crt").string() + " ";
  const auto openssl = [](const std::string& arguments) {
    return std::system(("openssl " + arguments + " >/dev/null 2>&1").c_str());
  };
  EXPECT_EQ(openssl("verify" + trusted + (host / "host.crt").string()), 0);
  EXPECT_EQ(openssl("smime -verify -text -in " + (host / "governance.p7s").string() + trusted), 0);
  EXPECT_EQ(openssl("smime -verify -text -in " + (host / "permissions.p7s").string() + trusted), 0);
}

TEST_F(SecureCommands, ARobotMaySayWhatARobotSaysAndNoVelocityEver) {
  ASSERT_EQ(init().code, 0);
  ASSERT_EQ(add("robot1 --role robot").code, 0);

  const std::string permissions = read_file(fs::path{site_.security_folder} / "permissions.p7s");
  const std::string publish = permissions.substr(0, permissions.find("<subscribe>"));
  EXPECT_NE(publish.find("<topic>robot_pose</topic>"), std::string::npos);
  EXPECT_NE(publish.find("<topic>link_heartbeat</topic>"), std::string::npos);
  EXPECT_EQ(publish.find("<topic>team_plan</topic>"), std::string::npos);  // the laptop's
  EXPECT_NE(permissions.find("<topic>team_plan</topic>"), std::string::npos);
  EXPECT_EQ(permissions.find("velocity_command"), std::string::npos);
}

TEST_F(SecureCommands, AHostWithAnotherRoleThanItsPermissionsIsTold) {
  ASSERT_EQ(init().code, 0);
  ASSERT_EQ(add("robot1 --role laptop").code, 0);

  const Outcome outcome = check();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("permissions.p7s: they do not let it write: odometry"), std::string::npos)
      << outcome.output;
}

TEST_F(SecureCommands, ASiteThatDoesNotUseTheFilesIsTold) {
  ASSERT_EQ(init().code, 0);
  ASSERT_EQ(add("robot1 --role robot").code, 0);

  site_.secure_link = false;
  EXPECT_NE(check().output.find("secure_link = false: the link is not secured"), std::string::npos);
  site_.secure_link = true;
  site_.discovery = "server";
  const Outcome server = check();
  EXPECT_EQ(server.code, 1);
  EXPECT_NE(server.output.find("secure_link does not go with discovery = \"server\""), std::string::npos);
}

TEST_F(SecureCommands, MissingFilesAreNamedWithWhatToDo) {
  const Outcome outcome = check();

  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("host.key: cannot be read: No such file or directory. Copy here what tandem secure add "
                                "robot1 made"),
            std::string::npos)
      << outcome.output;
}

TEST_F(SecureCommands, AnAuthorityIsMadeOnceAndNeededFirst) {
  EXPECT_EQ(add("robot1 --role robot").code, 1);
  ASSERT_EQ(init().code, 0);
  const std::string key = read_file(lab_ / "authority/authority.key");
  EXPECT_EQ(init().code, 1);
  EXPECT_EQ(read_file(lab_ / "authority/authority.key"), key);
}

TEST_F(SecureCommands, NamesThatAreNoNamesAreRefused) {
  ASSERT_EQ(init().code, 0);
  for (const char* name : {"../evil", "'<x>'"}) {
    EXPECT_EQ(add(std::string{name} + " --role robot").code, 2) << name;
    EXPECT_EQ(add("robot1 --role robot --robot " + std::string{name}).code, 2) << name;
  }
  EXPECT_NE(add("robot1").code, 0);  // which role?
}

}  // namespace
}  // namespace tandem::cli
