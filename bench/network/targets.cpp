#include <algorithm>
#include <optional>

#include "bench/network/figures.hpp"
#include "bench/network/report.hpp"
#include "bench/planning/statistics/statistics.hpp"

namespace tandem::bench {
namespace {

/// A limit for one of our figures.
struct Target {
  std::string text;
  std::string what;
  std::vector<std::string> airs;
  std::string figure;
  double limit;
  enum class Of { Median, Worst, LeastMedian, PerHourDriven } of = Of::Worst;
};

const std::vector<Target>& targets() {
  using Of = Target::Of;
  static const std::vector<Target> all{
      {"C1: 300 kB up to 20 % loss, at 2 Mbit/s, ms",
       "map300",
       {"clean", "loss5", "loss10", "loss20", "2M"},
       "ms",
       3000,
       Of::Median},
      {"C1: 300 kB at 30 % loss, ms", "map300", {"loss30"}, "ms", 12000, Of::Median},
      {"C1: 60 kB everywhere, ms",
       "map60",
       {"clean", "loss5", "loss10", "loss20", "loss30", "bursts", "2M", "2M+loss10"},
       "ms",
       3000},
      {"C1: odometry p99 meanwhile at 2 Mbit/s, ms", "map300_odometry", {"2M"}, "odometry_p99_ms", 10, Of::Median},
      {"C2: messages not applied", "message", {"clean", "loss10", "loss20", "loss30", "bursts"}, "lost", 0},
      {"C2: messages applied twice", "message", {"clean", "loss10", "loss20", "loss30", "bursts"}, "applied_twice", 0},
      {"C2: message p99 at 20 % loss, ms", "message", {"loss20"}, "p99_ms", 300, Of::Median},
      {"C2: message p99 at 30 % loss, ms", "message", {"loss30"}, "p99_ms", 900, Of::Median},
      {"C3: longest of 20 plans at 30 % loss, ms", "plan", {"loss30"}, "plan_max_ms", 1000, Of::Median},
      {"C3: poses delivered at 20 % loss, at least", "plan", {"loss20"}, "pose_delivered", 0.78, Of::LeastMedian},
      {"C3: poses delivered at 30 % loss, at least", "plan", {"loss30"}, "pose_delivered", 0.68, Of::LeastMedian},
      {"C3: stale poses", "plan", {"clean", "loss10", "loss20", "loss30", "bursts", "2M"}, "pose_stale", 0},
      {"C4: first data, also without multicast, ms", "first_data", {"clean", "no_multicast"}, "ms", 1000},
      {"C4: first data at 30 % loss, median, ms", "first_data", {"loss30"}, "ms", 4000, Of::Median},
      {"C4: first data at 30 % loss, longest, ms", "first_data", {"loss30"}, "ms", 10000},
      {"C4: after an outage of 30 s, ms", "outage", {"clean"}, "ms", 2000},
      {"C4: after a change of address, to the laptop, ms", "address", {"clean"}, "to_laptop_ms", 5000},
      {"C4: the same, to the robot, ms", "address", {"clean"}, "to_robot_ms", 5000},
      {"C5: robot sends while driving, kB/s", "cost_driving1", {"clean"}, "robot_kBps", 25, Of::Median},
      {"C5: the same with five readers, kB/s", "cost_driving5", {"clean"}, "robot_kBps", 25, Of::Median},
      {"C5: robot's relay while driving, share of a core", "cost_driving1", {"clean"}, "robot_cpu", 0.05, Of::Median},
      {"C5: whole robot, idle, share of a core", "team_cost", {"clean"}, "idle_cpu", 0.05, Of::Median},
      {"C5: whole robot, idle, sends, kB/s", "team_cost", {"clean"}, "idle_robot_kBps", 25, Of::Median},
      {"C5: whole robot, driving, sends, kB/s", "team_cost", {"clean"}, "driving_robot_kBps", 25, Of::Median},
      {"N5: false stops an hour at 30 % loss with bursts",
       "false_stops",
       {"loss30+bursts"},
       "false_stops",
       1,
       Of::PerHourDriven},
      {"N3: processes that ended in an outage of 5 min", "long_outage", {"clean"}, "processes_ended", 0},
      {"N3: more memory of one service in it, MB", "long_outage", {"clean"}, "most_growth_MB", 1},
      {"N3: first data after it, ms", "long_outage", {"clean"}, "ms", 3000},
  };
  return all;
}

/// The figure that counts for a target; nothing if it was not measured.
std::optional<double> counted(const Records& records, const Target& target, const std::string& whose) {
  std::optional<double> worst;
  if (target.of == Target::Of::PerHourDriven) {
    const FalseStopSum sum = false_stop_sum(records);
    if (whose == "ours" && sum.driven_h > 0.0) worst = sum.stops / sum.driven_h;
    return worst;
  }
  for (const auto& air : target.airs) {
    const auto values = values_of(records, target.what, whose, air, target.figure);
    if (values.empty()) continue;
    const double value =
        target.of == Target::Of::Worst ? *std::max_element(values.begin(), values.end()) : quantile(values, 0.5);
    worst = target.of == Target::Of::LeastMedian ? std::min(value, worst.value_or(value))
                                                 : std::max(value, worst.value_or(value));
  }
  return worst;
}

}  // namespace

std::string network_targets(const std::vector<NetworkRecord>& records) {
  std::string text = "| target | limit | ours | default | met |\n|---|---|---|---|---|\n";
  for (const auto& target : targets()) {
    const auto ours = counted(records, target, "ours");
    const auto theirs = counted(records, target, "default");
    const bool met = ours && (target.of == Target::Of::LeastMedian ? *ours >= target.limit : *ours <= target.limit);
    text += "| " + target.text + " | " + text_of_number(target.limit) + " | " + (ours ? text_of_number(*ours) : "–") +
            " | " + (theirs ? text_of_number(*theirs) : "–") + " | " +
            (!ours ? "not measured"
             : met ? "yes"
                   : "**no**") +
            " |\n";
  }
  return text;
}

}  // namespace tandem::bench
