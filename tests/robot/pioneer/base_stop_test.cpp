#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "robot/pioneer/core/packet.hpp"
#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::pioneer {
namespace {

/// The controller's end of a pseudo-terminal.
class Controller {
 public:
  Controller() : descriptor_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    EXPECT_EQ(::grantpt(descriptor_), 0);
    EXPECT_EQ(::unlockpt(descriptor_), 0);
    device_ = ::ptsname(descriptor_);
    // Held open, so that what was written stays when the program has gone, as in a real line.
    line_ = ::open(device_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  }
  ~Controller() {
    ::close(line_);
    ::close(descriptor_);
  }
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  [[nodiscard]] const std::string& device() const { return device_; }
  [[nodiscard]] std::vector<HostCommand> heard() const {
    PacketReceiver receiver;
    std::array<std::uint8_t, 512> buffer{};
    for (ssize_t size = 0; (size = ::read(descriptor_, buffer.data(), buffer.size())) > 0;) {
      receiver.push({buffer.data(), static_cast<std::size_t>(size)}, Time{});
    }
    std::vector<HostCommand> commands;
    while (const auto packet = receiver.next()) {
      if (const auto command = decode_command(*packet)) commands.push_back(*command);
    }
    return commands;
  }

 private:
  int descriptor_;
  int line_ = -1;
  std::string device_;
};

/// Exit code of tandem-base-stop with this base.toml.
int stop_with(const std::string& base_toml) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "base.toml", base_toml);
  const std::string command = TANDEM_BINARY_DIR "/bin/tandem-base-stop --config " + folder.path().string();
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(BaseStop, TellsTheControllerToStandStillAtEveryRateItMayListenAt) {
  const Controller controller;
  ASSERT_EQ(stop_with("device = \"" + controller.device() + "\"\nbaud_rates = [9600, 38400]\n"), 0);
  const auto heard = controller.heard();
  ASSERT_EQ(heard.size(), 6u);
  for (const std::size_t first : {0u, 3u}) {
    EXPECT_EQ(heard[first].number, static_cast<std::uint8_t>(Command::Velocity));
    EXPECT_EQ(heard[first].integer_or(1), 0);
    EXPECT_EQ(heard[first + 1].number, static_cast<std::uint8_t>(Command::TurnRate));
    EXPECT_EQ(heard[first + 1].integer_or(1), 0);
    EXPECT_EQ(heard[first + 2].number, static_cast<std::uint8_t>(Command::Stop));
  }
}

TEST(BaseStop, FailsWhereThereIsNoController) {
  EXPECT_EQ(stop_with("device = \"/dev/no-such-pioneer\"\n"), 1);
}

}  // namespace
}  // namespace tandem::pioneer
