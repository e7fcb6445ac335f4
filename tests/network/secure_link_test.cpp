// A secured link: hosts of one authority talk, anybody else gets nothing and can send nothing, and the cause is named.
#include <gtest/gtest.h>

#include <set>

#include "services/common/file_io.hpp"
#include "tests/network/forger.hpp"
#include "tests/network/relayed_host.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/link_authority.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

/// Hosts of a laboratory on one link; the first is the robot. All would talk if the link were not secured.
class SecuredHosts {
 public:
  explicit SecuredHosts(const std::vector<std::string>& names, const RelayOptions& options = {},
                        const Conditions& conditions = {})
      : lab_(names), options_(options) {
    lab_.set_all(conditions);
    options_.host_domain = domains_[0];
    options_.link_domain = domains_[1];
  }

  /// Starts a host; `files`: its security files, none without security.
  RelayedHost& start(const std::string& name, const std::string& files) {
    options_.role = hosts_.empty() ? "robot" : "laptop";
    options_.security_folder = files;
    hosts_.push_back(std::make_unique<RelayedHost>(lab_.host(name), options_));
    return *hosts_.back();
  }
  [[nodiscard]] Laboratory& lab() { return lab_; }
  [[nodiscard]] int link_domain() const { return domains_[1]; }

 private:
  DomainLease domains_{2};
  Laboratory lab_;
  RelayOptions options_;
  std::vector<std::unique_ptr<RelayedHost>> hosts_;
};

/// Each host says who it is, as only that host would: the robot by its pose, a laptop by the session.
class Talk {
 public:
  explicit Talk(RelayedHost& robot)
      : robot_(robot),
        poses_(robot.bus().writer(topic::kRobotPose)),
        sessions_(robot.bus().in_order(topic::kSession)) {}

  void add(RelayedHost& laptop) {
    sessions_out_.push_back(laptop.bus().writer(topic::kSession));
    poses_in_.push_back(laptop.bus().latest(topic::kRobotPose));
    names_.push_back(laptop.host().name());
  }
  void say() {
    msg::RobotPose pose;
    pose.robot("robot1");
    pose.stamp_ns(to_stamp_ns(robot_.bus().clock().now()));
    poses_.write(pose);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      msg::SessionState session;
      session.code(names_[i]);
      sessions_out_[i].write(session);
    }
    for (const auto& received : sessions_.take()) heard_by_robot_.insert(received.message.code());
  }
  [[nodiscard]] const std::set<std::string>& heard_by_robot() const { return heard_by_robot_; }
  [[nodiscard]] bool hears_robot(std::size_t laptop) const { return poses_in_[laptop].newest().has_value(); }

 private:
  RelayedHost& robot_;
  bus::Writer<msg::RobotPose, msg::RobotPosePubSubType> poses_;
  bus::InOrder<msg::SessionState, msg::SessionStatePubSubType> sessions_;
  std::vector<bus::Writer<msg::SessionState, msg::SessionStatePubSubType>> sessions_out_;
  std::vector<bus::Latest<msg::RobotPose, msg::RobotPosePubSubType>> poses_in_;
  std::vector<std::string> names_;
  std::set<std::string> heard_by_robot_;
};

TEST(SecureLink, OnlyHostsOfTheAuthorityAreHeardAndTheOthersAreNamed) {
  TANDEM_NEEDS_LABORATORY();
  const LinkAuthority authority;
  const LinkAuthority foreign_authority;
  SecuredHosts hosts{{"robot", "laptop", "plain", "foreign"}};
  RelayedHost& robot = hosts.start("robot", authority.files_of("robot", HostRole::Robot));
  RelayedHost& laptop = hosts.start("laptop", authority.files_of("laptop", HostRole::Laptop));
  RelayedHost& plain = hosts.start("plain", "");
  RelayedHost& foreign = hosts.start("foreign", foreign_authority.files_of("foreign", HostRole::Laptop));
  Talk talk{robot};
  for (RelayedHost* host : {&laptop, &plain, &foreign}) talk.add(*host);
  const RelayHealth robot_health{robot};
  const RelayHealth plain_health{plain};
  const RelayHealth foreign_health{foreign};

  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20},
                              [&] {
                                talk.say();
                                return talk.hears_robot(0) && talk.heard_by_robot().contains("laptop") &&
                                       robot_health.names("\"relay@plain\": it has no certificate") &&
                                       robot_health.names("\"relay@foreign\": ") &&
                                       plain_health.names(
                                           "\"relay@robot\": its link is secured, and this host's is not") &&
                                       foreign_health.names("\"relay@robot\": ");
                              }))
      << "robot: " << robot_health.reason() << "\nplain: " << plain_health.reason()
      << "\nforeign: " << foreign_health.reason();
  // Whoever looked at the other's certificate knows why; the other has waited for an answer.
  EXPECT_TRUE(robot_health.names("or its permissions do not hold here") ||
              foreign_health.names("\"relay@robot\": its certificate of the authority"));
  EXPECT_EQ(talk.heard_by_robot(), std::set<std::string>{"laptop"});
  EXPECT_FALSE(talk.hears_robot(1));
  EXPECT_FALSE(talk.hears_robot(2));
}

