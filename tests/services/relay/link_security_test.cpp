#include "services/relay/link_security.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "services/bus/bus.hpp"
#include "services/common/clock.hpp"
#include "services/relay/relay_service.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/link_authority.hpp"

namespace tandem {
namespace {

using std::chrono::seconds;

bool holds(const std::vector<std::string>& topics, const std::string& name) {
  return std::find(topics.begin(), topics.end(), name) != topics.end();
}

SiteConfig site_of(const std::string& host, const std::string& role, const std::string& files) {
  SiteConfig site;
  site.host = host;
  site.role = role;
  site.secure_link = true;
  site.security_folder = files;
  return site;
}

TEST(LinkTopics, OfOneSideAreWhatTheOtherSideReads) {
  const LinkTopics robot = link_topics(HostRole::Robot);
  const LinkTopics laptop = link_topics(HostRole::Laptop);

  EXPECT_EQ(robot.publishes, laptop.subscribes);
  EXPECT_EQ(laptop.publishes, robot.subscribes);
  EXPECT_TRUE(holds(robot.publishes, "robot_pose"));
  EXPECT_FALSE(holds(laptop.publishes, "robot_pose"));
  EXPECT_TRUE(holds(laptop.publishes, "stop_request"));
  for (const char* both : {"link_heartbeat", "map_holding", "compressed_map", "message_receipt"}) {
    EXPECT_TRUE(holds(robot.publishes, both) && holds(laptop.publishes, both)) << both;
  }
  EXPECT_FALSE(holds(robot.subscribes, "velocity_command") || holds(robot.publishes, "velocity_command"));
}

TEST(SecurityTrouble, IsNoneWhereTheLinkIsOpenOrTheFilesAreGood) {
  const test::LinkAuthority authority;
  SiteConfig site = site_of("robot1", "robot", authority.files_of("robot1", HostRole::Robot));
  EXPECT_EQ(security_trouble(site, wall_time()), "");
  EXPECT_EQ(days_left(site, wall_time()), 29);  // and some hours
  site.security_folder = "/nowhere";
  EXPECT_NE(security_trouble(site, wall_time()), "");
  site.secure_link = false;
  EXPECT_EQ(security_trouble(site, wall_time()), "");
}

TEST(SecurityTrouble, OfEachFileIsNamed) {
  const std::string trouble = security_trouble(site_of("robot1", "robot", "/nowhere"), wall_time());
  for (const char* file : {"authority.crt", "host.crt", "host.key", "governance.p7s", "permissions.p7s"}) {
    EXPECT_NE(trouble.find(std::string{"/nowhere/"} + file + ": cannot be read"), std::string::npos) << trouble;
  }
}

TEST(SecuredRelay, RefusesADiscoveryServerBeforeItStarts) {
  const test::DomainLease domains{1};
  SiteConfig site = site_of("robot1", "robot", "/nowhere");
  site.host_domain = domains[0];
  site.discovery = "server";
  bus::Bus host{bus::host_domain(site, "relay")};
  try {
    const RelayService relay{site, RelayConfig{}, host};
    FAIL() << "a secured discovery server was accepted";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string{error.what()}.find("secure_link does not go with discovery = \"server\""), std::string::npos);
  }
}

/// A participant on the secured link of robot1's team, with our files.
bus::DomainOptions on_link(const std::string& name, const std::string& files, int domain,
                           const std::string& team = "robot1") {
  SiteConfig site = site_of(name, "laptop", files);
  site.link_domain = domain;
  site.robot = team;
  return link_domain(site, RelayConfig{}, "127.0.0.1");
}

// The last line of defence: what the check would have named, Fast DDS must refuse.
TEST(SecuredParticipant, HasNoTopicThatItsPermissionsDoNotName) {
  const test::DomainLease domains{1};
  const test::LinkAuthority authority;
  bus::Bus laptop{on_link("laptop1", authority.files_of("laptop1", HostRole::Laptop), domains[0])};

  EXPECT_NO_THROW((void)laptop.writer(topic::kStopRequest));
  EXPECT_ANY_THROW((void)laptop.writer(topic::kRobotPose));        // a robot's
  EXPECT_ANY_THROW((void)laptop.writer(topic::kVelocityCommand));  // nobody's
  EXPECT_ANY_THROW((void)laptop.latest(topic::kVelocityCommand));
}

TEST(SecuredParticipant, HasNoTopicInAnotherTeam) {
  const test::DomainLease domains{1};
  const test::LinkAuthority authority;
  const std::string files = authority.files_of("laptop1", HostRole::Laptop, "robot1");
  bus::Bus laptop{on_link("laptop1", files, domains[0], "robot2")};

  EXPECT_ANY_THROW((void)laptop.writer(topic::kStopRequest));
}

TEST(SecuredParticipant, IsNotMadeWithAnUnusableFileAndSaysWhereToLook) {
  const test::DomainLease domains{1};
  const test::LinkAuthority authority;
  const std::filesystem::path files = authority.files_of("laptop1", HostRole::Laptop);
  const std::filesystem::path others = authority.files_of("laptop2", HostRole::Laptop);
  std::filesystem::copy_file(others / "permissions.p7s", files / "permissions.p7s",
                             std::filesystem::copy_options::overwrite_existing);
  try {
    const bus::Bus laptop{on_link("laptop1", files.string(), domains[0])};
    FAIL() << "joined with the permissions of another host";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("tandem secure check"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tandem
