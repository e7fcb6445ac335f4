// The driver on a serial port that goes away and comes back under another name.
#include "robot/pioneer/base_link.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "services/common/clock.hpp"
#include "services/simulator/core/pioneer_firmware.hpp"
#include "services/simulator/wire/pseudo_terminal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

/// A controller at the other end of a pseudo terminal, which `port` in a folder of its own points to.
class Plugged {
 public:
  explicit Plugged(const std::filesystem::path& port, Time now)
      : terminal_(port, "base_pty"), firmware_(options(), now) {}
  void step(Time now) {
    const auto bytes = terminal_.connection().read();
    terminal_.connection().write(firmware_.receive(bytes, now));
    if (firmware_.is_report_due(now)) terminal_.connection().write(firmware_.report({}, now));
  }
  [[nodiscard]] std::string path() const { return terminal_.path(); }

 private:
  static simulator::FirmwareOptions options() {
    simulator::FirmwareOptions options;
    options.parameters = *pioneer::robot_parameters("p2at");
    return options;
  }
  simulator::PseudoTerminal terminal_;
  simulator::PioneerFirmware firmware_;
};

/// Moves both ends until `condition` holds, at most 20 s.
template <typename Condition>
bool run_until(BaseLink& link, std::optional<Plugged>& plugged, Clock& clock, Condition condition) {
  const Time latest = clock.now() + std::chrono::seconds{20};
  while (clock.now() < latest) {
    if (plugged) plugged->step(clock.now());
    static_cast<void>(link.exchange(std::chrono::milliseconds{10}));
    link.session().step(clock.now());
    if (condition()) return true;
  }
  return false;
}

TEST(BaseLink, ComesBackAfterTheAdapterWasUnpluggedAndGotAnotherName) {
  const test::TemporaryFolder folder;
  SteadyClock clock;
  BaseConfig config;
  config.device = (folder / "pioneer").string();
  BaseLink link{config, clock};
  std::optional<Plugged> plugged{std::in_place, folder / "pioneer", clock.now()};
  std::optional<Plugged> keeps_the_old_name;
  ASSERT_TRUE(run_until(link, plugged, clock, [&] { return link.session().is_running(); })) << link.trouble();
  const std::string before = plugged->path();

  plugged.reset();
  ASSERT_TRUE(run_until(link, plugged, clock, [&] { return !link.session().is_running(); }));
  EXPECT_NE(link.trouble().find("pioneer"), std::string::npos) << link.trouble();

  keeps_the_old_name.emplace(folder / "other", clock.now());
  plugged.emplace(folder / "pioneer", clock.now());
  EXPECT_NE(plugged->path(), before);
  EXPECT_TRUE(run_until(link, plugged, clock, [&] { return link.session().is_running(); })) << link.trouble();
  EXPECT_TRUE(link.trouble().empty());
}

TEST(BaseLink, TellsHowLongAPacketIsOnTheLine) {
  SteadyClock clock;
  BaseConfig config;
  config.device = "/dev/pioneer";
  config.baud_rates = {9600};
  EXPECT_NEAR(to_seconds(BaseLink(config, clock).transmission_time(96)), 0.1, 1e-9);
  config.device = "tcp://127.0.0.1:8101";
  EXPECT_EQ((BaseLink{config, clock}.transmission_time(96)), Duration::zero());
}

}  // namespace
}  // namespace tandem
