// `./run bench base`: tandem-base as a process between a commander on the bus and a simulated controller on a pseudo
// terminal. Each command asks for a speed of its own, one millimetre a second less than the last, so that the
// velocity packet that carries it is known when it comes out.
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>

#include "idl/topics.hpp"
#include "robot/pioneer/core/packet.hpp"
#include "services/bus/bus.hpp"
#include "services/bus/domain_lease.hpp"
#include "services/common/file_io.hpp"
#include "services/common/random.hpp"
#include "services/simulator/core/pioneer_firmware.hpp"
#include "services/simulator/wire/pseudo_terminal.hpp"
#include "tests/support/process_use.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::bench {
namespace {

constexpr int kFastest_mmps = 300;  // as fast as it may be where no people are known
constexpr int kSlowest_mmps = 100;
constexpr Duration kPeriod = std::chrono::milliseconds{50};
constexpr Duration kScanPeriod = std::chrono::milliseconds{100};

/// tandem-base with a folder of its own; SIGTERM at the end.
class BaseProcess {
 public:
  BaseProcess(const std::string& program, const std::filesystem::path& folder) {
    id_ = fork();
    if (id_ != 0) return;
    execl(program.c_str(), program.c_str(), "--config", folder.c_str(), "--log-level", "warn", nullptr);
    _exit(127);
  }
  ~BaseProcess() {
    kill(id_, SIGTERM);
    waitpid(id_, nullptr, 0);
  }
  BaseProcess(const BaseProcess&) = delete;
  BaseProcess& operator=(const BaseProcess&) = delete;
  [[nodiscard]] double cpu_s() const { return test::cpu_s_of(id_); }

 private:
  pid_t id_ = -1;
};

/// The world around the base: commands and scans in at one end, the controller at the other.
class Measurement {
 public:
  Measurement(const std::filesystem::path& folder, bus::Bus& bus)
      : port_(folder / "pioneer", "the port"),
        firmware_(options(), clock_.now()),
        commands_(bus.writer(topic::kVelocityCommand)),
        scans_(bus.writer(topic::kScan)),
        last_(clock_.now()) {}

  /// A millisecond or less of it.
  void step() {
    pollfd line{port_.descriptor(), POLLIN, 0};
    poll(&line, 1, 1);
    const Time now = clock_.now();
    const auto bytes = port_.connection().read();
    look_for_speeds(bytes, now);
    port_.connection().write(firmware_.receive(bytes, now));
    const double dt_s = to_seconds(now - last_);
    last_ = now;
    const auto speed = firmware_.drive(dt_s, now);
    firmware_.settle({speed.forward_mps * dt_s, 0.0, 0.0}, {}, now);
    if (firmware_.is_report_due(now)) port_.connection().write(firmware_.report({}, now));
    if (now >= next_scan_) scan(now);
    if (now >= next_command_) command();
  }
  [[nodiscard]] Time now() const { return clock_.now(); }
  [[nodiscard]] std::vector<double>& latencies_ms() { return latencies_ms_; }
  [[nodiscard]] int commands() const { return asked_; }

 private:
  static simulator::FirmwareOptions options() {
    simulator::FirmwareOptions options;
    options.parameters = *pioneer::robot_parameters("p2at");
    options.watchdog = std::chrono::milliseconds{500};
    return options;
  }
  void look_for_speeds(const std::vector<std::uint8_t>& bytes, Time now) {
    receiver_.push(bytes, now);
    while (const auto packet = receiver_.next()) {
      const auto told = pioneer::decode_command(*packet);
      if (!told || told->number != static_cast<std::uint8_t>(pioneer::Command::Velocity)) continue;
      const auto asked = asked_at_.find(told->integer_or(0));
      if (asked == asked_at_.end()) continue;
      latencies_ms_.push_back(1000.0 * to_seconds(now - asked->second));
      asked_at_.erase(asked);
    }
  }
  /// Down by a millimetre a second each time, which the gate lets through at once; from the slowest up again, which it
  /// does not, and so is not measured until the wheels have followed.
  void command() {
    const bool rising = rest_ > 0;
    rest_ = std::max(0, rest_ - 1);
    if (!rising && --speed_mmps_ < kSlowest_mmps) {
      speed_mmps_ = kFastest_mmps;
      rest_ = 60;
    }
    msg::VelocityCommand message;
    message.robot("robot1");
    message.commander("navigator");
    message.sequence_number(++number_);
    message.forward_mps(speed_mmps_ / 1000.0);
    const Time now = clock_.now();
    if (!rising && rest_ == 0) {
      ++asked_;
      asked_at_[speed_mmps_] = now;
    }
    commands_.write(message);
    next_command_ = now + kPeriod + from_seconds(rng_.uniform(-0.005, 0.005));
  }
  void scan(Time now) {
    msg::LaserScan scan;
    scan.robot("robot1");
    scan.sequence_number(++scan_number_);
    scan.stamp_ns(to_stamp_ns(now));
    scan.angle_min_rad(-2.35);
    scan.angle_increment_rad(0.00436);
    scan.range_max_m(30.0);
    scan.ranges_m(std::vector<float>(1081, 8.0F));
    scan.ranges_m()[540] = 7.0F + 0.01F * static_cast<float>(scan_number_ % 10);
    scans_.write(scan);
    next_scan_ = now + kScanPeriod;
  }

