// `tandem doctor` beside a whole team: it finds nothing where nothing is wrong, and names what is.
#include <gtest/gtest.h>

#include <cstdio>
#include <future>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/domain_lease.hpp"
#include "tests/support/simulated_team.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

struct Examination {
  int code = -1;
  nlohmann::json report;
};

Examination examine(const std::filesystem::path& config) {
  const std::string command =
      TANDEM_BINARY_DIR "/bin/tandem doctor --profile simulation --json --config " + config.string();
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  const int status = pclose(pipe);
  return {WEXITSTATUS(status), nlohmann::json::parse(text, nullptr, false)};
}

/// Lets the team go on while the doctor listens to the host whose configuration is in `config`.
Examination examine_beside(SimulatedTeam& team, const std::filesystem::path& config) {
  auto examination = std::async(std::launch::async, examine, config);
  const auto is_over = [&] { return examination.wait_for(seconds{0}) == std::future_status::ready; };
  EXPECT_TRUE(team.run_until(seconds{30}, is_over)) << team.last_words();
  return examination.get();
}

std::string verdict_on(const Examination& examination, const std::string& what) {
  for (const auto& line : examination.report["lines"]) {
    if (line["what"] == what) return line["verdict"];
  }
  return "no such line";
}

TEST(Doctor, FindsNothingWrongWithATeamThatSearches) {
  const DomainLease domains{3};
  TeamOptions options;
  options.scenario = "brl";  // long enough to be looked at three times
  options.robot_domain = domains[0];
  options.laptop_domain = domains[1];
  options.link_domain = domains[2];
  SimulatedTeam team{options};
  ASSERT_TRUE(team.run_until(seconds{60}, [&] { return team.episode().phase() == cli::Episode::Phase::Running; }))
      << team.last_words();
  for (const auto& config : {team.folder().robot_config, team.folder().laptop_config}) {
    const Examination found = examine_beside(team, config);
    EXPECT_EQ(found.code, 0) << found.report.dump(2);
    EXPECT_EQ(verdict_on(found, "link to the other host"), "ok");
  }

  team.kill("robot1", "laser");
  const Examination found = examine_beside(team, team.folder().robot_config);
  EXPECT_EQ(found.code, 2);
  EXPECT_EQ(verdict_on(found, "service laser"), "error");
  EXPECT_EQ(verdict_on(found, "laser"), "error");
  EXPECT_EQ(verdict_on(found, "service camera"), "ok");
}

}  // namespace
}  // namespace tandem::test
