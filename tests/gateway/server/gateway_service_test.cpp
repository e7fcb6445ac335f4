#include "gateway/server/gateway_service.hpp"

#include "tests/gateway/server/gateway_fixture.hpp"

namespace tandem::gateway {
namespace {

TEST_F(GatewayServiceTest, CarriesAPoseToTheTeamAndTheirReceiptBack) {
  WebSocketClient phone{link("participant"), patient()};
  const auto hello = hear<protocol::Hello>(phone, [](const auto&) { return true; });
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->role, protocol::UserRole::Participant);

  ASSERT_TRUE(phone.send(command(1, CommandKind::MyPose, protocol::Point{3.0, 4.0})));
  const auto applied = hear<protocol::Ack>(phone, [](const auto& ack) { return !ack.results.empty(); });
  ASSERT_TRUE(applied);
  EXPECT_EQ(applied->up_to, 1u);
  EXPECT_EQ(applied->results[0], (protocol::Result{1, "applied", ""}));
  ASSERT_EQ(human_messages_.size(), 1u);
  EXPECT_EQ(human_messages_[0].kind(), msg::HUMAN_MY_POSE);
  EXPECT_DOUBLE_EQ(human_messages_[0].point_in_map().x(), 3.0);
  EXPECT_EQ(human_messages_[0].agent(), "person1");
}

TEST_F(GatewayServiceTest, CoversACommandOnlyWhenItsFateIsKnown) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send(command(1, CommandKind::RobotPose, protocol::Point{3.0, 4.0})));  // nobody answers it here
  ASSERT_TRUE(phone.send(command(2, CommandKind::Replan)));
  const auto applied = hear<protocol::Ack>(phone, [](const auto& ack) { return !ack.results.empty(); });
  ASSERT_TRUE(applied);
  EXPECT_EQ(applied->results[0], (protocol::Result{2, "applied", ""}));
  EXPECT_EQ(applied->up_to, 0u);
}

TEST_F(GatewayServiceTest, NoMessageOvertakesTheOneBefore) {
  answers_ = false;
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send(command(1, CommandKind::MyGoal, protocol::Point{1.0, 1.0})));
  ASSERT_TRUE(phone.send(command(2, CommandKind::MyGoal, protocol::Point{2.0, 2.0})));
  ASSERT_TRUE(phone.send(protocol::write(protocol::ClientMessage{protocol::Ping{7.0}})));
  ASSERT_TRUE(hear<protocol::Pong>(phone, [](const auto&) { return true; }));  // the gateway has read both
  ASSERT_TRUE(eventually(bus_, [&] { return !human_messages_.empty(); }));
  EXPECT_EQ(human_messages_.size(), 1u);
  answers_ = true;
  ASSERT_TRUE(eventually(bus_, [&] { return human_messages_.size() == 2; }));
  EXPECT_DOUBLE_EQ(human_messages_[1].point_in_map().x(), 2.0);
}

TEST_F(GatewayServiceTest, ACommandThatComesAgainToANewGatewayIsTheSameEvent) {
  std::optional<WebSocketClient> phone{std::in_place, link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(*phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone->send(command(1, CommandKind::Replan)));
  ASSERT_TRUE(eventually(bus_, [&] { return human_messages_.size() == 1; }));

  start_gateway();
  phone.emplace(link("participant"), patient());
  ASSERT_TRUE(hear<protocol::Hello>(*phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone->send(command(1, CommandKind::Replan)));
  const auto applied = hear<protocol::Ack>(*phone, [](const auto& ack) { return !ack.results.empty(); });
  ASSERT_TRUE(applied);
  EXPECT_EQ(applied->up_to, 1u);
  EXPECT_EQ(applied->results[0], (protocol::Result{1, "applied", ""}));
  EXPECT_EQ(human_messages_.size(), 1u);
}

TEST_F(GatewayServiceTest, AppliesACommandThatComesTwiceOnce) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send(command(1, CommandKind::Replan)));
  ASSERT_TRUE(phone.send(command(1, CommandKind::Replan)));
  ASSERT_TRUE(phone.send(command(2, CommandKind::Stop)));
  ASSERT_TRUE(hear<protocol::Ack>(phone, [](const auto& ack) { return ack.up_to == 2 && !ack.results.empty(); }));
  EXPECT_TRUE(eventually(bus_, [&] { return stop_requests_.size() == 1 && human_messages_.size() == 1; }));
  EXPECT_EQ(stop_requests_[0].who(), "phone:person1");
  EXPECT_TRUE(stop_requests_[0].latched());
}

