// What people draw, what is recorded of their phones, and two people without a robot, through the whole gateway.
#include "tests/gateway/server/gateway_fixture.hpp"

namespace tandem::gateway {
namespace {

class GatewayEditsTest : public GatewayServiceTest {};

TEST_F(GatewayEditsTest, CarriesWhatIsDrawnAndSaid) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send(R"({"type":"cmd","client":"phone-0001","sequence":1,"kind":"source_edit","age_ms":0,)"
                         R"("edit":"avoid","outline":[[1,2],[3,2],[3,4]],"strength":"a_bit","target":"robot"})"));
  ASSERT_TRUE(phone.send(R"({"type":"cmd","client":"phone-0001","sequence":2,"kind":"belief_edit","age_ms":0,)"
                         R"("edit":"searched","outline":[[1,2]],"strength":"well"})"));
  const auto refused = hear<protocol::Ack>(phone, [](const auto& ack) { return ack.up_to == 2; });
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->results.back(), (protocol::Result{2, "refused", "the search has not begun"}));

  ASSERT_EQ(drawn_.size(), 1u);
  EXPECT_EQ(drawn_[0].kind(), msg::EDIT_AVOID);
  EXPECT_EQ(drawn_[0].source_id(), "avoid-phone-0001-1");
  EXPECT_EQ(drawn_[0].strength(), "a bit");
  EXPECT_EQ(drawn_[0].targets(), std::vector<std::string>{"robot1"});
  EXPECT_EQ(drawn_[0].boundary_in_map().size(), 3u);
  EXPECT_EQ(drawn_[0].who(), "person1");
  ASSERT_EQ(said_.size(), 1u);
  EXPECT_EQ(said_[0].kind(), msg::BELIEF_SEARCHED);
  EXPECT_EQ(said_[0].strength(), "well");
}

TEST_F(GatewayEditsTest, ShowsWhatIsDrawnUntilItIsGone) {
  auto sources = bus_.writer(topic::kRewardSource);
  msg::RewardSource drawn;
  drawn.id("avoid-phone-0001-1");
  drawn.boundary_in_map().resize(3);
  sources.write(drawn);
  msg::RewardSource goal;
  goal.id("goal of person1");  // not drawn: the plan shows it
  sources.write(goal);
  WebSocketClient phone{link("participant"), patient()};
  const auto shown = hear<protocol::Sources>(phone, [](const auto& one) { return !one.sources.empty(); });
  ASSERT_TRUE(shown);
  ASSERT_EQ(shown->sources.size(), 1u);
  EXPECT_EQ(shown->sources[0].edit, "avoid");
  sources.dispose(drawn);
  EXPECT_TRUE(hear<protocol::Sources>(phone, [](const auto& one) { return one.sources.empty(); }));
}

TEST_F(GatewayEditsTest, RecordsRemindersHoweverLateTheyCome) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send(R"({"type":"cmd","client":"phone-0001","sequence":1,"kind":"reminder","age_ms":60000,)"
                         R"("reminder":"toast","threshold_ms":8320})"));
  ASSERT_TRUE(phone.send(R"({"type":"cmd","client":"phone-0001","sequence":2,"kind":"reminder","age_ms":58000,)"
                         R"("reminder":"toast","threshold_ms":8320,"obeyed_after_ms":2000})"));
  ASSERT_TRUE(hear<protocol::Ack>(phone, [](const auto& ack) { return ack.up_to == 2; }));
  ASSERT_TRUE(eventually(bus_, [&] { return reminded_.size() == 2; }));
  EXPECT_TRUE(reminded_[0].fired());
  EXPECT_FALSE(reminded_[0].obeyed());
  EXPECT_DOUBLE_EQ(reminded_[0].threshold_s(), 8.32);
  EXPECT_TRUE(reminded_[1].obeyed());
  EXPECT_NEAR(1e-9 * static_cast<double>(reminded_[1].stamp_ns() - reminded_[0].stamp_ns()), 2.0, 0.5);
}

TEST_F(GatewayEditsTest, TellsPhonesOfTheSessionAndItsReminder) {
  auto sessions = bus_.writer(topic::kSession);
  config_.reminder_threshold_s = 8.32;
  start_gateway();
  WebSocketClient phone{link("participant"), patient()};
  const auto none = hear<protocol::Session>(phone, [](const auto&) { return true; });
  ASSERT_TRUE(none);
  EXPECT_EQ(none->phase, "none");
  EXPECT_EQ(none->reminder.kind, "none");

  msg::SessionState session;
  session.robot("robot1");
  session.phase(msg::SESSION_RUNNING);
  session.reminder("multimodal");
  sessions.write(session);
  const auto running = hear<protocol::Session>(phone, [](const auto& one) { return one.phase == "running"; });
  ASSERT_TRUE(running);
  EXPECT_EQ(running->reminder, (protocol::ReminderRule{"multimodal", 8320.0, 0.75, 3000.0}));
}

TEST_F(GatewayEditsTest, TwoPeopleSeeEachOtherWithoutARobot) {
  config_.mode = "human_human";
  config_.partner = "person2";
  start_gateway();
  WebSocketClient anna{link("participant"), patient()};
  WebSocketClient berta{link("partner"), patient()};
  const auto hello = hear<protocol::Hello>(berta, [](const auto&) { return true; });
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->agent, "person2");
  ASSERT_TRUE(hear<protocol::Hello>(anna, [](const auto&) { return true; }));

  ASSERT_TRUE(anna.send(command(1, CommandKind::MyPose, protocol::Point{3.0, 4.0})));
  const auto partner = hear<protocol::State>(berta, [](const auto& state) { return state.partner.has_value(); });
  ASSERT_TRUE(partner);
  EXPECT_EQ(partner->partner->position, (protocol::Point{3.0, 4.0}));
  EXPECT_FALSE(partner->person);
  ASSERT_TRUE(hear<protocol::State>(anna, [](const auto& state) { return state.person && !state.partner; }));

  ASSERT_TRUE(anna.send(command(2, CommandKind::Replan)));
  const auto refused = hear<protocol::Ack>(anna, [](const auto& ack) { return ack.up_to == 2; });
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->results.back().reason, "there is no robot in this search");
}

/// That the phone is let in with its cookie then is a browser test's: it needs a gateway on the port of the first.
TEST_F(GatewayEditsTest, KeepsWhoMayComeBackForTheNextGateway) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  const std::string kept = read_file(folder_ / "sessions");
  EXPECT_NE(kept.find(" participant "), std::string::npos) << kept;
  EXPECT_EQ(std::filesystem::status(folder_ / "sessions").permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  start_gateway();
  EXPECT_EQ(read_file(folder_ / "sessions"), kept);
}

}  // namespace
}  // namespace tandem::gateway
