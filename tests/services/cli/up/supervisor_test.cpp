#include "services/cli/up/supervisor.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "services/common/clock.hpp"

namespace tandem::cli {
namespace {

using std::chrono::seconds;

std::filesystem::path log_file(const std::string& name) {
  const auto file = std::filesystem::path{testing::TempDir()} / ("tandem_supervisor_" + name + ".log");
  std::filesystem::remove(file);
  return file;
}

/// Waits until a child has ended by itself.
std::vector<ProcessEnd> wait_for_end(Supervisor& supervisor) {
  SteadyClock clock;
  const Time deadline = clock.now() + seconds{20};
  std::vector<ProcessEnd> ends;
  clock.wait_until(deadline, [&] { return !(ends = supervisor.ended()).empty(); });
  return ends;
}

TEST(Supervisor, TellsWhichProcessEndedAndItsLastWords) {
  Supervisor supervisor;
  supervisor.start({"robot/base", "/bin/sh", {"-c", "echo first; echo no answer from /dev/pioneer; exit 3"},
                    log_file("end")});

  const auto ends = wait_for_end(supervisor);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_EQ(ends[0].name, "robot/base");
  EXPECT_EQ(ends[0].code, 3);
  EXPECT_EQ(ends[0].last_log, "no answer from /dev/pioneer");
}

TEST(Supervisor, StopsAlsoAFrozenProcess) {
  Supervisor supervisor;
  supervisor.start({"frozen", "/bin/sleep", {"1000"}, log_file("frozen")});
  EXPECT_TRUE(supervisor.is_running("frozen"));
  EXPECT_TRUE(supervisor.signal("frozen", SIGSTOP));

  supervisor.stop_all(seconds{10});
  EXPECT_FALSE(supervisor.is_running("frozen"));
}

TEST(Supervisor, AProgramThatIsNotThereIsNamed) {
  Supervisor supervisor;
  try {
    supervisor.start({"x", "/nowhere/tandem-x", {}, log_file("none")});
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string{error.what()}.find("/nowhere/tandem-x"), std::string::npos);
  }
}

}  // namespace
}  // namespace tandem::cli
