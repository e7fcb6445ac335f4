#include "services/cli/up/supervisor.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "services/common/clock.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

using std::chrono::seconds;

/// Waits until a child has ended by itself.
std::vector<ProcessEnd> wait_for_end(Supervisor& supervisor) {
  SteadyClock clock;
  const Time deadline = clock.now() + seconds{20};
  std::vector<ProcessEnd> ends;
  clock.wait_until(deadline, [&] { return !(ends = supervisor.ended()).empty(); });
  return ends;
}

TEST(Supervisor, TellsWhichProcessEndedAndItsLastWords) {
  const test::TemporaryFolder folder;
  Supervisor supervisor;
  supervisor.start(
      {"robot/base", "/bin/sh", {"-c", "echo first; echo no answer from /dev/pioneer; exit 3"}, folder / "end.log"});

  const auto ends = wait_for_end(supervisor);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].name, "robot/base");
  EXPECT_EQ(ends[0].code, 3);
  EXPECT_EQ(ends[0].last_log, "no answer from /dev/pioneer");
}

TEST(Supervisor, StopsAlsoAFrozenProcess) {
  const test::TemporaryFolder folder;
  Supervisor supervisor;
  supervisor.start({"frozen", "/bin/sleep", {"1000"}, folder / "frozen.log"});
  EXPECT_TRUE(supervisor.is_running("frozen"));
  EXPECT_TRUE(supervisor.signal("frozen", SIGSTOP));

  supervisor.stop_all(seconds{10});
  EXPECT_FALSE(supervisor.is_running("frozen"));
}

TEST(Supervisor, AProgramThatIsNotThereIsNamed) {
  const test::TemporaryFolder folder;
  Supervisor supervisor;
  try {
    supervisor.start({"x", "/nowhere/tandem-x", {}, folder / "none.log"});
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string{error.what()}.find("/nowhere/tandem-x"), std::string::npos);
  }
}

}  // namespace
}  // namespace tandem::cli
