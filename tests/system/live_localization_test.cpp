// The live service at free rates: near the poses of `tandem localize`. Says what it costs, too.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <thread>

#include "idl/topics.hpp"
#include "services/bus/bus.hpp"
#include "services/common/file_io.hpp"
#include "services/localization/core/trajectory_file.hpp"
#include "services/recorder/core/carmen_log.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

const std::string kBin = TANDEM_BINARY_DIR "/bin/";
constexpr double kSeconds = 60.0;  ///< of the log
constexpr double kRatePerS = 4.5;  ///< of its scans

int run(const std::string& command) {
  return WEXITSTATUS(std::system(command.c_str()));
}

class LiveLocalization : public testing::TestWithParam<double> {
 protected:
  void prepare() {
    fs::create_directories(folder_ / "config");
    std::istringstream all{carmen::read_log_file((data_folder() / "fr079/fr079.odomscan.txt.gz").string())};
    std::string kept;
    for (std::string line; std::getline(all, line);) {
      if (!line.starts_with('#') && std::stod(line.substr(2)) > kSeconds) break;
      kept += line + "\n";
    }
    write_file_atomically(folder_ / "log.txt", kept);
    write_file_atomically(folder_ / "config/site.toml", "host_domain = " + std::to_string(domain_[0]) + "\n");
    write_file_atomically(folder_ / "config/map-server.toml", "map = \"" + map_ + "\"\n");
    write_file_atomically(folder_ / "config/localization.toml", "start = [0.001236, -0.001068, 0.000029]\n");
    ASSERT_EQ(run(kBin + "tandem import carmen " + path("log.txt") + " -o " + path("log.mcap")), 0);
    ASSERT_EQ(run(kBin + "tandem localize " + path("log.mcap") + " --map " + map_ + " --config " +
                  path("config/localization.toml") + " --trajectory " + path("offline.txt")),
              0);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  const DomainLease domain_{1};
  const TemporaryFolder folder_;
  const std::string map_ = fs::absolute(data_folder() / "maps/fr079_even.yaml").string();
};

TEST_P(LiveLocalization, StaysWithinTwoCentimetresOfTandemLocalize) {
  TANDEM_NEEDS_DATA("fr079/fr079.odomscan.txt.gz");
  prepare();
  SiteConfig site;
  site.host_domain = domain_[0];
  bus::Bus bus{bus::host_domain(site, "listener", bus::Pace::RealTime)};
  auto poses = bus.in_order(topic::kRobotPose);
  auto health = bus.in_order(topic::kServiceHealth);
  std::string latency;
  std::map<Time, Pose2> live;  // the last of a stamp: with the scan, not only with the wheels
  std::size_t sent = 0;
  const auto listen = [&] {
    for (const auto& received : poses.take()) {
      const msg::Pose& pose = received.message.map_from_base();
      live[from_stamp_ns(received.message.stamp_ns())] = {pose.x(), pose.y(), pose.heading()};
      ++sent;
    }
    for (const auto& received : health.take()) {
      if (received.message.service() == "localization") latency = received.message.reason();
    }
    return false;
  };
  double core_share = 0.0;
  {
    const Process maps{{kBin + "tandem-map-server", "--config", path("config")}};
    const Process localization{{kBin + "tandem-localization", "--config", path("config"), "--clock", "bus"}};
    ASSERT_TRUE(bus::wait_until(bus, from_seconds(10.0), [&] { return poses.matched_writers() > 0; }));
    int status = -1;
    std::thread replay{[&] {
      status = run(kBin + "tandem replay " + path("log.mcap") + " --rate " + std::to_string(GetParam()) + " --config " +
                   path("config"));
    }};
    // From the first pose on: the map is ready then.
    (void)bus::wait_until(bus, from_seconds(20.0), [&] { return listen() || sent > 0; });
    const double before_s = localization.cpu_s();
    const double measured_s = 0.9 * kSeconds / GetParam();
    (void)bus::wait_until(bus, from_seconds(measured_s), listen);
    core_share = (localization.cpu_s() - before_s) / measured_s;
    (void)bus::wait_until(bus, from_seconds(0.1 * kSeconds / GetParam() + 2.0), listen);
    replay.join();
    ASSERT_EQ(status, 0);
  }
  const auto offline = parse_trajectory(read_file(folder_ / "offline.txt"), "offline.txt");
  std::size_t near = 0;
  for (const TimedPose& pose : offline) {
    // Trajectories are written to the microsecond.
    const auto after = live.lower_bound(pose.time - std::chrono::microseconds{1});
    if (after == live.end() || after->first > pose.time + std::chrono::microseconds{1}) continue;
    near += (after->second.position() - pose.map_from_base.position()).norm() <= 0.02 ? 1 : 0;
  }
  const auto scans = static_cast<double>(offline.size());
  const double scans_per_s = kRatePerS * GetParam();
  std::printf("rate %.1f: %zu poses for %zu scans, %.2f %% within 2 cm; %.2f %% of a core at %.1f scans/s; %s\n",
              GetParam(), sent, offline.size(), 100.0 * static_cast<double>(near) / scans, 100.0 * core_share,
              scans_per_s, latency.c_str());
  EXPECT_GE(static_cast<double>(near), 0.99 * scans);
}

INSTANTIATE_TEST_SUITE_P(Rates, LiveLocalization, testing::Values(1.0, 2.2, 4.0));

}  // namespace
}  // namespace tandem::test
