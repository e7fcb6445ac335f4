#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

struct Outcome {
  int code = -1;
  std::string output;
};

/// What `tandem plan config/scenarios/SCENARIO ARGUMENTS` prints.
Outcome plan(const std::string& scenario, const std::string& arguments) {
  Outcome outcome;
  const std::string command =
      TANDEM_BINARY_DIR "/bin/tandem plan " TANDEM_SOURCE_DIR "/config/scenarios/" + scenario + " " + arguments;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;) outcome.output.append(block.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

TEST(PlanCommand, PrintsJsonAndWritesAPicture) {
  const test::TemporaryFolder folder;
  const auto file = folder / "plan.svg";
  const Outcome outcome = plan("tasks/supermarket.json", "--rollouts 100 --seed 2 --json --picture " + file.string());
  EXPECT_EQ(outcome.code, 0);
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json.at("scenario"), "supermarket");
  EXPECT_EQ(json.at("seed"), 2);
  EXPECT_NEAR(json.at("value"), 17.0, 1e-6);
  EXPECT_TRUE(read_file(file).starts_with("<svg "));
}

TEST(PlanCommand, WrongUseIsToldInOneLineAndEndsWithTwo) {
  const Outcome nobody = plan("planning/brl_search.json", "--planner nobody 2>&1");
  EXPECT_EQ(nobody.code, 2);
  EXPECT_NE(nobody.output.find("no planner 'nobody'; there are: "), std::string::npos) << nobody.output;
  const Outcome no_search = plan("tasks/supermarket.json", "--planner greedy 2>&1");
  EXPECT_EQ(no_search.code, 2);
  EXPECT_NE(no_search.output.find("without a search"), std::string::npos) << no_search.output;
  EXPECT_EQ(plan("tasks/supermarket.json", "--rollouts 5 --budget-ms 5 2>&1").code, 2);
  EXPECT_EQ(plan("tasks/supermarket.json", "--budget-ms 0 2>&1").code, 2);
  EXPECT_EQ(plan("", "--unknown 2>&1").code, 2);
}

TEST(PlanCommand, AScenarioThatCannotBeReadIsNamed) {
  const Outcome outcome = plan("planning.schema.json", "2>&1");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("planning.schema.json: "), std::string::npos) << outcome.output;
  EXPECT_EQ(plan("no_such.json", "2>&1").code, 1);
}

TEST(PlanCommand, AnotherProgramPlans) {
  const Outcome outcome = plan("planning/brl_search.json", "--json --planner 'exec:python3 " TANDEM_SOURCE_DIR
                                                           "/bench/planning/examples/nearest_unseen.py'");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_GT(nlohmann::json::parse(outcome.output).at("p_found"), 0.01);  // it plans one leg at a time
}

}  // namespace
}  // namespace tandem::cli
