// A State whose writer dies is marked on the other host too, and is whole again when the writer is back.
#include <gtest/gtest.h>

#include "services/common/file_io.hpp"
#include "tests/network/two_hosts.hpp"

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// The lease of a participant, half a second for Fast DDS to see that it has run out, and a second to be shown over
/// there (docs/network.md, "When a writer dies").
constexpr Duration kMarkedWithin = milliseconds{6500};
constexpr double kBattery_v = 12.0;

/// A service of `on` that needs no hardware.
class Tracker {
 public:
  explicit Tracker(RelayedHost& on) : host_(on) { write_file_atomically(on.config() / "tracker.toml", ""); }
  void start() {
    process_ = host_.host().run([&] {
      return std::make_unique<Process>(std::vector<std::string>{std::string{TANDEM_BINARY_DIR} + "/bin/tandem-tracker",
                                                                "--config", host_.config().path().string()});
    });
  }
  void kill() { process_->kill_at_once(); }

 private:
  RelayedHost& host_;
  std::unique_ptr<Process> process_;
};

/// Whether the other host knows the tracker of one host, and that it has a writer.
class Witness {
 public:
  Witness(RelayedHost& to, const RelayedHost& from)
      : from_(from.host().name()), health_(to.bus().latest(topic::kServiceHealth)) {}
  [[nodiscard]] bool sees(bool writer_alive) const {
    for (const auto& received : health_.each()) {
      const auto& message = received.message;
      if (message.host() == from_ && message.service() == "tracker") return received.writer_alive == writer_alive;
    }
    return false;
  }

 private:
  std::string from_;
  bus::Latest<msg::ServiceHealth, msg::ServiceHealthPubSubType> health_;
};

/// A robot whose base told its status once, and the laptop's reader of it.
struct ToldOnce {
  TwoHosts hosts;
  bus::Writer<msg::BaseStatus, msg::BaseStatusPubSubType> writer{hosts.robot().bus().writer(topic::kBaseStatus)};
  bus::Latest<msg::BaseStatus, msg::BaseStatusPubSubType> reader{hosts.laptop().bus().latest(topic::kBaseStatus)};

  ToldOnce() {
    msg::BaseStatus status;
    status.robot("robot1");
    status.battery_v(kBattery_v);
    writer.write(status);
  }
  [[nodiscard]] bool becomes(bool writer_alive) {
    return bus::wait_until(hosts.laptop().bus(), seconds{20},
                           [&] { return reader.newest() && reader.newest()->writer_alive == writer_alive; });
  }
};

TEST(WriterLoss, OfEitherHostIsSeenOnTheOtherAndItsReturnToo) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  Tracker of_robot{hosts.robot()};
  Tracker of_laptop{hosts.laptop()};
  const Witness on_laptop{hosts.laptop(), hosts.robot()};
  const Witness on_robot{hosts.robot(), hosts.laptop()};
  const auto both_see = [&](bool writer_alive) {
    return bus::wait_until(hosts.laptop().bus(), seconds{20},
                           [&] { return on_laptop.sees(writer_alive) && on_robot.sees(writer_alive); });
  };
  of_robot.start();
  of_laptop.start();
  ASSERT_TRUE(both_see(true));

  const Time killed = hosts.laptop().bus().clock().now();
  of_robot.kill();
  of_laptop.kill();
  EXPECT_TRUE(both_see(false));
  const Duration took = hosts.laptop().bus().clock().now() - killed;
  EXPECT_LE(took, kMarkedWithin);
  RecordProperty("marked_after_s", std::to_string(to_seconds(took)));

  of_robot.start();
  of_laptop.start();
  EXPECT_TRUE(both_see(true));
}

TEST(WriterLoss, AnOutageMarksEveryStateAndItsEndBringsThemBack) {
  TANDEM_NEEDS_LABORATORY();
  ToldOnce told;
  ASSERT_TRUE(told.becomes(true));
  told.hosts.lab().set_all({.out = true});
  EXPECT_TRUE(told.becomes(false));
  EXPECT_EQ(told.reader.newest()->message.battery_v(), kBattery_v);
  told.hosts.lab().set_all({});
  EXPECT_TRUE(told.becomes(true));
  EXPECT_EQ(told.reader.newest()->message.battery_v(), kBattery_v);
}

TEST(WriterLoss, ARelayThatDiesMarksWhatItBrought) {
  TANDEM_NEEDS_LABORATORY();
  ToldOnce told;
  ASSERT_TRUE(told.becomes(true));
  told.hosts.robot().restart_relay();
  EXPECT_TRUE(told.becomes(false));
  EXPECT_TRUE(told.becomes(true));
}

}  // namespace
}  // namespace tandem::test
