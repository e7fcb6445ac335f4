#include "bench/network/campaign.hpp"

#include <array>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/network/measurements.hpp"
#include "tests/network/lab/network_namespace.hpp"

namespace tandem::bench {
namespace {

using Airs = std::vector<std::string>;

struct Part {
  std::string what;
  Airs airs;
  Airs quick_airs;
  std::function<Figures(const NetworkKey&)> measure;
  bool of_whole_team = false;  ///< of ours alone, and with the machine for itself
  int most_runs = 100;
};

/// A measurement that needs no more than a name, an air and a number.
auto by(Figures (*measure)(const std::string& whose, const std::string& air, int run)) {
  return [measure](const NetworkKey& key) { return measure(key.whose, key.air, key.run); };
}

const std::vector<Part>& parts() {
  static const Airs kAll{"clean", "loss5", "loss10", "loss20", "loss30", "bursts", "2M", "2M+loss10"};
  static const Airs kLossy{"clean", "loss10", "loss20", "loss30", "bursts"};
  static const std::vector<Part> all{
      {"map300",
       kAll,
       {"loss10", "loss20", "2M"},
       [](const NetworkKey& key) { return map_to_late_joiner(key.whose, key.air, key.run, 300'000, false); }},
      {"map60",
       kAll,
       {"loss20", "loss30", "2M"},
       [](const NetworkKey& key) { return map_to_late_joiner(key.whose, key.air, key.run, 60'000, false); }},
      {"map300_odometry",
       {"2M", "2M+loss10"},
       {"2M"},
       [](const NetworkKey& key) { return map_to_late_joiner(key.whose, key.air, key.run, 300'000, true); }},
      {"message", kLossy, {"clean", "loss20", "loss30"}, by(messages)},
      {"plan", {"clean", "loss10", "loss20", "loss30", "bursts", "2M"}, {"clean", "loss30"}, by(plan_and_pose)},
      {"first_data",
       {"clean", "no_multicast", "loss10", "loss30"},
       {"clean", "no_multicast", "loss30"},
       by(first_data)},
      {"outage", {"clean", "loss20"}, {"clean"}, by(after_outage)},
      {"address", {"clean", "loss20"}, {"clean"}, by(after_address_change)},
      {"cost_idle",
       {"clean"},
       {"clean"},
       [](const NetworkKey& key) { return cost(key.whose, key.air, key.run, 1, false); }},
      {"cost_driving1",
       {"clean", "loss20"},
       {"clean"},
       [](const NetworkKey& key) { return cost(key.whose, key.air, key.run, 1, true); }},
      {"cost_driving5",
       {"clean"},
       {"clean"},
       [](const NetworkKey& key) { return cost(key.whose, key.air, key.run, 5, true); }},
      {"team_cost", {"clean"}, {"clean"}, [](const NetworkKey& key) { return team_cost(key.air); }, true},
      {"false_stops",
       {"loss30+bursts"},
       {"loss30+bursts"},
       [](const NetworkKey& key) { return false_stops(key.air, key.run); },
       true},
      {"long_outage", {"clean"}, {"clean"}, [](const NetworkKey& key) { return long_outage(key.air); }, true, 1},
  };
  return all;
}

}  // namespace

std::vector<NetworkRequest> network_campaign(int runs, bool quick) {
  std::vector<NetworkRequest> requests;
  // Run by run: one that was stopped early has a little of everything, and ours stands beside the default.
  for (int run = 1; run <= runs; ++run) {
    for (const auto& part : parts()) {
      if (run > part.most_runs) continue;
      for (const auto& air : quick ? part.quick_airs : part.airs) {
        requests.push_back({{part.what, "ours", air, run}, part.of_whole_team});
        if (!part.of_whole_team) requests.push_back({{part.what, "default", air, run}});
      }
    }
  }
  return requests;
}

Figures measured_here(const NetworkKey& key) {
  if (const std::string reason = test::isolate_network(); !reason.empty()) {
    throw std::runtime_error("the laboratory cannot run: " + reason);
  }
  for (const auto& part : parts()) {
    if (part.what == key.what) return part.measure(key);
  }
  throw std::invalid_argument("nothing is called " + key.what);
}

NetworkRecord measured_apart(const NetworkRequest& request, const std::filesystem::path& program,
                             const std::filesystem::path& log) {
  const auto& key = request.key;
  // A measurement that hangs must not hold up the others.
  const std::string command = "timeout -k 5 600 '" + program.string() + "' cell " + key.what + " " + key.whose + " " +
                              key.air + " " + std::to_string(key.run) + " 2>>'" + log.string() + "'";
  NetworkRecord record{key, {}};
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) return record;
  std::string said;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), part.size(), output) != nullptr) said += part.data();
  if (pclose(output) != 0) return record;
  const auto json = nlohmann::json::parse(said, nullptr, false);
  if (!json.is_discarded()) record.figures = json.get<Figures>();
  return record;
}

std::string text_of(const Figures& figures) {
  return nlohmann::json(figures).dump();
}

}  // namespace tandem::bench
