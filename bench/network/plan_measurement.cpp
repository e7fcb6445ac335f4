#include "bench/network/airs.hpp"
#include "bench/network/measurements.hpp"
#include "bench/network/quantiles.hpp"
#include "bench/network/stream.hpp"

namespace tandem::bench {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kPlans = 20;
constexpr double kPoseRate_hz = 10.0;

msg::TeamPlan plan_of_5_kB(int number) {
  msg::TeamPlan plan;
  plan.robot("robot1");
  plan.sequence_number(static_cast<std::uint64_t>(number));
  plan.reason(std::string(4900, 'x'));
  return plan;
}

/// What became of the poses that arrived, of `sent`.
Figures pose_figures(const std::vector<bus::RawSample>& arrived, std::uint64_t sent) {
  double longest_gap_ms = 0.0;
  int stale = 0;
  std::int64_t last_number = -1;
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    if (i > 0) longest_gap_ms = std::max(longest_gap_ms, to_ms(arrived[i].received - arrived[i - 1].received));
    const auto pose = bus::decode<msg::RobotPosePubSubType>(arrived[i].payload);
    if (!pose) continue;
    const bool late = arrived[i].received - from_stamp_ns(pose->stamp_ns()) > seconds{1};
    const auto number = static_cast<std::int64_t>(pose->odometry_epoch());
    stale += late || number <= last_number ? 1 : 0;
    last_number = number;
  }
  return {{"pose_delivered", static_cast<double>(arrived.size()) / static_cast<double>(sent)},
          {"pose_gap_ms", longest_gap_ms},
          {"pose_stale", stale}};
}

}  // namespace

Figures plan_and_pose(const std::string& whose, const std::string& air, int run) {
  test::Laboratory lab{{"robot", "laptop"}, seed_of(run)};
  const auto robot = make_side(whose, lab.host("robot"), lab.host("laptop").address());
  const auto laptop = make_side(whose, lab.host("laptop"), lab.host("robot").address());
  const auto plans_out = laptop->writer(info_of(topic::kTeamPlan));
  Listener plans_in{*robot, info_of(topic::kTeamPlan)};
  Listener poses_in{*laptop, info_of(topic::kRobotPose)};
  const auto poses_out = pose_stream(*robot, kPoseRate_hz);
  const auto key = bus::key_of<msg::TeamPlanPubSubType>(plan_of_5_kB(0));
  const auto write = [&](int number) {
    plans_out->write(bus::encode<msg::TeamPlanPubSubType>(plan_of_5_kB(number)), key);
  };
  // Both ways known before the loss begins.
  write(-1);
  holds_within(seconds{30}, [&] { return !plans_in.arrivals->take().empty(); });
  std::ignore = ms_to_next_pose(poses_in, seconds{30});

  lab.set_all(conditions_of(air));
  const SteadyClock clock;
  const std::uint64_t first_pose = poses_out->sent();
  std::ignore = poses_in.arrivals->take();
  std::vector<Time> written;
  std::vector<double> latencies(kPlans, kNever);
  const auto read = [&] {
    for (const auto& sample : plans_in.arrivals->take()) {
      const auto plan = bus::decode<msg::TeamPlanPubSubType>(sample.payload);
      if (!plan || plan->sequence_number() >= kPlans) continue;
      for (std::size_t i = 0; i <= plan->sequence_number(); ++i) {  // a newer plan stands for the older
        latencies[i] = std::min(latencies[i], to_ms(sample.received - written[i]));
      }
    }
    return false;
  };
  for (int i = 0; i < kPlans; ++i) {
    written.push_back(clock.now());
    write(i);
    holds_within(seconds{1}, read);
  }
  Figures figures = pose_figures(poses_in.arrivals->take(), poses_out->sent() - first_pose);
  holds_within(seconds{20}, [&] {
    read();
    return latencies.back() < kNever;
  });
  figures["plan_p50_ms"] = observed_quantile(latencies, 0.5, kNever);
  figures["plan_max_ms"] = observed_quantile(latencies, 1.0, kNever);
  return figures;
}

}  // namespace tandem::bench
