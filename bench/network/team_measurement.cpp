#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>

#include "bench/network/airs.hpp"
#include "bench/network/measurements.hpp"
#include "bench/network/quantiles.hpp"
#include "bench/network/stream.hpp"
#include "services/bus/events.hpp"
#include "tests/network/team_on_the_air.hpp"
#include "tests/support/process_use.hpp"

namespace tandem::bench {
namespace {

using cli::Episode;
using std::chrono::seconds;

// Every laboratory is a world of its own: any domain is free in it, and each host has a loopback interface of its own.
constexpr int kHostDomain = 1;
constexpr int kLinkDomain = 2;
constexpr double kTurning_mps = 0.02;
constexpr Duration kUntilItDrives = seconds{90};

std::string robot_of(int team) {
  return "robot" + std::to_string(team);
}
std::string laptop_of(int team) {
  return "laptop" + std::to_string(team);
}

std::vector<std::string> hosts_of(int teams) {
  std::vector<std::string> hosts;
  for (int team = 1; team <= teams; ++team) {
    hosts.push_back(robot_of(team));
    hosts.push_back(laptop_of(team));
  }
  return hosts;
}

/// A whole team without a person, so that its robot searches a large place for longer than anything here takes.
std::unique_ptr<test::SimulatedTeam> make_team(test::Laboratory& lab, int team, std::uint64_t seed) {
  auto options = test::team_on(lab, robot_of(team), laptop_of(team));
  options.scenario = "brl";
  options.agent = "person" + std::to_string(team);
  options.seed = seed;
  options.play = true;
  options.robot_domain = kHostDomain;
  options.laptop_domain = kHostDomain;
  options.link_domain = kLinkDomain;
  return std::make_unique<test::SimulatedTeam>(options);
}

bool is_driving(const test::SimulatedTeam& team) {
  return team.wheel_speed_mps().value_or(0.0) > kTurning_mps;
}

/// Leads the team's search for `duration`. False if a process ended.
bool lead(test::SimulatedTeam& team, Duration duration) {
  const SteadyClock clock;
  const Time end = clock.now() + duration;
  return team.run_until(duration + seconds{10}, [&] { return clock.now() >= end; });
}

using Uses = std::map<std::string, double>;

/// By service of the team's robot.
Uses memory_MB(const test::SimulatedTeam& team, int number) {
  Uses uses;
  for (const auto& service : team.services(robot_of(number))) {
    uses[service] = test::memory_MB_of(*team.process(robot_of(number), service));
  }
  return uses;
}

Uses cpu_s(const test::SimulatedTeam& team, int number) {
  Uses uses;
  for (const auto& service : team.services(robot_of(number))) {
    uses[service] = test::cpu_s_of(*team.process(robot_of(number), service));
  }
  return uses;
}

/// What a team costs while `stay` lasts, its figures called `name`_...
void add_cost(Figures& figures, const std::string& name, test::Laboratory& lab, const test::SimulatedTeam& team,
              Duration duration, const std::function<void()>& stay) {
  const Uses before_s = cpu_s(team, 1);
  const auto robot_before = lab.count(robot_of(1)).bytes_sent;
  const auto laptop_before = lab.count(laptop_of(1)).bytes_sent;
  stay();
  const auto kBps = [&](const std::string& host, std::uint64_t before) {
    return static_cast<double>(lab.count(host).bytes_sent - before) / 1e3 / to_seconds(duration);
  };
  figures[name + "_robot_kBps"] = kBps(robot_of(1), robot_before);
  figures[name + "_laptop_kBps"] = kBps(laptop_of(1), laptop_before);
  for (const auto& [service, used_s] : cpu_s(team, 1)) {
    const double share = (used_s - before_s.at(service)) / to_seconds(duration);
    figures[name + "_cpu"] += share;
    figures[name + "_cpu_" + service] = share;
  }
}

msg::ResumeRequest resume_request(const Clock& clock) {
  msg::ResumeRequest request;
  request.robot(robot_of(1));
  request.id(bus::new_event_id("bench", clock));
  request.held_ms(2000);
  return request;
}

/// Time that all cores of this machine were busy, and that they had, so far [s].
struct CoreTime {
  double busy = 0.0;
  double all = 0.0;
};
CoreTime core_time() {
  std::ifstream file{"/proc/stat"};
  std::string name;
  file >> name;
  CoreTime time;
  double part = 0.0;
  for (int i = 0; i < 8 && file >> part; ++i) {
    const bool idle = i == 3 || i == 4;  // idle, and waiting for a disk
    time.all += part;
    time.busy += idle ? 0.0 : part;
  }
  return time;
}

}  // namespace

Figures team_cost(const std::string& air) {
  constexpr Duration kDriving = seconds{20};
  constexpr Duration kIdle = seconds{15};
  test::Laboratory lab{hosts_of(1)};
  lab.set_all(conditions_of(air));
  const auto team = make_team(lab, 1, 1);
  Figures figures;
  if (!team->run_until(kUntilItDrives, [&] { return is_driving(*team); })) return figures;
  add_cost(figures, "driving", lab, *team, kDriving, [&] { std::ignore = lead(*team, kDriving); });
  team->episode().abort("enough");
  std::ignore = lead(*team, seconds{5});
  add_cost(figures, "idle", lab, *team, kIdle, [&] { std::ignore = lead(*team, kIdle); });
  return team->unexpected_ends().empty() ? figures : Figures{};
}

Figures false_stops(const std::string& air, int run) {
  constexpr int kTeams = 4;
  constexpr Duration kWatched = seconds{110};
  test::Laboratory lab{hosts_of(kTeams), seed_of(run)};
  struct Watched {
    std::unique_ptr<test::SimulatedTeam> team;
    std::unique_ptr<test::FalseStops> stops;
    double driving_s = 0.0;
  };
  std::vector<Watched> all;
  for (int i = 1; i <= kTeams; ++i) {
    auto team = make_team(lab, i, static_cast<std::uint64_t>(run * kTeams + i));
    auto stops = std::make_unique<test::FalseStops>(*team);
    all.push_back({std::move(team), std::move(stops)});
  }
  const SteadyClock clock;
  Time last = clock.now();
  const auto each_listens = [&](const auto& also) {
    const Time now = clock.now();
    const double passed_s = to_seconds(now - last);
    last = now;
    bool all_hold = true;
    for (auto& one : all) {
      if (!one.team->run_until(seconds{1}, [] { return true; })) return true;  // a process ended
      one.stops->listen();
      all_hold = also(one, passed_s) && all_hold;
    }
    return all_hold;
  };
  auto& first = *all.front().team;
  const bool all_run = first.run_until(kUntilItDrives, [&] {
    return each_listens([](const auto& one, double) { return one.team->episode().phase() == Episode::Phase::Running; });
  });
  if (!all_run) return {};

  // The search has begun on a good air; how long a beginning on a bad one takes is measured elsewhere.
  lab.set_all(conditions_of(air));
  const CoreTime cores_before = core_time();
  const Time end = clock.now() + kWatched;
  const auto watch = [&](auto& one, double passed_s) {
    if (is_driving(*one.team)) one.driving_s += passed_s;
    return clock.now() >= end;
  };
  std::ignore = first.run_until(kWatched + seconds{20}, [&] { return each_listens(watch); });
  const CoreTime cores = core_time();

  Figures figures{{"robots", kTeams}, {"busy", (cores.busy - cores_before.busy) / (cores.all - cores_before.all)}};
  for (const auto& one : all) {
    if (!one.team->unexpected_ends().empty()) return {};
    for (const auto reason : one.stops->of_base()) {
      spdlog::warn("false stop: run={} reason={}", run, static_cast<int>(reason));
    }
    figures["driven_h"] += one.driving_s / 3600.0;
    figures["watched_h"] += to_seconds(kWatched) / 3600.0;
    figures["false_stops"] += static_cast<double>(one.stops->of_base().size());
    figures["without_plan"] += one.stops->for_want_of_a_plan();
  }
  return figures;
}

Figures long_outage(const std::string& air) {
  constexpr Duration kOut = seconds{300};
  test::Laboratory lab{hosts_of(1)};
  const auto team = make_team(lab, 1, 1);
  if (!team->run_until(kUntilItDrives, [&] { return is_driving(*team); })) return {};
  std::ignore = lead(*team, seconds{10});
  auto poses = team->laptop_bus().in_order(topic::kRobotPose);
  bus::EventSender resumes{team->laptop_bus(), topic::kResumeRequest};

  lab.set_all({.out = true});
  std::ignore = lead(*team, seconds{20});  // what an outage takes in memory at its beginning, it has
  const Uses before = memory_MB(*team, 1);
  std::ignore = lead(*team, kOut - seconds{20});
  const Uses after = memory_MB(*team, 1);
  std::ignore = poses.take();
  lab.set_all(conditions_of(air));
  const SteadyClock clock;
  const Time healed = clock.now();

  Figures figures{{"ms", kNever}, {"drives_again_s", kNever}};
  std::ignore = team->run_until(seconds{20}, [&] {
    for (const auto& pose : poses.take()) {
      if (pose.received > healed) figures["ms"] = std::min(figures["ms"], to_ms(pose.received - healed));
    }
    return figures["ms"] < kNever;
  });
  Time next_request = clock.now();
  const bool drives_again = team->run_until(seconds{30}, [&] {
    // A link that was gone for so long needs a deliberate one, which is refused until the base knows that it is back.
    if (clock.now() >= next_request) {
      resumes.send(resume_request(clock));
      next_request = clock.now() + seconds{1};
    }
    resumes.step();
    return is_driving(*team);
  });
  if (drives_again) figures["drives_again_s"] = to_seconds(clock.now() - healed);
  figures["processes_ended"] =
      static_cast<double>(std::count(team->unexpected_ends().begin(), team->unexpected_ends().end(), '\n'));
  for (const auto& [service, MB] : after) {
    figures["most_growth_MB"] = std::max(figures["most_growth_MB"], MB - before.at(service));
    figures["growth_MB"] += MB - before.at(service);
    figures["memory_MB"] += MB;
  }
  return figures;
}

}  // namespace tandem::bench
