#include "bench/network/report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "bench/network/airs.hpp"
#include "bench/network/quantiles.hpp"
#include "bench/planning/report/plot.hpp"

namespace tandem::bench {
namespace {

using Records = std::vector<NetworkRecord>;

/// One figure over all runs of a measurement.
std::vector<double> values_of(const Records& records, const std::string& what, const std::string& whose,
                              const std::string& air, const std::string& figure) {
  std::vector<double> values;
  for (const auto& record : records) {
    const auto& key = record.key;
    if (key.what != what || key.whose != whose || key.air != air) continue;
    const auto found = record.figures.find(figure);
    if (found != record.figures.end()) values.push_back(found->second);
  }
  return values;
}

std::string text_of_number(double value) {
  if (value >= kNever) return "never";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(),
                value >= 100.0 || value == 0.0 ? "%.0f"
                : value >= 1.0                 ? "%.1f"
                                               : "%.3f",
                value);
  return text.data();
}

/// "median (lowest to highest)".
std::string text_of_values(const std::vector<double>& values) {
  if (values.empty()) return "–";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string median = text_of_number(quantile(values, 0.5));
  if (values.size() == 1 || *low == *high) return median;
  return median + " (" + text_of_number(*low) + " to " + text_of_number(*high) + ")";
}

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
      {"address", "C4. First data after the robot's address changed", "Given up after 20 s.", {{"ms", "ms"}}},
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

std::string text_of_table(const Records& records, const Table& table) {
  const auto airs = airs_of(records, table.what);
  if (airs.empty()) return "";
  std::string text = "\n## " + table.title + "\n\n" + (table.text.empty() ? "" : table.text + "\n\n") + "| | |";
  for (const auto& air : airs) text += " " + title_of(air) + " |";
  text += "\n|---|---|";
  for (std::size_t i = 0; i < airs.size(); ++i) text += "---|";
  for (const auto& row : table.rows) {
    for (const char* whose : {"ours", "default"}) {
      text += "\n| " + row.label + " | " + whose + " |";
      for (const auto& air : airs) {
        text += " " + text_of_values(values_of(records, table.what, whose, air, row.figure)) + " |";
      }
    }
  }
  return text + "\n";
}

/// A limit for one of our figures.
struct Target {
  std::string text;
  std::string what;
  std::vector<std::string> airs;
  std::string figure;
  double limit;
  enum class Of { Median, Worst, LeastMedian } of = Of::Worst;
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
      {"C4: after a change of address, ms", "address", {"clean"}, "ms", 5000},
      {"C5: robot sends while driving, kB/s", "cost_driving1", {"clean"}, "robot_kBps", 25, Of::Median},
      {"C5: the same with five readers, kB/s", "cost_driving5", {"clean"}, "robot_kBps", 25, Of::Median},
      {"C5: robot's relay while driving, share of a core", "cost_driving1", {"clean"}, "robot_cpu", 0.05, Of::Median},
  };
  return all;
}

/// The figure that counts for a target; nothing if it was not measured.
std::optional<double> counted(const Records& records, const Target& target, const std::string& whose) {
  std::optional<double> worst;
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

std::map<std::string, std::string> network_report(const std::vector<NetworkRecord>& records,
                                                  const NetworkRunInfo& info) {
  int runs = 0;
  for (const auto& record : records) runs = std::max(runs, record.key.run);
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
      "(lowest to highest) of " +
      std::to_string(runs) + " runs. " + std::to_string(failed) + " of " + std::to_string(records.size()) +
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
