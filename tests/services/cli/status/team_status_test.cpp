#include "services/cli/status/team_status.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tandem::cli {
namespace {

TeamStatus well() {
  TeamStatus status{.host = "laptop1", .robot = "robot1", .agent = "person1"};
  status.services = {{"robot1", "base", "ok", "", "0.1.0"}, {"robot1", "laser", "ok", "", "0.1.0"}};
  status.link = LinkView{"robot1", true, false, 0.012, 0.02, -0.001};
  status.robot_status = RobotStatus{.map_from_base = Pose2{1.0, 2.0, 0.0},
                                    .localization = "ok",
                                    .agreement = 0.93,
                                    .connected = true,
                                    .stop_reasons = {},
                                    .battery_v = 12.4,
                                    .speed_limit_mps = 0.5};
  status.execution = "moving";
  status.person = PersonStatus{{3.0, 4.0, 0.0}, true, 0.4};
  status.session = SessionView{"P07", "running", "app", 61.0, ""};
  status.plan = PlanView{"accepted", "peers", 84.0, "the corridor first"};
  status.explored = 0.25;
  return status;
}

bool has_line(const TeamStatus& status, const std::string& line) {
  const auto lines = lines_of(status);
  return std::ranges::find(lines, line) != lines.end();
}

TEST(TeamStatus, IsReadAtAGlance) {
  EXPECT_FALSE(is_troubled(well()));
  for (const char* line :
       {"link       up to robot1, round trip 12 ms, 2 % lost, clocks -1 ms",
        "robot1     at (1.00, 2.00) m, localization ok (93 % of beams fit), moving, battery 12.4 V, at most 0.50 m/s",
        "person1    tracked at (3.00, 4.00) m", "session    P07 running, 61 s, condition app",
        "plan       accepted, peers, 84 s expected: the corridor first", "explored   25 %",
        "robot1         base           ok        0.1.0      "}) {
    EXPECT_TRUE(has_line(well(), line)) << line;
  }
}

TEST(TeamStatus, SaysWhatIsWrong) {
  auto status = well();
  status.link->up = false;
  status.robot_status->stop_reasons = {"no link", "something is in the way"};
  status.robot_status->latched = true;
  status.robot_status->connected = false;
  status.person->tracked = false;
  status.person->age_s = 12.0;
  status.services[1] = {"robot1", "laser", "gone", "no answer", "0.1.0"};
  EXPECT_TRUE(is_troubled(status));
  for (const char* line :
       {"link       DOWN to robot1",
        "robot1     at (1.00, 2.00) m, localization ok (93 % of beams fit), controller SILENT, "
        "stopped: no link; something is in the way (needs tandem resume), battery 12.4 V, at most "
        "0.50 m/s",
        "person1    lost for 12 s", "robot1         laser          gone      0.1.0      no answer"}) {
    EXPECT_TRUE(has_line(status, line)) << line;
  }
}

TEST(TeamStatus, OfNobodySaysSo) {
  const TeamStatus nobody{.host = "laptop1", .robot = "robot1", .agent = "person1"};
  EXPECT_TRUE(is_troubled(nobody));
  EXPECT_TRUE(has_line(nobody, "link       no relay on this host"));
  EXPECT_TRUE(has_line(nobody, "No service is heard on this host: do they run (tandem doctor)?"));
}

TEST(TeamStatus, EachTroubleCounts) {
  for (const char* state : {"starting", "degraded", "failed", "gone"}) {
    auto status = well();
    status.services[0].state = state;
    EXPECT_TRUE(is_troubled(status)) << state;
  }
}

TEST(TeamStatus, JsonHoldsTheSame) {
  const auto json = nlohmann::json::parse(json_of(well()));
  EXPECT_EQ(json["link"]["peer"], "robot1");
  EXPECT_EQ(json["robot_status"]["map_from_base"]["y"], 2.0);
  EXPECT_EQ(json["session"]["code"], "P07");
  EXPECT_EQ(json["plan"]["role"], "peers");
  EXPECT_EQ(json["services"].size(), 2U);
  EXPECT_EQ(json["troubled"], false);
  EXPECT_FALSE(nlohmann::json::parse(json_of({})).contains("link"));
}

}  // namespace
}  // namespace tandem::cli
