// The laser service as a process, before each of the simulated lasers as another: scans, and the way back from every
// fault.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "services/bus/bus.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

/// A simulated laser and how the service is told of it.
struct Setup {
  std::string name;
  std::string model;
  std::string protocol;
  bool serial = false;
  std::size_t beams = 0;

  friend std::ostream& operator<<(std::ostream& out, const Setup& setup) { return out << setup.name; }
};

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

std::uint16_t free_port() {
  const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof address;
  ::bind(descriptor, reinterpret_cast<sockaddr*>(&address), size);
  ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(descriptor);
  return ntohs(address.sin_port);
}

double median(std::vector<float> ranges) {
  std::erase_if(ranges, [](float range) { return std::isnan(range); });
  if (ranges.empty()) return std::nan("");
  std::sort(ranges.begin(), ranges.end());
  return ranges[ranges.size() / 2];
}

/// Both processes, and who listens to the service.
class Rig {
 public:
  explicit Rig(const Setup& setup) : setup_(setup) {
    const std::uint16_t port = free_port();
    const std::string pty = (folder_ / "laser").string();
    write("site.toml", "host_domain = " + std::to_string(domain_[0]) + "\n");
    write("simulator.toml", "scenario = \"" TANDEM_SOURCE_DIR
                            "/config/scenarios/quick.json\"\nperson = \"none\"\n"
                            "base_port = 0\ncamera_port = 0\nlaser_port = " +
                                std::to_string(setup.serial ? 0 : port) +
                                "\nfault_port = " + std::to_string(fault_port_) + "\nlaser_model = \"" + setup.model +
                                "\"\n" + (setup.serial ? "laser_pty = \"" + pty + "\"\n" : ""));
    write("laser.toml",
          "device = \"" + (setup.serial ? pty : "tcp://127.0.0.1:" + std::to_string(port)) + "\"\nprotocol = \"" +
              setup.protocol +
              "\"\nscan_timeout_s = 0.5\ncluster = 1\nskip = 0\nrange_max_m = 60.0\nbaud_rate = 500000\n");
    const std::string folder = folder_.path().string();
    simulator_.emplace(std::vector<std::string>{TANDEM_BINARY_DIR "/bin/tandem-simulator", "--config", folder});
    laser_.emplace(std::vector<std::string>{TANDEM_BINARY_DIR "/bin/tandem-laser", "--config", folder});
  }

  /// Listens until `condition` holds, of the newest scan; false after half a minute.
  bool listen_until(const std::function<bool()>& condition) {
    return bus::wait_until(bus_, seconds{30}, [&] {
      for (auto& scan : scans_.take()) {
        newest_ = std::move(scan.message);
        ++count_;
      }
      if (health_.newest() && health_.newest()->message.service() == "laser") state_ = health_.newest()->message;
      return condition();
    });
  }
  /// Listens until so many more scans came.
  bool listen_for(std::size_t scans) {
    const std::size_t before = count_;
    return listen_until([&] { return count_ >= before + scans; });
  }
  /// Listens until the service is well and says so.
  bool is_well() {
    return listen_until([&] { return state_.state() == msg::HEALTH_OK; }) && listen_for(3);
  }
  bool says(msg::HealthState state, const std::string& part) {
    return listen_until([&] { return state_.state() == state && state_.reason().find(part) != std::string::npos; });
  }
  void order(const std::string& fault) const {
    const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(fault_port_);
    ASSERT_EQ(::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const std::string line = "laser " + fault + "\n";
    ASSERT_EQ(::send(descriptor, line.data(), line.size(), 0), static_cast<ssize_t>(line.size()));
    char answer[3] = {};
    ASSERT_EQ(::recv(descriptor, answer, sizeof answer, MSG_WAITALL), 3);
    EXPECT_EQ(std::string(answer, 3), "ok\n");
    ::close(descriptor);
  }
  [[nodiscard]] const msg::LaserScan& newest() const { return newest_; }
  [[nodiscard]] std::string words() const { return setup_.name + ": " + state_.reason(); }

 private:
  void write(const std::string& name, const std::string& text) const { std::ofstream{folder_ / name} << text; }

  Setup setup_;
  DomainLease domain_{1};
  TemporaryFolder folder_;
  std::uint16_t fault_port_ = free_port();
  bus::Bus bus_{bus::host_domain(
      [this] {
        SiteConfig site;
        site.host_domain = domain_[0];
        return site;
      }(),
      "listener")};
  bus::InOrder<msg::LaserScan, msg::LaserScanPubSubType> scans_ = bus_.in_order(topic::kScan);
  bus::Latest<msg::ServiceHealth, msg::ServiceHealthPubSubType> health_ = bus_.latest(topic::kServiceHealth);
  std::optional<Process> simulator_;
  std::optional<Process> laser_;
  msg::LaserScan newest_;
  msg::ServiceHealth state_;
  std::size_t count_ = 0;
};

class Laser : public testing::TestWithParam<Setup> {};

TEST_P(Laser, PublishesScansAndComesBackFromEveryFault) {
  Rig rig{GetParam()};
  ASSERT_TRUE(rig.is_well()) << rig.words();
  EXPECT_EQ(rig.newest().ranges_m().size(), GetParam().beams);
  const double usual_m = median(rig.newest().ranges_m());
  EXPECT_GT(usual_m, 0.5);

  for (const auto& [fault, reason] : {std::pair{"off", ""}, {"garbage", ""}, {"intermittent", ""}}) {
    SCOPED_TRACE(fault);
    rig.order(fault);
    ASSERT_TRUE(rig.says(msg::HEALTH_FAILED, reason)) << rig.words();
    rig.order("none");
    ASSERT_TRUE(rig.is_well()) << rig.words();
  }
  for (const auto& [fault, reason] : {std::pair{"stuck", "identical scans"}, {"slow", "instead of"}}) {
    SCOPED_TRACE(fault);
    rig.order(fault);
    ASSERT_TRUE(rig.says(msg::HEALTH_DEGRADED, reason)) << rig.words();
    rig.order("none");
    ASSERT_TRUE(rig.is_well()) << rig.words();
  }
  rig.order("wrong");
  EXPECT_TRUE(rig.listen_until([&] { return median(rig.newest().ranges_m()) < 0.7 * usual_m; })) << "wrong";
  rig.order("none");
  EXPECT_TRUE(rig.listen_until([&] { return median(rig.newest().ranges_m()) > 0.9 * usual_m; })) << "wrong, mended";
  rig.order("delayed");
  EXPECT_TRUE(rig.listen_for(10)) << "delayed";
  rig.order("none");
  EXPECT_TRUE(rig.is_well()) << rig.words();
}

INSTANTIATE_TEST_SUITE_P(EachSimulatedOne, Laser,
                         testing::Values(Setup{"utm_30lx", "utm-30lx", "scip", false, 1081},
                                         Setup{"urg_04lx", "urg-04lx", "scip", true, 682},
                                         Setup{"lms111", "lms111", "cola", false, 541},
                                         Setup{"tim561", "tim561", "cola", false, 811},
                                         Setup{"lms200", "lms200", "lms2xx", true, 361}),
                         [](const testing::TestParamInfo<Setup>& one) { return one.param.name; });

}  // namespace
}  // namespace tandem::test
