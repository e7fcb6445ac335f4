#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <functional>
#include <opencv2/imgcodecs.hpp>

#include "robot/laser/core/lms_message.hpp"
#include "robot/laser/core/scip.hpp"
#include "robot/pioneer/core/packet.hpp"
#include "services/simulator/wire/base_server.hpp"
#include "services/simulator/wire/camera_server.hpp"
#include "services/simulator/wire/fault_server.hpp"
#include "services/simulator/wire/laser_server.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::simulator {
namespace {

constexpr Duration kStep = std::chrono::milliseconds{25};

Simulation simulation() {
  SimulationOptions options;
  options.firmware.parameters = *pioneer::robot_parameters("p2at");
  options.laser.noise_m = 0.0;
  const Place place{test::ascii_map({"########", "#......#", "#......#", "#......#", "########"})};
  const Scene scene{.robot_start = {2.0, 2.5, 0.0}, .person_start = {2.0, 3.5, 0.0}, .tokens_in_map = {}};
  return {options, place, scene, nullptr, Time{}};
}

/// A raw client on a socket or a serial port; the world moves on while it waits.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port) : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  explicit RawClient(const std::string& path) : descriptor_(::open(path.c_str(), O_RDWR | O_NOCTTY)) {
    EXPECT_GE(descriptor_, 0);
  }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient() { ::close(descriptor_); }

  void set_rate(speed_t rate) const {
    termios settings{};
    ::tcgetattr(descriptor_, &settings);
    ::cfsetspeed(&settings, rate);
    ::tcsetattr(descriptor_, TCSANOW, &settings);
  }
  void send(const std::string& bytes) const {
    EXPECT_EQ(::write(descriptor_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void send(const pioneer::Bytes& bytes) const { send(std::string{bytes.begin(), bytes.end()}); }
  /// What comes until `enough` says so, with `serve` called meanwhile; all that came after 2 s.
  std::string receive(const std::function<void()>& serve, const std::function<bool(const std::string&)>& enough) const {
    std::string all;
    for (int i = 0; i < 400 && !enough(all); ++i) {
      serve();
      pollfd polled{descriptor_, POLLIN, 0};
      if (::poll(&polled, 1, 5) <= 0) continue;
      char chunk[4096];
      const auto count = ::read(descriptor_, chunk, sizeof chunk);
      if (count <= 0) break;
      all.append(chunk, static_cast<std::size_t>(count));
    }
    return all;
  }

 private:
  int descriptor_;
};

std::function<bool(const std::string&)> length_of(std::size_t size) {
  return [size](const std::string& text) { return text.size() >= size; };
}
std::function<bool(const std::string&)> contains(const std::string& part) {
  return [part](const std::string& text) { return text.find(part) != std::string::npos; };
}
std::string bytes(const pioneer::Bytes& all) {
  return {all.begin(), all.end()};
}

/// Base server and world; each call is a step.
struct BaseHouse {
  Simulation world = simulation();
  BaseServer server;
  Time now{};
  explicit BaseHouse(std::uint16_t port, const std::string& pty = "") : server("127.0.0.1", port, pty) {}
  void operator()() {
    now += kStep;
    server.receive(world, now);
    world.step(to_seconds(kStep), now);
    server.report(world, now);
  }
};

std::uint16_t free_port() {
  return TcpListener{"127.0.0.1", 0, "a test", "none"}.port();
}

void shake_hands(const RawClient& client, BaseHouse& house) {
  const auto serve = std::ref(house);
  client.send(pioneer::Bytes{0xFA, 0xFB, 3, 0, 0, 0});
  EXPECT_EQ(client.receive(serve, length_of(6)), bytes({0xFA, 0xFB, 3, 0, 0, 0}));
  client.send(pioneer::Bytes{0xFA, 0xFB, 3, 1, 0, 1});
  EXPECT_EQ(client.receive(serve, length_of(6)), bytes({0xFA, 0xFB, 3, 1, 0, 1}));
  client.send(pioneer::Bytes{0xFA, 0xFB, 3, 2, 0, 2});
  const std::string identity = client.receive(serve, contains("p2at"));
  EXPECT_NE(identity.find(std::string{"Pioneer\0p2at\0", 13}), std::string::npos);
  client.send(pioneer::Bytes{0xFA, 0xFB, 3, 1, 0, 1});
  const std::string report = client.receive(serve, length_of(20));
  EXPECT_EQ(report.substr(0, 2), bytes({0xFA, 0xFB}));
  EXPECT_EQ(static_cast<std::uint8_t>(report[3]), pioneer::packet_type::kSipStopped);
}

TEST(BaseServer, ShakesHandsOverTcpAndReports) {
  BaseHouse house{free_port()};
  const RawClient client{house.server.port()};
  shake_hands(client, house);
}

TEST(BaseServer, TakesTheNextClientAtOnce) {
  BaseHouse house{free_port()};
  {
    const RawClient first{house.server.port()};
    shake_hands(first, house);
    first.send(pioneer::command(pioneer::Command::Close));
    house();
  }
  const RawClient second{house.server.port()};
  shake_hands(second, house);
}

TEST(BaseServer, AConnectionOutlivesItsHost) {
  BaseHouse house{free_port()};
  {
    const RawClient first{house.server.port()};
    shake_hands(first, house);
  }
  const RawClient second{house.server.port()};
  second.send(pioneer::Bytes{0xFA, 0xFB, 3, 0, 0, 0});  // taken for PULSE
  const std::string report = second.receive(std::ref(house), length_of(20));
  EXPECT_EQ(static_cast<std::uint8_t>(report.at(3)), pioneer::packet_type::kSipStopped);
}

TEST(BaseServer, ShakesHandsOverAPseudoTerminal) {
  const test::TemporaryFolder folder;
  const auto link = folder / "pty";
  {
    BaseHouse house{0, link.string()};
    const RawClient client{link.string()};
    shake_hands(client, house);
  }
  EXPECT_FALSE(std::filesystem::is_symlink(link));
}

TEST(BaseServer, SurvivesGarbage) {
  BaseHouse house{free_port()};
  const RawClient client{house.server.port()};
  client.send(std::string(3000, '\xFA'));
  for (int i = 0; i < 8; ++i) house();
  shake_hands(client, house);
}

TEST(LaserServer, AnswersAndStreamsOverTcp) {
  Simulation world = simulation();
  Time now{};
  LaserServer server{{.port = free_port()}, now};
  const auto serve = [&] {
    server.receive(now);
    world.step(to_seconds(kStep), now + kStep);
    server.step(world, now, kStep);
    now += kStep;
  };
  const RawClient client{server.port()};
  client.send(std::string{"VV\nPP\n"});
  EXPECT_NE(client.receive(serve, contains("SCAN:2400;U\n\n")).find("PROT:SCIP 2.0"), std::string::npos);
  client.send(std::string{"MD0540054001002\n"});
  const std::string text = client.receive(serve, contains("MD0540054001000\n99b\n"));
  EXPECT_EQ(text.substr(0, 21), "MD0540054001002\n00P\n\n");
  scip::ReplyParser parser;
  const auto replies = parser.take(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  ASSERT_GE(replies.size(), 2U);
  const auto scan = scip::parse_scan(replies[1]);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->ranges_mm.at(0), 4840U);  // from 2.16 m to the wall at 7 m
}

/// Laser server and world; each call is a step.
struct LaserHouse {
  Simulation world = simulation();
  Time now{};
  LaserServer server;
  explicit LaserHouse(LaserServerOptions options) : server(std::move(options), now) {}
  void operator()() {
    server.receive(now);
    world.step(to_seconds(kStep), now + kStep);
    server.step(world, now, kStep);
    now += kStep;
  }
};

TEST(LaserServer, ALaserOnASerialLineMindsItsRate) {
  const test::TemporaryFolder folder;
  const auto link = (folder / "laser").string();
  LaserHouse house{{.pty = link, .model = "lms200"}};
  const RawClient client{link};
  const std::string type = lms::bytes_of(lms::kToLaser, lms::Payload{lms::command::kType});
  client.set_rate(B38400);
  client.send(type);
  EXPECT_EQ(client.receive(std::ref(house), contains("LMS200")).find("LMS200"), std::string::npos);
  client.set_rate(B9600);
  client.send(type);
  EXPECT_NE(client.receive(std::ref(house), contains("LMS200")).find("LMS200"), std::string::npos);
}

TEST(LaserServer, AfterAPowerCutItWakesAsFromTheFactory) {
  const test::TemporaryFolder folder;
  const auto link = (folder / "laser").string();
  LaserHouse house{{.pty = link, .model = "lms200", .boot = std::chrono::milliseconds{500}}};
  for (int i = 0; i < 30; ++i) house();
  const RawClient client{link};
  client.set_rate(B9600);
  client.send(lms::bytes_of(lms::kToLaser, lms::mode_request(lms::mode::kStream)));
  client.receive(std::ref(house), length_of(1000));
  house.server.set_fault(HardwareFault::Off, house.now);
  client.receive(std::ref(house), [](const std::string&) { return false; });
  house.server.set_fault(HardwareFault::None, house.now);
  const std::string text = client.receive(std::ref(house), contains("LMS200"));
  EXPECT_EQ(static_cast<std::uint8_t>(text.at(4)), lms::command::kPowerOn) << "the first it says";
  EXPECT_LT(text.size(), 100U) << "it streams no more";
}

TEST(FaultServer, TakesOrdersAndSaysWhatItDoesNotUnderstand) {
  std::vector<HardwareFault> set;
  FaultServer server{"127.0.0.1", free_port(), {{"laser", [&set](HardwareFault fault) { set.push_back(fault); }}}};
  const RawClient client{server.port()};
  const auto answer_to = [&](const std::string& order) {
    client.send(order);
    return client.receive([&] { server.receive(); }, contains("\n"));
  };
  EXPECT_EQ(answer_to("laser stuck\n"), "ok\n");
  EXPECT_EQ(answer_to("laser none\r\n"), "ok\n");
  EXPECT_EQ(set, (std::vector<HardwareFault>{HardwareFault::Stuck, HardwareFault::None}));
  EXPECT_EQ(answer_to("camera off\n"), "no device \"camera\"; there are laser\n");
  EXPECT_EQ(answer_to("laser broken\n"),
            "say \"laser FAULT\", one of none, off, stuck, garbage, wrong, slow, delayed, intermittent\n");
  EXPECT_EQ(answer_to("laser\n").substr(0, 3), "say");
  EXPECT_EQ(set.size(), 2U);
}

TEST(CameraServer, StreamsJpegOverHttp) {
  Simulation world = simulation();
  Time now{};
  CameraServer server{"127.0.0.1", free_port(), std::chrono::milliseconds{200}, now};
  const auto serve = [&] {
    server.receive();
    server.step(world, now += kStep);
  };
  const RawClient client{server.port()};
  client.send(std::string{"GET /stream.mjpeg HTTP/1.1\r\nHost: robot\r\n\r\n"});
  const std::string text = client.receive(serve, contains("\xFF\xD9\r\n"));
  EXPECT_TRUE(text.starts_with("HTTP/1.0 200 OK\r\n"));
  EXPECT_NE(text.find("multipart/x-mixed-replace"), std::string::npos);
  const auto begin = text.find("\xFF\xD8");
  ASSERT_NE(begin, std::string::npos);
  const std::vector<std::uint8_t> jpeg(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end());
  const cv::Mat picture = cv::imdecode(jpeg, cv::IMREAD_COLOR);
  EXPECT_EQ(picture.cols, 320);
  EXPECT_EQ(picture.rows, 240);
}

TEST(CameraServer, KnowsOnePathOnly) {
  Simulation world = simulation();
  CameraServer server{"127.0.0.1", free_port(), std::chrono::milliseconds{200}, Time{}};
  const RawClient client{server.port()};
  client.send(std::string{"GET /etc/passwd HTTP/1.1\r\n\r\n"});
  EXPECT_TRUE(client.receive([&] { server.receive(); }, contains("\r\n\r\n")).starts_with("HTTP/1.0 404"));
}

TEST(TcpListener, ATakenPortIsNamedWithItsRemedy) {
  const TcpListener first{"127.0.0.1", 0, "a test", "none"};
  try {
    const TcpListener second{"127.0.0.1", first.port(), "the base (P2OS)", "base_port"};
    FAIL();
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("127.0.0.1:" + std::to_string(first.port())), std::string::npos) << what;
    EXPECT_NE(what.find("taken"), std::string::npos) << what;
    EXPECT_NE(what.find("set base_port in simulator.toml"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace tandem::simulator
