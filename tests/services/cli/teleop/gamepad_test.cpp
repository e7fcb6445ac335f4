#include "services/cli/teleop/gamepad.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

TEST(Gamepad, GivesTheEventsThatCameAndSaysWhenItWasUnplugged) {
  const test::TemporaryFolder folder;
  const std::string device = folder / "js0";
  ASSERT_EQ(mkfifo(device.c_str(), 0600), 0);  // read as the kernel's device is
  const int kernel = open(device.c_str(), O_RDWR);
  Gamepad pad{device};
  EXPECT_EQ(pad.name(), device) << "it has no name of its own";
  EXPECT_TRUE(pad.events().empty());
  const js_event events[2] = {{.time = 1, .value = -32'767, .type = JS_EVENT_AXIS, .number = 1},
                              {.time = 2, .value = 1, .type = JS_EVENT_BUTTON, .number = 4}};
  ASSERT_EQ(write(kernel, events, sizeof events), static_cast<ssize_t>(sizeof events));
  const auto read = pad.events();
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].value, -32'767);
  EXPECT_EQ(read[1].number, 4);
  EXPECT_TRUE(pad.is_there());
  close(kernel);
  EXPECT_TRUE(pad.events().empty());
  EXPECT_FALSE(pad.is_there());
}

TEST(Gamepad, SaysWhatIsWrongWithOneThatIsNotThere) {
  try {
    const Gamepad pad{"/nowhere/js0"};
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "/nowhere/js0: No such file or directory; is the gamepad plugged in, and is this user in the group "
                 "input?");
  }
}

}  // namespace
}  // namespace tandem::cli
