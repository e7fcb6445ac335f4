#include "services/cli/topics/topics_view.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "services/cli/live_terminal.hpp"

namespace tandem::cli {
namespace {

TopicsView some_view() {
  TopicsView view;
  view.watched_s = 3.0;
  TopicView odometry{"odometry", {}, {{"robot1", "navigator"}, {"robot1", "tracker"}, {"robot2", "relay"}}};
  WriterView base;
  base.host = "robot1";
  base.service = "base";
  base.samples = 57;
  base.rate_hz = 19.96;
  base.age_s = 0.04;
  base.lost = 3;
  odometry.writers.push_back(base);
  base.service = "old";
  base.alive = false;
  base.samples = base.lost = 0;
  base.rate_hz = 0.0;
  base.age_s.reset();
  base.malformed = 2;
  odometry.writers.push_back(base);
  view.topics = {odometry, TopicView{"scan", {}, {{"robot1", "base"}}}, TopicView{"sonar", {}, {}}};
  view.services = {{"robot1", "base", "robot1", 12, "1.0.0", "abc", "degraded", "X6: two"}};
  view.faults = {{"X6", "two bases"}};
  return view;
}

TEST(TopicsView, IsATableWithTheFaultsOnTop) {
  const std::vector<std::string> expected{
      "X6: two bases",
      "",
      "TOPIC     HOST    WRITER      HZ    AGE_S  LOSS_%  BAD  READERS",
      "odometry  robot1  base        20.0  0.0    5.0     -    navigator tracker@robot1, relay@robot2",
      "          robot1  old (gone)  0.0   -      0.0     2    ",
      "scan      -       -           -     -      -       -    base@robot1",
      "",
      "SERVICE  HOST    PROCESS  VERSION  CONTRACT  STATE     REASON",
      "base     robot1  12       1.0.0    abc       degraded  X6: two",
  };
  EXPECT_EQ(lines_of(some_view()), expected);
}

TEST(TopicsView, SaysWhatToDoWhereNobodyIs) {
  ASSERT_EQ(lines_of({}).size(), 1U);
  EXPECT_NE(lines_of({})[0].find("--domain"), std::string::npos);
}

TEST(TopicsView, IsJsonOnOneLine) {
  const std::string text = json_of(some_view());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(text);
  const auto& writers = json.at("topics").at(0).at("writers");
  EXPECT_EQ(writers.at(0).at("samples"), 57);
  EXPECT_DOUBLE_EQ(writers.at(0).at("loss"), 0.05);
  EXPECT_TRUE(writers.at(1).at("age_s").is_null());
  EXPECT_EQ(json.at("topics").at(0).at("readers").at(2).at("host"), "robot2");
  EXPECT_EQ(json.at("services").at(0).at("reason"), "X6: two");
  EXPECT_EQ(json.at("faults").at(0).at("id"), "X6");
}

TEST(TopicsView, ANameThatIsNoTextBreaksNeitherJsonNorTerminal) {
  TopicsView view = some_view();
  view.topics[0].writers[0].service = "evil\x1b[2J\xff";
  EXPECT_NO_THROW(std::ignore = json_of(view));
  EXPECT_EQ(printable("evil\x1b[2J\n"), "evil?[2J?");
}

}  // namespace
}  // namespace tandem::cli