  SteadyClock clock_;
  simulator::PseudoTerminal port_;
  simulator::PioneerFirmware firmware_;
  pioneer::PacketReceiver receiver_;
  bus::Writer<msg::VelocityCommand, msg::VelocityCommandPubSubType> commands_;
  bus::Writer<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  Rng rng_{1};
  std::map<int, Time> asked_at_;  ///< by speed [mm/s]
  std::vector<double> latencies_ms_;
  int speed_mmps_ = kFastest_mmps;
  int rest_ = 120;  ///< commands until the wheels have followed
  int asked_ = 0;
  std::uint64_t number_ = 0;
  std::uint64_t scan_number_ = 0;
  Time next_command_{};
  Time next_scan_{};
  Time last_;
};

void write_config(const std::filesystem::path& folder, int domain) {
  write_file_atomically(folder / "site.toml", "host_domain = " + std::to_string(domain) + "\n");
  write_file_atomically(folder / "base.toml", "device = \"" + (folder / "pioneer").string() +
                                                  "\"\nrequire_link = false\nrequire_pose = false\n");
}

int run(const std::string& program, double seconds) {
  const test::TemporaryFolder folder;
  const bus::DomainLease lease{1};
  write_config(folder.path(), lease[0]);
  bus::DomainOptions domain;
  domain.domain = lease[0];
  domain.participant = "bench@robot";
  bus::Bus bus{domain};
  Measurement measurement{folder.path(), bus};
  const BaseProcess base{program, folder.path()};

  constexpr double kSettling_s = 15.0;  // it connects, warns, and drives off
  const Time start = measurement.now() + from_seconds(kSettling_s);
  while (measurement.now() < start) measurement.step();
  const double cpu_s = base.cpu_s();
  const int asked = measurement.commands();
  auto& latencies_ms = measurement.latencies_ms();
  latencies_ms.clear();
  while (measurement.now() < start + from_seconds(seconds)) measurement.step();

  const double share = (base.cpu_s() - cpu_s) / seconds;
  const auto count = latencies_ms.size();
  if (count == 0) {
    std::fprintf(stderr,
                 "no command reached the wire: does the base drive? (--seconds is too short, or it is stopped)\n");
    return EXIT_FAILURE;
  }
  std::sort(latencies_ms.begin(), latencies_ms.end());
  const auto quantile = [&](double q) {
    return latencies_ms[static_cast<std::size_t>(q * static_cast<double>(count - 1))];
  };
  std::printf("tandem-base: %.2f %% of a core over %.0f s\n", 100.0 * share, seconds);
  std::printf("command to wire: %zu of %d commands, p50 %.1f ms, p99 %.1f ms, longest %.1f ms\n", count,
              measurement.commands() - asked, quantile(0.5), quantile(0.99), latencies_ms.back());
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace tandem::bench

int main(int argc, char** argv) try {
  CLI::App app{"What tandem-base costs, and how long a command takes through the gate to the wire.",
               "tandem-bench-base"};
  std::string program = "build/bin/tandem-base";
  double seconds = 60.0;
  app.add_option("--program", program, "The base's program")->check(CLI::ExistingFile)->capture_default_str();
  app.add_option("--seconds", seconds, "How long to measure")->check(CLI::Range(5.0, 3600.0))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return tandem::bench::run(program, seconds);
} catch (const std::exception& error) {
  std::fprintf(stderr, "tandem-bench-base: %s\n", error.what());
  return EXIT_FAILURE;
}