TEST_F(GatewayServiceTest, WhatThePersonIsToldIsAppliedOnlyWhenTheyHaveGotIt) {
  bus::EventSender planner{bus_, topic::kInform};
  msg::Inform inform;
  inform.agent("person1");
  inform.id(bus::new_event_id("planner", clock_));
  inform.reason("The robot has searched 34 m² that you have not");
  planner.send(inform);
  msg::Inform strange = inform;
  strange.agent("person2");
  strange.id(bus::new_event_id("planner", clock_));
  planner.send(strange);
  const auto state = [&](const std::string& id) {
    planner.step();
    return planner.outcome(id).state;
  };
  ASSERT_TRUE(eventually(bus_, [&] { return state(strange.id()) == bus::EventOutcome::State::Refused; }));

  WebSocketClient observer{link("observer"), patient()};  // comes later, and may not answer for the person
  const auto is_inform = [](const auto& event) { return event.kind == "inform"; };
  const auto shown = hear<protocol::Event>(observer, is_inform);
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->text, inform.reason());
  EXPECT_EQ(shown->id, inform.id());
  const auto got_it = protocol::write(protocol::ClientMessage{protocol::GotIt{shown->id}});
  const auto ping = protocol::write(protocol::ClientMessage{protocol::Ping{7.0}});
  ASSERT_TRUE(observer.send(got_it));
  ASSERT_TRUE(observer.send(ping));
  ASSERT_TRUE(hear<protocol::Pong>(observer, [](const auto&) { return true; }));
  EXPECT_EQ(state(inform.id()), bus::EventOutcome::State::Pending);

  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Event>(phone, is_inform));
  ASSERT_TRUE(phone.send(got_it));
  EXPECT_TRUE(eventually(bus_, [&] { return state(inform.id()) == bus::EventOutcome::State::Applied; }));
}

TEST_F(GatewayServiceTest, AnObserverIsToldWhyItMayNotAndMayStop) {
  WebSocketClient phone{link("observer"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send(command(1, CommandKind::Replan)));
  const auto refused = hear<protocol::Ack>(phone, [](const auto& ack) { return !ack.results.empty(); });
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->results[0].outcome, "refused");
  ASSERT_TRUE(phone.send(command(2, CommandKind::Stop)));
  EXPECT_TRUE(eventually(bus_, [&] { return stop_requests_.size() == 1; }));
  EXPECT_TRUE(human_messages_.empty());
}

TEST_F(GatewayServiceTest, ManyStopsAtOnceAllArrive) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  for (std::uint64_t i = 1; i <= 60; ++i) ASSERT_TRUE(phone.send(command(i, CommandKind::Replan)));
  for (std::uint64_t i = 61; i <= 70; ++i) ASSERT_TRUE(phone.send(command(i, CommandKind::Stop)));
  EXPECT_TRUE(eventually(bus_, [&] { return stop_requests_.size() == 10; }));
  EXPECT_LT(human_messages_.size(), 60u);  // 40 at once, then 20 a second
}

TEST_F(GatewayServiceTest, MalformedWebSocketJsonIsAnsweredAndTheThirdTimeClosed) {
  WebSocketClient phone{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(phone, [](const auto&) { return true; }));
  ASSERT_TRUE(phone.send("{\"type\":\"cmd\""));
  const auto error = hear<protocol::Event>(phone, [](const auto& event) { return event.kind == "error"; });
  ASSERT_TRUE(error);
  EXPECT_NE(error->text.find("not JSON at character"), std::string::npos) << error->text;
  ASSERT_TRUE(phone.send(std::string(5000, '[')));
  ASSERT_TRUE(phone.send("\xff\xfe"));  // not UTF-8: the socket itself refuses it
  EXPECT_TRUE(eventually(phone, [&] { return phone.state() != WebSocketClient::State::Connected; }));

  WebSocketClient other{link("observer"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(other, [](const auto&) { return true; }));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(other.send("{}"));
  EXPECT_TRUE(eventually(other, [&] { return other.reason().rfind("closed: 4002", 0) == 0; })) << other.reason();
}

TEST_F(GatewayServiceTest, NobodyElseIsInvitedWhileThePhoneIsHere) {
  WebSocketClient first{link("participant"), patient()};
  ASSERT_TRUE(hear<protocol::Hello>(first, [](const auto&) { return true; }));
  const std::string used = read_file(folder_ / "participant");
  EXPECT_TRUE(eventually(bus_, [] { return true; }));
  EXPECT_EQ(read_file(folder_ / "participant"), used);
  const auto rights = std::filesystem::status(folder_ / "participant").permissions();
  EXPECT_EQ(rights, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

}  // namespace
}  // namespace tandem::gateway
