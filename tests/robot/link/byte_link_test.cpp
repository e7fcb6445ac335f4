#include "robot/link/byte_link.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "services/simulator/wire/line_rate.hpp"

namespace tandem {
namespace {

constexpr Duration kSoon = from_seconds(2.0);

std::string text(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

/// A listening socket on a free port of this machine.
class Listener {
 public:
  Listener() : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ::bind(descriptor_, reinterpret_cast<sockaddr*>(&address), size);
    ::listen(descriptor_, 1);
    ::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size);
    name_ = "tcp://127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }
  ~Listener() { close(); }
  void close() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }
  [[nodiscard]] int accept() const { return ::accept(descriptor_, nullptr, nullptr); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  int descriptor_;
  std::string name_;
};

TEST(ByteLink, ChangesTheRateOfASerialLine) {
  const int device = ::posix_openpt(O_RDWR | O_NOCTTY);
  ::grantpt(device);
  ::unlockpt(device);
  OpenedLink opened = open_byte_link(::ptsname(device), {.baud_rate = 9'600});
  ASSERT_TRUE(opened.link) << opened.failure;
  EXPECT_EQ(simulator::line_rate(device), 9'600);
  opened.link->set_baud_rate(38'400);
  EXPECT_EQ(simulator::line_rate(device), 38'400);
  opened.link->set_baud_rate(750'000);  // has no name of its own
  EXPECT_EQ(simulator::line_rate(device), 750'000);
  EXPECT_TRUE(opened.link->is_open());
  ::close(device);
}

TEST(ByteLink, CarriesBytesBothWaysOverTcp) {
  const Listener listener;
  OpenedLink opened = open_byte_link(listener.name());
  ASSERT_TRUE(opened.link) << opened.failure;
  const int peer = listener.accept();

  EXPECT_TRUE(opened.link->write("VV\n"));
  char received[3] = {};
  EXPECT_EQ(::recv(peer, received, 3, MSG_WAITALL), 3);
  EXPECT_EQ(std::string(received, 3), "VV\n");

  EXPECT_EQ(::send(peer, "00P\n", 4, 0), 4);
  EXPECT_EQ(text(opened.link->read(kSoon)), "00P\n");
  ::close(peer);
}

TEST(ByteLink, GivesWhatCameBeforeTheOtherSideClosedAndThenSaysSo) {
  const Listener listener;
  OpenedLink opened = open_byte_link(listener.name());
  ASSERT_TRUE(opened.link);
  const int peer = listener.accept();
  EXPECT_EQ(::send(peer, "last", 4, 0), 4);
  ::close(peer);

  std::string all;
  while (opened.link->is_open()) all += text(opened.link->read(kSoon));

  EXPECT_EQ(all, "last");
  EXPECT_EQ(opened.link->failure(), listener.name() + ": closed by the other side");
  EXPECT_FALSE(opened.link->write("more"));
  EXPECT_TRUE(opened.link->read(kSoon).empty());
}

TEST(ByteLink, SaysWhichDeviceRefusesAndWhatToDo) {
  Listener listener;
  listener.close();
  const OpenedLink opened = open_byte_link(listener.name());
  EXPECT_FALSE(opened.link);
  EXPECT_EQ(opened.failure,
            listener.name() + ": connection refused: is the device (or the simulator) running, and is the port right?");
}

TEST(ByteLink, SaysWhichDeviceFileIsMissing) {
  const OpenedLink opened = open_byte_link("/dev/no-such-laser");
  EXPECT_FALSE(opened.link);
  EXPECT_EQ(opened.failure, "/dev/no-such-laser: no such device: is it plugged in and switched on?");
}

TEST(ByteLink, IsRawOnAPseudoTerminalAndIsLostWhenThatCloses) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(::grantpt(master), 0);
  ASSERT_EQ(::unlockpt(master), 0);
  OpenedLink opened = open_byte_link(::ptsname(master));
  ASSERT_TRUE(opened.link) << opened.failure;

  EXPECT_EQ(::write(master, "\x03\r\n", 3), 3);  // no signal, no translation of line ends
  EXPECT_EQ(text(opened.link->read(kSoon)), "\x03\r\n");

  ::close(master);
  while (opened.link->is_open()) EXPECT_TRUE(opened.link->read(kSoon).empty());
  EXPECT_NE(opened.link->failure(), "");
}

}  // namespace
}  // namespace tandem
