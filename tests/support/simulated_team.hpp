#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/domain_lease.hpp"
#include "services/cli/up/episode.hpp"
#include "services/cli/up/run_folder.hpp"
#include "services/cli/up/supervisor.hpp"
#include "tests/support/link_place.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::test {

/// The network of one of a team's hosts; by default this machine's loopback.
struct HostNetwork {
  /// Does work in that network: processes and threads that are made there stay there.
  std::function<void(const std::function<void()>&)> run = [](const std::function<void()>& work) { work(); };
  std::optional<LinkPlace> link{};  ///< none: as in config/simulation
};

/// How a team is made up for a test.
struct TeamOptions {
  std::string scenario = "quick";
  std::uint64_t seed = 1;
  std::string robot = "robot1";
  std::string agent = "person1";
  int robot_domain = 0;
  int laptop_domain = 0;
  int link_domain = 0;
  bool play = false;
  bool is_led = true;                ///< by its own episode; else by whoever the test lets do it
  std::vector<std::string> without;  ///< services that are not started, as "planner" or "robot1/map-server"
  HostNetwork robot_network;         ///< with the simulated world, and with the person's phone
  HostNetwork laptop_network;
  std::string gateway_address = "127.0.0.1";  ///< of the laptop, where the phone finds the gateway
};

/// A robot, a laptop, a simulated world and a simulated person: the real processes, on domains and ports of their own.
class SimulatedTeam {
 public:
  explicit SimulatedTeam(const TeamOptions& options);
  ~SimulatedTeam();

  /// Leads the episode, if it is led, until `condition` holds. False after `timeout`, or when a process ended that was
  /// not killed.
  bool run_until(Duration timeout, const std::function<bool()>& condition);
  /// Kills a service at once: "base", "relay", ... of the host that is named.
  void kill(const std::string& host, const std::string& service);
  /// Starts a service that was killed.
  void start_again(const std::string& host, const std::string& service);
  /// The services of a host that run, without the simulator: that is hardware and world.
  [[nodiscard]] std::vector<std::string> services(const std::string& host) const;
  /// The process of a service; none if it does not run.
  [[nodiscard]] std::optional<pid_t> process(const std::string& host, const std::string& service) const {
    return supervisor_.id_of(host + "/" + service);
  }

  /// Of a team that is led.
  [[nodiscard]] cli::Episode& episode() { return *episode_; }
  /// Where the robot stands at first, map_from_base.
  [[nodiscard]] const Pose2& robot_start() const { return robot_start_; }
  [[nodiscard]] bus::Bus& robot_bus() { return *robot_bus_; }
  [[nodiscard]] bus::Bus& laptop_bus() { return *laptop_bus_; }
  [[nodiscard]] const cli::RunFolder& folder() const { return folder_; }
  /// Ends all processes in order, so that the recordings of both hosts are closed.
  void stop();
  /// Processes that ended though nobody killed them, and their last words.
  [[nodiscard]] const std::string& unexpected_ends() const { return unexpected_end_; }
  /// The recording of the robot's or the laptop's host.
  [[nodiscard]] std::filesystem::path recording(const std::string& role) const;
  [[nodiscard]] const SiteConfig& laptop_site() const { return laptop_site_; }
  /// The faster wheel's true speed [m/s], newest; nothing before the first.
  [[nodiscard]] std::optional<double> wheel_speed_mps() const;
  /// How long the wheels went on turning.
  struct Standstill {
    double after_s = 0.0;  ///< from the call until the last moment with a turning wheel
  };
  /// Watches the wheels for `duration` and tells when they last turned.
  [[nodiscard]] Standstill watch_wheels(Duration duration);
  /// The logs' last lines, for a failing test's message.
  [[nodiscard]] std::string last_words() const;

 private:
  void note_ends();

  TemporaryFolder home_;  ///< outlives everything that writes in it
  TeamOptions options_;
  cli::RunFolder folder_;
  SiteConfig laptop_site_;
  Pose2 robot_start_;
  cli::Supervisor supervisor_;
  std::unique_ptr<bus::Bus> robot_bus_;
  std::unique_ptr<bus::Bus> laptop_bus_;
  std::unique_ptr<bus::InOrder<msg::GroundTruth, msg::GroundTruthPubSubType>> truth_;
  std::optional<msg::GroundTruth> newest_truth_;
  std::unique_ptr<cli::Episode> episode_;
  std::vector<cli::ProcessPlan> plans_;  ///< of all processes that were ever started
  std::vector<std::string> processes_;
  std::string unexpected_end_;
};

}  // namespace tandem::test
