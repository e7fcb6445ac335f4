// Rows X1, X3, X5, X6 and X7 of docs/network.md, "Wrong peers": each is named within two seconds in the log, in
// service_health of the service it concerns, and by `tandem topics`; and the service hears its good peers as before.
#include <gtest/gtest.h>
#include <spdlog/sinks/ringbuffer_sink.h>
#include <spdlog/spdlog.h>

#include <functional>
#include <limits>

#include "services/bus/health.hpp"
#include "services/cli/topics/topics_watch.hpp"
#include "services/common/version.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::cli {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kNamedWithin = seconds{2};

/// A peer on the robot's host that does wrong; it may keep endpoints for as long as it lives.
struct WrongPeer {
  bus::Bus bus;
  std::vector<std::unique_ptr<bus::RawWriter>> writers;
  std::vector<std::unique_ptr<bus::Subscription>> readers;

  explicit WrongPeer(const bus::DomainOptions& options) : bus(options) {}
  bus::RawWriter& writer(const TopicInfo& topic) { return *writers.emplace_back(bus.raw_writer(topic)); }
};

struct Case {
  const char* name;     ///< begins with the id
  const char* service;  ///< whom it concerns
  /// Does wrong once more; called again and again.
  std::function<void(WrongPeer&)> misdeed;
  const char* text;  ///< how it is named
};

std::ostream& operator<<(std::ostream& stream, const Case& one) {
  return stream << one.name;
}

/// Sends `payload` as a plan.
std::function<void(WrongPeer&)> plan_of(const std::vector<std::uint8_t>& payload) {
  return [payload](WrongPeer& peer) {
    if (peer.writers.empty()) peer.writer(info_of(topic::kTeamPlan));
    peer.writers[0]->write(payload, {9});
  };
}

std::vector<std::uint8_t> plan_with(double value) {
  msg::TeamPlan plan;
  plan.robot("robot1");
  plan.value(value);
  return bus::encode<msg::TeamPlanPubSubType>(plan);
}

std::vector<std::uint8_t> cut_short() {
  auto payload = plan_with(1.0);
  payload.resize(payload.size() / 2);
  return payload;
}

std::vector<std::uint8_t> with_a_string_of_4_GB() {
  auto payload = plan_with(1.0);
  for (std::size_t i = 4; i < 8; ++i) payload[i] = 0xFF;  // the length of the robot's name
  return payload;
}

/// Says that it is `service` of robot1, on `host`.
std::function<void(WrongPeer&)> sign_of(const std::string& service, const std::string& host,
                                        const std::string& contract) {
  return [=](WrongPeer& peer) {
    if (peer.writers.empty()) peer.writer(info_of(topic::kServiceHealth));
    msg::ServiceHealth health;
    health.host(host);
    health.service(service);
    health.robot("robot1");
    health.process_id(4242);
    health.version("0.9.0");
    health.contract_hash(contract);
    health.state(msg::HEALTH_OK);
    peer.writers[0]->write(bus::encode<msg::ServiceHealthPubSubType>(health),
                           bus::key_of<msg::ServiceHealthPubSubType>(health));
  };
}

/// A topic of our name, but of another type or delivery.
TopicInfo changed(TopicInfo topic, const TopicInfo& other) {
  topic.make_type = other.make_type;
  topic.holds_nan = other.holds_nan;
  topic.delivery = other.delivery;
  return topic;
}

TopicInfo plan_as(Delivery delivery) {
  TopicInfo topic = info_of(topic::kTeamPlan);
  topic.delivery = delivery;
  return topic;
}

void write_once(WrongPeer& peer, const TopicInfo& topic) {
  if (peer.writers.empty()) peer.writer(topic);
}

void read_once(WrongPeer& peer, const TopicInfo& topic) {
  if (peer.readers.empty()) peer.readers.push_back(peer.bus.subscribe(topic, std::make_shared<bus::LatestBox>()));
}

const Case kCases[] = {
    {"X1_UnknownEncapsulation", "navigator", plan_of({0x12, 0x34, 0, 0, 1, 2, 3, 4}),
     "X1: malformed samples on team_plan from evil@robot1 dropped: unknown encapsulation"},
    {"X1_CutShort", "navigator", plan_of(cut_short()),
     "X1: malformed samples on team_plan from evil@robot1 dropped: cut short"},
    {"X1_BoundsExceeded", "navigator", plan_of(with_a_string_of_4_GB()),
     "X1: malformed samples on team_plan from evil@robot1 dropped: cut short, or longer inside than it is"},
    {"X1_NaN", "navigator", plan_of(plan_with(std::numeric_limits<double>::quiet_NaN())),
     "X1: malformed samples on team_plan from evil@robot1 dropped: a number is NaN"},
    {"X3_AWriterOfAnotherType", "navigator",
     [](WrongPeer& peer) { write_once(peer, changed(info_of(topic::kTeamPlan), info_of(topic::kSession))); },
     "X3: wrong type on team_plan: evil@robot1 writes tandem::msg::SessionState, ours is tandem::msg::TeamPlan"},
    {"X3_AReaderOfAnotherType", "navigator",
     [](WrongPeer& peer) { read_once(peer, changed(info_of(topic::kTeamPlan), info_of(topic::kClock))); },
     "X3: wrong type on team_plan: evil@robot1 reads tandem::msg::Clock, ours is tandem::msg::TeamPlan"},
    {"X3_AWriterWithIncompatibleQos", "navigator",
     [](WrongPeer& peer) { write_once(peer, plan_as(Delivery::SensorStream)); },
     "X3: incompatible QoS on team_plan: evil@robot1 offers best effort, navigator@robot1 asks for reliable"},
    {"X5_ASecondPlanner", "planner", sign_of("planner", "laptop2", contract_hash()),
     "X5: two planner services for robot1: process"},
    {"X5_ASecondNavigator", "navigator", sign_of("navigator", "robot1", contract_hash()),
     "X5: two navigator services for robot1: process"},
    {"X6_ASecondRobotOfOneName", "base", sign_of("base", "robot1b", contract_hash()),
     "X6: two base services for robot1: process"},
    {"X7_AnotherContract", "navigator", sign_of("laser", "robot1", "0123456789abcdef"),
     "X7: laser on host robot1 runs another version (0.9.0): its contract is 0123456789abcdef"},
};

