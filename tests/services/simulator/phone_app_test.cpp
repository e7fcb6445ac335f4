#include "services/simulator/phone_app.hpp"

#include <gtest/gtest.h>

namespace tandem::simulator {
namespace {

std::string hello() {
  return protocol::write(protocol::ServerMessage{
      protocol::Hello{.epoch = "e1", .role = protocol::UserRole::Participant, .agent = "person1", .robot = "robot1"}});
}

std::string ack(std::uint64_t up_to) {
  return protocol::write(
      protocol::ServerMessage{protocol::Ack{.client = "simulated-phone-1", .up_to = up_to, .results = {}}});
}

protocol::Command command_in(const std::string& text) {
  const auto parsed = protocol::parse_client_message(text);
  const auto* message = std::get_if<protocol::ClientMessage>(&parsed);
  EXPECT_NE(message, nullptr) << text;
  return message == nullptr ? protocol::Command{} : std::get<protocol::Command>(*message);
}

TEST(PhoneApp, SendsAPressAsANumberedCommand) {
  PhoneApp app{"simulated-phone-1", "person1"};
  EXPECT_TRUE(app.receive(hello(), Time{}).empty());
  EXPECT_TRUE(app.view().connected);

  const auto sent = app.press({PhonePress::MyPose, Eigen::Vector2d{1.0, 2.0}, 0.5}, Time{});
  ASSERT_EQ(sent.size(), 1U);
  const auto command = command_in(sent[0]);
  EXPECT_EQ(command.kind, protocol::CommandKind::MyPose);
  EXPECT_EQ(command.sequence, 1U);
  EXPECT_EQ(command.point_in_map, (protocol::Point{1.0, 2.0}));
  EXPECT_EQ(command.heading, 0.5);
}

TEST(PhoneApp, RepeatsAfterAReconnectionWhatWasNotAcknowledged) {
  PhoneApp app{"simulated-phone-1", "person1"};
  (void)app.receive(hello(), Time{});
  (void)app.press({PhonePress::Replan, {}, {}}, Time{});
  (void)app.press({PhonePress::Found, Eigen::Vector2d{1.0, 2.0}, {}}, Time{});
  (void)app.receive(ack(1), Time{});
  app.connected_anew();
  EXPECT_FALSE(app.view().connected);

  const auto again = app.receive(hello(), Time{} + std::chrono::seconds{2});
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(command_in(again[0]).kind, protocol::CommandKind::Found);
  EXPECT_EQ(command_in(again[0]).sequence, 2U);
  EXPECT_EQ(command_in(again[0]).age_ms, 2000.0);
}

TEST(PhoneApp, KeepsAPressWhileNotConnected) {
  PhoneApp app{"simulated-phone-1", "person1"};
  EXPECT_TRUE(app.press({PhonePress::Replan, {}, {}}, Time{}).empty());
  EXPECT_EQ(app.receive(hello(), Time{}).size(), 1U);
}

TEST(PhoneApp, ShowsThePersonsOwnPathOfAPlanThatHolds) {
  PhoneApp app{"simulated-phone-1", "person1"};
  protocol::Plan plan;
  plan.id = "p1";
  plan.state = "proposed";
  plan.paths = {{.agent = "robot1", .points = {{0.0, {9.0, 9.0}}}, .goal = {9.0, 9.0}},
                {.agent = "person1", .points = {{0.0, {1.0, 2.0}}, {1.0, {3.0, 4.0}}}, .goal = {3.0, 4.0}}};
  (void)app.receive(protocol::write(protocol::ServerMessage{plan}), Time{});
  ASSERT_TRUE(app.view().plan);
  EXPECT_EQ(*app.view().plan, (PhonePlan{"p1", {{1.0, 2.0}, {3.0, 4.0}}}));
  plan.state = "rejected";
  (void)app.receive(protocol::write(protocol::ServerMessage{plan}), Time{});
  EXPECT_FALSE(app.view().plan);
}

TEST(PhoneApp, ShowsThatAPlanIsComputedAndThatTheSearchIsOver) {
  PhoneApp app{"simulated-phone-1", "person1"};
  protocol::State state;
  state.sequence = 4;
  state.planner.activity = "computing";
  const auto seen = app.receive(protocol::write(protocol::ServerMessage{state}), Time{});
  EXPECT_TRUE(app.view().computing);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0], protocol::write(protocol::ClientMessage{protocol::Seen{4}}));
  state.planner.activity = "finished";
  EXPECT_TRUE(app.receive(protocol::write(protocol::ServerMessage{state}), Time{}).empty());  // told a moment ago
  EXPECT_TRUE(app.view().search_over);
}

TEST(PhoneApp, TakesNoticeOfWhatThePersonIsTold) {
  PhoneApp app{"simulated-phone-1", "person1"};
  const protocol::Event found{"found", "robot1", {}};
  EXPECT_TRUE(app.receive(protocol::write(protocol::ServerMessage{found}), Time{}).empty());
  const protocol::Event inform{"inform", "The robot has searched 9 m² that you have not", {}, "planner-1"};
  const auto answers = app.receive(protocol::write(protocol::ServerMessage{inform}), Time{});
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0], protocol::write(protocol::ClientMessage{protocol::GotIt{"planner-1"}}));
}

TEST(PhoneApp, ShowsThatTheLastReplanWasRefusedUntilTheNext) {
  PhoneApp app{"simulated-phone-1", "person1"};
  (void)app.receive(hello(), Time{});
  (void)app.press({PhonePress::Replan, {}, {}}, Time{});
  const protocol::Ack refusal{.client = "simulated-phone-1", .up_to = 1, .results = {{1, "refused", "not begun"}}};
  (void)app.receive(protocol::write(protocol::ServerMessage{refusal}), Time{});
  EXPECT_TRUE(app.view().replan_refused);
  (void)app.press({PhonePress::Replan, {}, {}}, Time{});
  EXPECT_FALSE(app.view().replan_refused);
}

TEST(PhoneApp, CountsWhatIsNoMessage) {
  PhoneApp app{"simulated-phone-1", "person1"};
  EXPECT_TRUE(app.receive("{\"type\":", Time{}).empty());
  EXPECT_EQ(app.malformed(), 1);
}

}  // namespace
}  // namespace tandem::simulator
