#include "bench/network/report.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "bench/network/airs.hpp"
#include "bench/network/figures.hpp"
#include "bench/planning/report/plot.hpp"
#include "bench/planning/statistics/statistics.hpp"

namespace tandem::bench {
namespace {

struct Row {
  std::string figure;
  std::string label;
};
struct Table {
  std::string what;
  std::string title;
  std::string text;
  std::vector<Row> rows;
};

const std::vector<Table>& tables() {
  static const std::vector<Table> all{
      {"map300",
       "C1. A map of 300 kB to a reader that joins late",
       "From match to data, on the link alone; given up after 20 s. 300 kB is a map as it lies in memory.",
       {{"ms", "ms"}, {"sent_kB", "kB sent"}}},
      {"map60", "C1. The same with 60 kB, as maps are shipped at most", "", {{"ms", "ms"}, {"sent_kB", "kB sent"}}},
      {"map300_odometry",
       "C1. Odometry (50 Hz) while 300 kB pass",
       "One-way latency of the stream from the moment the reader joins until it has the map.",
       {{"ms", "map, ms"}, {"odometry_p99_ms", "odometry p99, ms"}, {"odometry_delivered", "odometry delivered"}}},
      {"message",
       "C2. A message from the laptop to the robot and its receipt",
       "60 messages a run, 150 ms apart; ours through both relays and with the repetitions of an Event. Round trip.",
       {{"p50_ms", "p50, ms"},
        {"p99_ms", "p99, ms"},
        {"max_ms", "longest, ms"},
        {"unanswered", "unanswered after 20 s"},
        {"lost", "not applied"},
        {"applied_twice", "applied twice"}}},
      {"plan",
       "C3. A plan of 5 kB each second, and the pose at 10 Hz",
       "20 plans a run; until the plan or a newer one is there. Stale: a pose older than 1 s or out of order.",
       {{"plan_p50_ms", "plan p50, ms"},
        {"plan_max_ms", "plan longest, ms"},
        {"pose_delivered", "poses delivered"},
        {"pose_gap_ms", "longest gap, ms"},
        {"pose_stale", "stale poses"}}},
      {"first_data",
       "C4. First data after the start",
       "From the start of the laptop's side (ours: program start of its relay) to the first pose of a robot that is "
       "there.",
       {{"ms", "ms"}}},
      {"outage", "C4. First data after 30 s without a frame", "", {{"ms", "ms"}}},
      {"address",
       "C4. First data after the robot's address changed",
       "Poses of the robot on the laptop, plans of the laptop on the robot. Given up after 20 s.",
       {{"to_laptop_ms", "to the laptop, ms"}, {"to_robot_ms", "to the robot, ms"}}},
      {"cost_idle",
       "C5. Cost of standing by",
       "States and health of 7 and 4 services. CPU: share of a core, of each relay.",
       {{"robot_kBps", "robot sends, kB/s"},
        {"laptop_kBps", "laptop sends, kB/s"},
        {"robot_cpu", "robot's relay, CPU"},
        {"laptop_cpu", "laptop's relay, CPU"}}},
      {"cost_driving1",
       "C5. Cost of driving, one reader on the laptop",
       "Odometry and pose at 20 Hz, scan (682 beams) and people at 10 Hz, teammates at 5 Hz, a plan of 5 kB at 1 Hz.",
       {{"robot_kBps", "robot sends, kB/s"},
        {"laptop_kBps", "laptop sends, kB/s"},
        {"robot_cpu", "robot's relay, CPU"},
        {"laptop_cpu", "laptop's relay, CPU"}}},
      {"cost_driving5",
       "C5. Cost of driving, five readers on the laptop",
       "By default each is a participant on the link.",
       {{"robot_kBps", "robot sends, kB/s"},
        {"laptop_kBps", "laptop sends, kB/s"},
        {"robot_cpu", "robot's relay, CPU"}}},
      {"team_cost",
       "C5. Cost of a whole team on simulated hardware",
       "All services of robot and laptop. Driving: a search, without a person; idle: when it is over. CPU: share of a "
       "core, of all services of the robot and its relay, without the simulator.",
       {{"idle_robot_kBps", "idle: robot sends, kB/s"},
        {"idle_laptop_kBps", "idle: laptop sends, kB/s"},
        {"idle_cpu", "idle: robot's services, CPU"},
        {"driving_robot_kBps", "driving: robot sends, kB/s"},
        {"driving_laptop_kBps", "driving: laptop sends, kB/s"},
        {"driving_cpu", "driving: robot's services, CPU"},
        {"driving_cpu_localization", "of it localization"},
        {"driving_cpu_navigator", "of it navigator"},
        {"driving_cpu_tracker", "of it tracker"},
        {"driving_cpu_base", "of it base"},
        {"driving_cpu_laser", "of it laser"},
        {"driving_cpu_relay", "of it relay"},
        {"driving_cpu_recorder", "of it recorder"}}},
      {"false_stops",
       "N5. False stops",
       "Four robots of four teams search at once. A false stop begins when the base holds its robot back for a "
       "reason "
       "that is not there, or when the navigator has not heard of its plan for too long. Where nearly all of the cores "
       "are in use, a stop may be this machine's.",
       {{"false_stops", "false stops of the base"},
        {"without_plan", "stops for want of a plan"},
        {"driven_h", "robot hours with turning wheels"},
        {"watched_h", "robot hours watched"},
        {"busy", "share of the cores in use"}}},
      {"long_outage",
       "N3. Five minutes without a frame",
       "Of a whole team whose robot drives. Memory: of all services of the robot, from 20 s after the beginning of the "
       "outage to its end.",
       {{"processes_ended", "processes that ended"},
        {"ms", "first pose on the laptop, ms"},
        {"drives_again_s", "drives again, when resumed, s"},
        {"memory_MB", "memory, MB"},
        {"growth_MB", "more memory, MB"},
        {"most_growth_MB", "more memory of one service, MB"}}},
  };
  return all;
}

std::vector<std::string> airs_of(const Records& records, const std::string& what) {
  std::vector<std::string> airs;
  for (const auto& record : records) {
    if (record.key.what != what) continue;
    if (std::find(airs.begin(), airs.end(), record.key.air) == airs.end()) airs.push_back(record.key.air);
  }
  return airs;
}

/// Whole teams are ours alone.
std::vector<std::string> whose_in(const Records& records, const std::string& what) {
  std::vector<std::string> all;
  for (const char* whose : {"ours", "default"}) {
    const auto is_of = [&](const NetworkRecord& record) {
      return record.key.what == what && record.key.whose == whose;
    };
    if (std::any_of(records.begin(), records.end(), is_of)) all.emplace_back(whose);
  }
  return all;
}

/// In how many runs the measurements of a table were made: "5 runs.", or "3 to 4 runs."
std::string text_of_runs(const Records& records, const std::string& what) {
  std::map<std::pair<std::string, std::string>, int> runs;
  for (const auto& record : records) {
    if (record.key.what == what) runs[{record.key.whose, record.key.air}] += record.figures.empty() ? 0 : 1;
  }
  const auto [low, high] = std::minmax_element(
      runs.begin(), runs.end(), [](const auto& one, const auto& other) { return one.second < other.second; });
  const std::string most = std::to_string(high->second) + (high->second == 1 ? " run." : " runs.");
  return low->second == high->second ? most : std::to_string(low->second) + " to " + most;
}

/// "0 false stops in 0.41 h of driving: ..."; empty if none were counted.
std::string text_of_false_stops(const Records& records) {
  const FalseStopSum sum = false_stop_sum(records);
  if (sum.driven_h <= 0.0) return "";
  const std::string said =
      text_of_number(sum.stops) + " false stops in " + text_of_number(sum.driven_h) + " h of driving";
  if (sum.stops > 0.0) return said + ", " + text_of_number(sum.stops / sum.driven_h) + " an hour.";
  // No event in a time t: a rate above 3 / t would have shown itself with a probability of 95 %.
  return said + ": less than " + text_of_number(3.0 / sum.driven_h) + " an hour, with 95 % confidence.";
}

std::string text_of_table(const Records& records, const Table& table) {
  const auto airs = airs_of(records, table.what);
  if (airs.empty()) return "";
  std::string text = "\n## " + table.title + "\n\n" + (table.text.empty() ? "" : table.text + " ") +
                     text_of_runs(records, table.what) + "\n\n";
  if (table.what == "false_stops") text += text_of_false_stops(records) + "\n\n";
  text += "| | |";
  for (const auto& air : airs) text += " " + title_of(air) + " |";
  text += "\n|---|---|";
  for (std::size_t i = 0; i < airs.size(); ++i) text += "---|";
  for (const auto& row : table.rows) {
    for (const std::string& whose : whose_in(records, table.what)) {
      text += "\n| " + row.label + " | " + whose + " |";
      for (const auto& air : airs) {
        text += " " + text_of_values(values_of(records, table.what, whose, air, row.figure)) + " |";
      }
    }
  }
  return text + "\n";
}

std::string plot_of(const Records& records, const std::string& what, const std::string& figure,
                    const std::string& title, const std::string& label) {
  std::vector<Curve> curves;
  for (const char* whose : {"ours", "default"}) {
    Curve curve{whose, {}};
    for (const int loss : {0, 5, 10, 20, 30}) {
      const std::string air = loss == 0 ? "clean" : "loss" + std::to_string(loss);
      const auto values = values_of(records, what, whose, air, figure);
      if (values.empty() || quantile(values, 0.5) >= kNever) continue;
      curve.points.emplace_back(loss, std::max(0.1, quantile(values, 0.5)));
    }
    if (!curve.points.empty()) curves.push_back(curve);
  }
  return curves.empty() ? ""
                        : plotted(curves, {.title = title,
                                           .x_label = "loss each way [%]",
                                           .y_label = label,
                                           .x_logarithmic = false,
                                           .y_logarithmic = true});
}

}  // namespace

std::map<std::string, std::string> network_report(const std::vector<NetworkRecord>& records,
                                                  const NetworkRunInfo& info) {
  const auto failed =
      std::count_if(records.begin(), records.end(), [](const auto& record) { return record.figures.empty(); });
  std::string text =
      "# The link, beside Fast DDS's defaults\n\n" + info.date + ", commit " + info.commit + ", " + info.machine +
      ".\n\n    " + info.command +
      "\n\nTwo hosts as network namespaces; the air between them loses, each frame on its own and in each direction, "
      "or "
      "is dead for 300 ms of every second (bursts), or carries 2 Mbit/s with a queue of 300 ms and bursts of 16 KiB at "
      "once. *default* is Fast DDS "
      "2.9.1 as it comes, but over UDP alone, with the reliability, durability and depth that the data need. Median "
      "(lowest to highest) of the runs, of which each table tells the number. " +
      std::to_string(failed) + " of " + std::to_string(records.size()) +
      " measurements failed.\n\n## Targets\n\nOf ours: the median of the runs, or the worst run where the target is an "
      "upper bound for all.\n\n" +
      network_targets(records);
  for (const auto& table : tables()) text += text_of_table(records, table);

  std::map<std::string, std::string> files;
  const auto add_plot = [&](const std::string& name, const std::string& what, const std::string& figure,
                            const std::string& title, const std::string& label) {
    const std::string picture = plot_of(records, what, figure, title, label);
    if (picture.empty()) return;
    files[name] = picture;
    text += "\n![" + title + "](" + name + ")\n";
  };
  add_plot("map300.svg", "map300", "ms", "300 kB to a late joiner (median)", "ms");
  add_plot("message.svg", "message", "p99_ms", "Message and receipt, p99 (median of runs)", "ms");
  add_plot("plan.svg", "plan", "plan_max_ms", "Longest of 20 plans of 5 kB (median of runs)", "ms");
  add_plot("first_data.svg", "first_data", "ms", "First data after the start (median)", "ms");
  files["REPORT.md"] = text;
  return files;
}

}  // namespace tandem::bench