/// A robot and a laptop of one authority talk, and what ends on one host ends on the other.
void expect_talk(const RelayOptions& options, const Conditions& conditions) {
  const LinkAuthority authority;
  SecuredHosts hosts{{"robot", "laptop"}, options, conditions};
  RelayedHost& robot = hosts.start("robot", authority.files_of("robot", HostRole::Robot));
  Talk talk{robot};
  RelayedHost& laptop = hosts.start("laptop", authority.files_of("laptop", HostRole::Laptop));
  talk.add(laptop);
  const RelayHealth robot_health{robot};
  const RelayHealth laptop_health{laptop};
  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20}, [&] {
    talk.say();
    return talk.hears_robot(0) && talk.heard_by_robot().contains("laptop");
  }));

  auto writer = laptop.bus().writer(topic::kTeamPlan);
  auto reader = robot.bus().latest(topic::kTeamPlan);
  msg::TeamPlan plan;
  plan.robot("robot1");
  writer.write(plan);
  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20}, [&] { return reader.newest().has_value(); }));
  writer.dispose(plan);
  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20}, [&] { return !reader.newest().has_value(); }));
  // Nothing that hosts of the link say is dropped as hostile.
  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20}, [&] { return robot_health.reason().empty(); }));
  EXPECT_FALSE(laptop_health.names("X2"));
}

TEST(SecureLink, WorksByMulticast) {
  TANDEM_NEEDS_LABORATORY();
  expect_talk({.link = {.discovery = "multicast"}}, {});
}

TEST(SecureLink, WorksByPeersWithoutMulticastThroughLoss) {
  TANDEM_NEEDS_LABORATORY();
  expect_talk({.link = {.discovery = "peers", .peers = {"10.66.0.1", "10.66.0.2"}}}, {.loss = 0.1, .multicast = false});
}

/// A robot and a laptop that talk, and a third host that has overheard the laptop's name.
class ForgedLink {
 public:
  explicit ForgedLink(bool secured)
      : robot_(hosts_.start("robot", secured ? authority_.files_of("robot", HostRole::Robot) : "")),
        laptop_(hosts_.start("laptop", secured ? authority_.files_of("laptop", HostRole::Laptop) : "")),
        forger_(hosts_.lab().host("forger"), hosts_.link_domain()) {
    Talk talk{robot_};
    talk.add(laptop_);
    EXPECT_TRUE(bus::wait_until(robot_.bus(), seconds{20}, [&] {
      talk.say();
      return talk.hears_robot(0) && talk.heard_by_robot().contains("laptop");
    }));
    EXPECT_TRUE(forger_.overhear(hosts_.lab().host("laptop").address()));
  }

  /// Whether a forged hint reaches the robot's services, before ten that the laptop sends afterwards do.
  bool forged_hint_arrives() {
    auto hints_out = laptop_.bus().writer(topic::kPoseHint);
    auto hints_in = robot_.bus().in_order(topic::kPoseHint);
    const auto hint = [](const std::string& id) {
      msg::PoseHint message;
      message.robot("robot1");
      message.id(id);
      return message;
    };
    std::multiset<std::string> came;
    EXPECT_TRUE(bus::wait_until(robot_.bus(), seconds{20}, [&] {
      forger_.forge(robot_address(), bus::encode<msg::PoseHintPubSubType>(hint("forged")));
      for (const auto& received : hints_in.take()) came.insert(received.message.id());
      if (came.contains("forged")) return true;
      hints_out.write(hint("true"));
      return came.count("true") >= 10;
    }));
    return came.contains("forged");
  }

