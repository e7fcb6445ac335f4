#include "services/common/service_manager.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

/// The manager's end of the socket that $NOTIFY_SOCKET names.
class Manager {
 public:
  Manager() : path_((folder_ / "manager").string()) {
    socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path_.copy(address.sun_path, sizeof(address.sun_path) - 1);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    ::setenv("NOTIFY_SOCKET", path_.c_str(), 1);
  }
  ~Manager() {
    ::unsetenv("NOTIFY_SOCKET");
    ::close(socket_);
  }
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;

  /// All that was said since the last call.
  std::string heard() {
    std::string all;
    std::array<char, 512> buffer{};
    for (ssize_t size = 0; (size = ::recv(socket_, buffer.data(), buffer.size(), 0)) > 0;) {
      all.append(buffer.data(), static_cast<std::size_t>(size));
    }
    return all;
  }

 private:
  test::TemporaryFolder folder_;
  std::string path_;
  int socket_ = -1;
};

Time at(double seconds) {
  return Time{} + from_seconds(seconds);
}

TEST(ServiceManager, HearsOfReadinessOnceAndOfLifeAsLongAsTheLoopTurns) {
  Manager manager;
  ServiceManager told;
  told.step(false, "no answer from /dev/pioneer", at(10.0));
  EXPECT_EQ(manager.heard(), "WATCHDOG=1\nSTATUS=no answer from /dev/pioneer\n");
  told.step(true, "ok", at(10.05));
  EXPECT_EQ(manager.heard(), "READY=1\nSTATUS=ok\n");
  told.step(true, "ok", at(10.1));
  EXPECT_EQ(manager.heard(), "") << "five signs a second are enough";
  told.step(false, "ok", at(10.2));
  EXPECT_EQ(manager.heard(), "WATCHDOG=1\n");
}

TEST(ServiceManager, HearsAStatusInOneLine) {
  Manager manager;
  ServiceManager told;
  told.step(true, "two\nlines", at(1.0));
  EXPECT_EQ(manager.heard(), "READY=1\nWATCHDOG=1\nSTATUS=two lines\n");
}

}  // namespace
}  // namespace tandem
