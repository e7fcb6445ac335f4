// The command as a process, at a terminal of its own and without one.
#include <gtest/gtest.h>

#include <string>

#include "services/bus/bus.hpp"
#include "tests/services/cli/on_terminal.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::cli {
namespace {

using test::expect_restored;

std::vector<std::string> watching(int domain) {
  return {"topics", "--watch", "--domain", std::to_string(domain)};
}

/// Somebody to be shown.
bus::DomainOptions base_in(int domain) {
  bus::DomainOptions options;
  options.domain = domain;
  options.participant = "base@robot1";
  return options;
}

TEST(LiveTable, ShowsWhoIsThereUntilQAndRestoresTheTerminal) {
  const test::DomainLease domain{1};
  bus::Bus base{base_in(domain[0])};
  auto odometry = base.writer(topic::kOdometry);
  test::OnTerminal terminal{watching(domain[0])};
  EXPECT_TRUE(terminal.shows("odometry  robot1  base"));
  EXPECT_FALSE(terminal.is_as_before());
  terminal.press('q');
  EXPECT_EQ(terminal.exit_code(), 0);
  expect_restored(terminal);
}

TEST(LiveTable, CtrlCEndsItAsWell) {
  const test::DomainLease domain{1};
  test::OnTerminal terminal{watching(domain[0])};
  EXPECT_TRUE(terminal.shows("Nobody is here"));
  terminal.press(3);  // the terminal makes it SIGINT
  EXPECT_EQ(terminal.exit_code(), 0);
  expect_restored(terminal);
}

TEST(LiveTable, IsPlainTextWhereThereIsNoTerminal) {
  const test::DomainLease domain{1};
  bus::Bus base{base_in(domain[0])};
  auto odometry = base.writer(topic::kOdometry);
  const std::string command = TANDEM_BINARY_DIR "/bin/tandem topics --watch --seconds 4.5 --domain " +
                              std::to_string(domain[0]) + " < /dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  char buffer[4096];
  while (const auto count = fread(buffer, 1, sizeof(buffer), pipe)) output.append(buffer, count);
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(output.find('\x1b'), std::string::npos);
  std::size_t tables = 0;
  for (auto at = output.find("TOPIC"); at != std::string::npos; at = output.find("TOPIC", at + 1)) ++tables;
  EXPECT_GE(tables, 2U) << output;
}

}  // namespace
}  // namespace tandem::cli