  /// Whether a plan of the laptop can be ended in its name, before ten hints that it sends afterwards arrive.
  bool forged_end_arrives() {
    auto plans_out = laptop_.bus().writer(topic::kTeamPlan);
    auto plans_in = robot_.bus().latest(topic::kTeamPlan);
    auto hints_out = laptop_.bus().writer(topic::kPoseHint);
    auto hints_in = robot_.bus().in_order(topic::kPoseHint);
    msg::TeamPlan plan;
    plan.robot("robot1");
    plans_out.write(plan);  // sequence number 1
    EXPECT_TRUE(bus::wait_until(robot_.bus(), seconds{20}, [&] { return plans_in.newest().has_value(); }));
    std::size_t hints = 0;
    EXPECT_TRUE(bus::wait_until(robot_.bus(), seconds{20}, [&] {
      forger_.forge_end(robot_address(), bus::key_of<msg::TeamPlanPubSubType>(plan), 2);
      hints_out.write(msg::PoseHint{});
      hints += hints_in.take().size();
      return !plans_in.newest() || hints >= 10;
    }));
    return !plans_in.newest();
  }

 private:
  std::string robot_address() { return hosts_.lab().host("robot").address(); }

  LinkAuthority authority_;
  SecuredHosts hosts_{{"robot", "laptop", "forger"}};
  RelayedHost& robot_;
  RelayedHost& laptop_;
  Forger forger_;
};

TEST(SecureLink, NobodyCanForgeASample) {
  TANDEM_NEEDS_LABORATORY();
  ForgedLink link{true};
  EXPECT_FALSE(link.forged_hint_arrives());
  // Fast DDS 2.9 would take it: it has no payload that must be encrypted.
  EXPECT_FALSE(link.forged_end_arrives());
}

TEST(SecureLink, WithoutItAnybodyCan) {  // or the test above would prove nothing
  TANDEM_NEEDS_LABORATORY();
  EXPECT_TRUE(ForgedLink{false}.forged_hint_arrives());
  EXPECT_TRUE(ForgedLink{false}.forged_end_arrives());
}

TEST(SecureLink, UnusableFilesAreNamedAndTheLinkIsJoinedWhenTheyAreMended) {
  TANDEM_NEEDS_LABORATORY();
  const LinkAuthority authority;
  SecuredHosts hosts{{"robot", "laptop"}};
  const std::filesystem::path files = authority.files_of("robot", HostRole::Robot);
  const std::string key = read_file(files / "host.key");
  std::filesystem::remove(files / "host.key");
  RelayedHost& robot = hosts.start("robot", files.string());
  Talk talk{robot};
  talk.add(hosts.start("laptop", authority.files_of("laptop", HostRole::Laptop)));
  const RelayHealth health{robot};
  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20}, [&] { return health.names("host.key: cannot be read"); }));

  write_private_file(files / "host.key", key);
  EXPECT_TRUE(bus::wait_until(robot.bus(), seconds{20}, [&] {
    talk.say();
    return talk.hears_robot(0) && talk.heard_by_robot().contains("laptop") && health.reason().empty();
  }));
}

TEST(SecureLink, OnlyTheHandshakeIsLargerThanAFrame) {
  TANDEM_NEEDS_LABORATORY();
  const LinkAuthority authority;
  SecuredHosts hosts{{"robot", "laptop"}};
  RelayedHost& robot = hosts.start("robot", authority.files_of("robot", HostRole::Robot));
  RelayedHost& laptop = hosts.start("laptop", authority.files_of("laptop", HostRole::Laptop));
  auto plans_out = laptop.bus().writer(topic::kTeamPlan);
  auto plans_in = robot.bus().latest(topic::kTeamPlan);
  const auto plan_gets_through = [&](std::size_t size) {
    msg::TeamPlan plan;
    plan.robot("robot1");
    plan.reason(std::string(size, 'x'));
    plans_out.write(plan);
    return bus::wait_until(robot.bus(), seconds{20}, [&] {
      const auto newest = plans_in.newest();
      return newest && newest->message.reason().size() == size;
    });
  };
  ASSERT_TRUE(plan_gets_through(10));
  const auto before = hosts.lab().count("laptop");
  ASSERT_TRUE(plan_gets_through(50'000));  // 36 datagrams or more
  const auto after = hosts.lab().count("laptop");
  EXPECT_GT(before.fragments_sent, 0U);
  EXPECT_GE(after.frames_sent - before.frames_sent, 36U);
  EXPECT_EQ(after.fragments_sent, before.fragments_sent);
}

}  // namespace
}  // namespace tandem::test
