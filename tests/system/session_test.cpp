// `tandem session` beside a team whose services run: a search is led, and ended from another terminal.
#include <gtest/gtest.h>

#include <cstdio>
#include <future>
#include <nlohmann/json.hpp>
#include <string>

#include "services/common/file_io.hpp"
#include "services/common/format.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/process.hpp"
#include "tests/support/simulated_team.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

struct Outcome {
  int code = -1;
  std::string output;  ///< both streams
};

Outcome session(const std::string& arguments) {
  FILE* pipe = popen((TANDEM_BINARY_DIR "/bin/tandem session " + arguments + " 2>&1").c_str(), "r");
  Outcome outcome;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) outcome.output += static_cast<char>(c);
  outcome.code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

/// Lets the team go on while the command runs.
Outcome session_beside(SimulatedTeam& team, const std::string& arguments, Duration within) {
  auto command = std::async(std::launch::async, session, arguments);
  const auto is_over = [&] { return command.wait_for(seconds{0}) == std::future_status::ready; };
  EXPECT_TRUE(team.run_until(within, is_over)) << team.last_words();
  return command.get();
}

TeamOptions options_in(const DomainLease& domains, const std::string& scenario) {
  TeamOptions options;
  options.scenario = scenario;
  options.robot_domain = domains[0];
  options.laptop_domain = domains[1];
  options.link_domain = domains[2];
  return options;
}

TEST(LedSession, StartLeadsASearchToTheFind) {
  const DomainLease domains{3};
  auto options = options_in(domains, "quick");
  options.is_led = false;
  SimulatedTeam team{options};
  const TemporaryFolder folder;
  const std::string result = (folder / "result.json").string();
  const Pose2& start = team.robot_start();
  const Outcome led = session_beside(team,
                                     "start P07 --headless --condition app --limit-s 200 --config " +
                                         team.folder().laptop_config.string() + " --json " + result +
                                         formatted(" --robot-pose %g %g %g", start.x, start.y, start.heading),
                                     seconds{240});
  EXPECT_EQ(led.code, 0) << led.output << team.last_words();
  const auto told = nlohmann::json::parse(read_file(result));
  EXPECT_EQ(told["session"], "P07");
  EXPECT_EQ(told["found"], true);
  team.stop();
  const std::string recordings = team.recording("laptop").parent_path().string();
  const Outcome listed = session("list --json --folder " + recordings);
  ASSERT_EQ(listed.code, 0) << listed.output;
  const auto rows = nlohmann::json::parse(listed.output);
  ASSERT_EQ(rows.size(), 2U) << "both hosts recorded it: " << listed.output;
  for (const auto& row : rows) {
    EXPECT_EQ(row["session"], "P07");
    EXPECT_EQ(row["outcome"], "found");
    EXPECT_EQ(row["condition"], "app");
  }
}

// A session that nobody leads any more would go on for ever.
TEST(LedSession, TheRobotStopsWhenWhoeverLeadsDies) {
  const DomainLease domains{3};
  auto options = options_in(domains, "brl");
  options.is_led = false;
  SimulatedTeam team{options};
  const Pose2& start = team.robot_start();
  Process leader{{TANDEM_BINARY_DIR "/bin/tandem", "session", "start", "P09", "--headless", "--config",
                  team.folder().laptop_config.string(), "--robot-pose", formatted("%g", start.x),
                  formatted("%g", start.y), formatted("%g", start.heading)}};
  ASSERT_TRUE(team.run_until(seconds{120}, [&] { return team.wheel_speed_mps().value_or(0.0) > 0.15; }))
      << team.last_words();
  leader.kill_at_once();
  constexpr double kLease_s = 6.5;  // and what Fast DDS takes to see that it ran out
  constexpr double kBraking_s = 1.5;
  EXPECT_LE(team.watch_wheels(seconds{12}).after_s, kLease_s + kBraking_s) << team.last_words();
}

TEST(LedSession, EndEndsTheSearchThatAnotherLeads) {
  const DomainLease domains{3};
  SimulatedTeam team{options_in(domains, "brl")};
  ASSERT_TRUE(team.run_until(seconds{90}, [&] { return team.wheel_speed_mps().value_or(0.0) > 0.15; }))
      << team.last_words();
  const std::string config = " --config " + team.folder().laptop_config.string();

  const Outcome second = session_beside(team, "start P08 --headless" + config, seconds{30});
  EXPECT_EQ(second.code, 1);
  EXPECT_NE(second.output.find("session test of robot1 runs already"), std::string::npos) << second.output;

  const Outcome ended = session_beside(team, "end" + config, seconds{30});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_NE(ended.output.find("session test ended: aborted"), std::string::npos) << ended.output;
  EXPECT_TRUE(team.run_until(seconds{10}, [&] { return team.episode().phase() == cli::Episode::Phase::Ended; }));
  EXPECT_TRUE(team.run_until(seconds{10}, [&] { return team.wheel_speed_mps().value_or(1.0) < 0.005; }))
      << "the robot stands when nobody searches";
}

}  // namespace
}  // namespace tandem::test
