#include "bench/network/airs.hpp"
#include "bench/network/measurements.hpp"
#include "bench/network/stream.hpp"

namespace tandem::bench {
namespace {

using std::chrono::seconds;

constexpr double kSeconds = 15.0;
constexpr int kServices = 7;

/// Sends one message again and again.
template <class PubSubType>
std::unique_ptr<Stream> repeated(Side& side, const Topic<PubSubType>& topic, double rate_hz,
                                 const typename PubSubType::type& message) {
  return std::make_unique<Stream>(
      side, info_of(topic), rate_hz, [bytes = bus::encode<PubSubType>(message)](auto, auto) { return bytes; },
      bus::key_of<PubSubType>(message));
}

template <class Message>
Message of_robot(Message message = {}) {
  message.robot("robot1");
  return message;
}

msg::ServiceHealth health_of(const std::string& host, int service) {
  msg::ServiceHealth health;
  health.host(host);
  health.service("service" + std::to_string(service));
  health.version("0.1.0");
  health.contract_hash("0123456789abcdef");
  return health;
}

using Streams = std::vector<std::unique_ptr<Stream>>;

/// What a robot sends, at the rates of the topic table.
Streams of_the_robot(Side& side, bool driving) {
  Streams streams;
  streams.push_back(repeated(side, topic::kBaseStatus, 2.0, of_robot<msg::BaseStatus>()));
  streams.push_back(repeated(side, topic::kPlanExecution, 2.0, of_robot<msg::PlanExecution>()));
  for (int i = 0; i < kServices; ++i) {
    streams.push_back(repeated(side, topic::kServiceHealth, 1.0, health_of("robot", i)));
  }
  if (!driving) return streams;
  auto scan = of_robot<msg::LaserScan>();
  scan.ranges_m().assign(682, 3.0F);
  msg::TeammateState teammate;
  teammate.agent("person1");
  streams.push_back(odometry_stream(side, 20.0));
  streams.push_back(pose_stream(side, 20.0));
  streams.push_back(repeated(side, topic::kScan, 10.0, scan));
  streams.push_back(repeated(side, topic::kPeople, 10.0, of_robot<msg::TrackedPeople>()));
  streams.push_back(repeated(side, topic::kTeammates, 5.0, teammate));
  return streams;
}

Streams of_the_laptop(Side& side, bool driving) {
  Streams streams;
  for (int i = 0; i < 4; ++i) streams.push_back(repeated(side, topic::kServiceHealth, 1.0, health_of("laptop", i)));
  if (!driving) return streams;
  auto plan = of_robot<msg::TeamPlan>();
  plan.reason(std::string(4900, 'x'));
  streams.push_back(repeated(side, topic::kTeamPlan, 1.0, plan));
  return streams;
}

/// A program on the laptop that reads all that the robot sends. By default each is a participant on the link.
struct Reader {
  Side* side;
  std::unique_ptr<Side> own;
  std::vector<Listener> listeners;
  Reader(Side& shared, std::unique_ptr<Side> participant)
      : side(participant ? participant.get() : &shared), own(std::move(participant)) {
    for (const TopicInfo& topic :
         {info_of(topic::kBaseStatus), info_of(topic::kPlanExecution), info_of(topic::kServiceHealth),
          info_of(topic::kOdometry), info_of(topic::kRobotPose), info_of(topic::kScan), info_of(topic::kPeople),
          info_of(topic::kTeammates)}) {
      listeners.emplace_back(*side, topic);
    }
  }
};

}  // namespace

Figures cost(const std::string& whose, const std::string& air, int run, int readers, bool driving) {
  test::Laboratory lab{{"robot", "laptop"}, seed_of(run)};
  lab.set_all(conditions_of(air));
  const auto robot = make_side(whose, lab.host("robot"), lab.host("laptop").address());
  const auto laptop = make_side(whose, lab.host("laptop"), lab.host("robot").address());
  std::vector<Reader> all_readers;
  for (int i = 0; i < readers; ++i) {
    const bool further_participant = whose == "default" && i > 0;
    all_readers.emplace_back(*laptop, further_participant ? make_side(whose, lab.host("laptop"), "") : nullptr);
  }
  Listener plans{*robot, info_of(topic::kTeamPlan)};
  const Streams from_robot = of_the_robot(*robot, driving);
  const Streams from_laptop = of_the_laptop(*laptop, driving);
  pause(seconds{6});  // discovery is over
  const auto robot_before = lab.count("robot").bytes_sent;
  const auto laptop_before = lab.count("laptop").bytes_sent;
  const double robot_cpu_before = robot->cpu_s();
  const double laptop_cpu_before = laptop->cpu_s();
  pause(from_seconds(kSeconds));
  const auto rate = [](std::uint64_t now, std::uint64_t before) {
    return static_cast<double>(now - before) / 1e3 / kSeconds;
  };
  return {{"robot_kBps", rate(lab.count("robot").bytes_sent, robot_before)},
          {"laptop_kBps", rate(lab.count("laptop").bytes_sent, laptop_before)},
          {"robot_cpu", (robot->cpu_s() - robot_cpu_before) / kSeconds},
          {"laptop_cpu", (laptop->cpu_s() - laptop_cpu_before) / kSeconds}};
}

}  // namespace tandem::bench