class WrongPeers : public ::testing::TestWithParam<Case> {
 protected:
  WrongPeers()
      : service_bus_(options(GetParam().service)),
        plans_(service_bus_.in_order(topic::kTeamPlan)),
        health_(service_bus_, site(), GetParam().service),
        good_bus_(options("planner-of-old")),
        good_plans_(good_bus_.writer(topic::kTeamPlan)),
        reader_bus_(options("doctor")),
        signs_(reader_bus_.in_order(topic::kServiceHealth)),
        topics_bus_(options("topics")),
        topics_(topics_bus_),
        wrong_(options("evil")) {
    log_ = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(1000);
    spdlog::default_logger()->sinks().push_back(log_);
  }
  ~WrongPeers() override { spdlog::default_logger()->sinks().pop_back(); }

  [[nodiscard]] static SiteConfig site() { return {}; }
  [[nodiscard]] bus::DomainOptions options(const std::string& name) const {
    bus::DomainOptions options;
    options.domain = domain_[0];
    options.participant = name + "@robot1";
    return options;
  }

  /// One turn of everybody.
  void step() {
    health_.step(msg::HEALTH_OK);
    topics_.step();
    msg::TeamPlan plan;
    plan.robot("robot1");
    good_plans_.write(plan);
    good_ += plans_.take().size();
    for (const auto& sign : signs_.take()) {
      if (sign.message.host() == "robot1" && sign.message.service() == GetParam().service &&
          sign.message.process_id() != 4242) {
        said_ = sign.message;
      }
    }
  }
  [[nodiscard]] bool in_health() const { return said_.reason().find(GetParam().text) != std::string::npos; }
  [[nodiscard]] bool in_log() const {
    for (const auto& line : log_->last_formatted()) {
      if (line.find(std::string{"wrong peer: "} + GetParam().text) != std::string::npos) return true;
    }
    return false;
  }
  [[nodiscard]] bool in_topics() {
    for (const auto& fault : topics_.view().faults) {
      if (text_of(fault).starts_with(GetParam().text)) return true;
    }
    return false;
  }

  test::DomainLease domain_{1};
  bus::Bus service_bus_;
  bus::InOrder<msg::TeamPlan, msg::TeamPlanPubSubType> plans_;
  bus::HealthReporter health_;
  bus::Bus good_bus_;
  bus::Writer<msg::TeamPlan, msg::TeamPlanPubSubType> good_plans_;
  bus::Bus reader_bus_;
  bus::InOrder<msg::ServiceHealth, msg::ServiceHealthPubSubType> signs_;
  bus::Bus topics_bus_;
  TopicsWatch topics_;
  WrongPeer wrong_;
  std::shared_ptr<spdlog::sinks::ringbuffer_sink_mt> log_;
  msg::ServiceHealth said_;
  std::size_t good_ = 0;
};

TEST_P(WrongPeers, AreNamedWithinTwoSeconds) {
  ASSERT_TRUE(bus::wait_until(service_bus_, seconds{20}, [&] {
    step();
    return good_ > 0 && said_.state() == msg::HEALTH_OK;
  }));
  EXPECT_EQ(said_.reason(), "");
  ASSERT_TRUE(topics_.view().faults.empty());

  const Time began = service_bus_.clock().now();
  EXPECT_TRUE(bus::wait_until(service_bus_, seconds{10},
                              [&] {
                                GetParam().misdeed(wrong_);
                                step();
                                return in_health() && in_log() && in_topics();
                              }))
      << "health: " << said_.reason() << ", in the log: " << in_log() << ", in tandem topics: " << in_topics();
  EXPECT_LE(service_bus_.clock().now() - began, kNamedWithin);
  EXPECT_EQ(said_.state(), msg::HEALTH_DEGRADED);

  good_ = 0;
  EXPECT_TRUE(bus::wait_until(service_bus_, seconds{10}, [&] {
    GetParam().misdeed(wrong_);
    step();
    return good_ >= 5;
  }));
}

INSTANTIATE_TEST_SUITE_P(Id, WrongPeers, ::testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string{one.param.name}; });

}  // namespace
}  // namespace tandem::cli
