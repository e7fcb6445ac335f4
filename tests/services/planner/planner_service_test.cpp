#include "services/planner/planner_service.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "services/bus/events.hpp"
#include "services/planner/edit_messages.hpp"
#include "services/planner/planner_messages.hpp"
#include "tests/services/planner/support/room.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

PlannerConfig quick_config() {
  PlannerConfig config;
  config.rollouts = 5;
  config.horizon_s = 20.0;
  return config;
}

SiteConfig site_in(int domain) {
  SiteConfig site;
  site.host = "laptop1";
  site.host_domain = domain;
  return site;
}

msg::OccupancyGrid map_message() {
  const OccupancyGrid grid = empty_room(10, 8);
  msg::OccupancyGrid message;
  message.map_id("hall");
  message.resolution_m(grid.resolution_m());
  message.width(static_cast<std::uint32_t>(grid.width()));
  message.height(static_cast<std::uint32_t>(grid.height()));
  for (const CellState cell : grid.cells()) message.cells().push_back(static_cast<std::uint8_t>(cell));
  return message;
}

/// The planner on a bus, and everybody else on another participant of the same domain.
class PlannerServiceTest : public ::testing::Test {
 protected:
  PlannerServiceTest() {
    map.write(map_message());
    tell_poses();
  }
  void tell_poses() {
    msg::RobotPose pose;
    pose.robot(site.robot);
    pose.stamp_ns(to_stamp_ns(clock.now()));
    pose.map_from_base().x(2.0);
    pose.map_from_base().y(2.0);
    robot_pose.write(pose);
    msg::TeammateState person;
    person.agent(site.agent);
    person.robot(site.robot);
    person.stamp_ns(to_stamp_ns(clock.now()));
    person.map_from_agent().x(person_x_m);
    person.map_from_agent().y(2.0);
    teammates.write(person);
  }
  void tell_session(msg::SessionPhase phase) {
    msg::SessionState state;
    state.robot(site.robot);
    state.code("S01");
    state.phase(phase);
    session.write(state);
  }
  /// Steps planner and time until `condition` holds.
  template <typename Condition>
  bool step_until(Condition condition) {
    return bus::wait_until(others, seconds{20}, [&] {
      clock.advance(milliseconds{100});
      tell_poses();
      service.step();
      messages.step();
      belief_edits.step();
      source_edits.step();
      detections.step();
      return condition();
    });
  }
  bool plan_is(msg::PlanState state) {
    return step_until([&] {
      const auto newest = team_plan.newest();
      return newest && newest->message.state() == state;
    });
  }
  bool answered(const std::string& id, bool applied) {
    bool found = false;
    return step_until([&] {
      for (const auto& receipt : receipts.take()) {
        found |= receipt.message.id() == id && receipt.message.applied() == applied;
      }
      return found;
    });
  }
  /// An edit of this team, of the place around a point.
  template <typename Edit>
  Edit edit_at(double x, double y) {
    Edit edit;
    edit.id(bus::new_event_id("test", others.clock()));
    edit.robot(site.robot);
    edit.who(site.agent);
    edit.boundary_in_map().resize(1);
    edit.boundary_in_map()[0].x(x);
    edit.boundary_in_map()[0].y(y);
    return edit;
  }
  std::string send(msg::HumanMessageKind kind, double x = 0.0, double y = 0.0) {
    msg::HumanMessage message;
    message.id(bus::new_event_id("test", others.clock()));
    message.agent(site.agent);
    message.robot(site.robot);
    message.kind(kind);
    message.point_in_map().x(x);
    message.point_in_map().y(y);
    const std::string id = message.id();
    human_message.write(message);
    return id;
  }

  double person_x_m = 3.0;
  test::DomainLease domains{1};
  SiteConfig site = site_in(domains[0]);
  ManualClock clock{from_stamp_ns(1'700'000'000'000'000'000)};
  bus::Bus planner_bus{bus::host_domain(site, "planner")};
  bus::Bus others{bus::host_domain(site, "others")};
  bus::Writer<msg::OccupancyGrid, msg::OccupancyGridPubSubType> map = others.writer(topic::kMap);
  bus::Writer<msg::RobotPose, msg::RobotPosePubSubType> robot_pose = others.writer(topic::kRobotPose);
  bus::Writer<msg::TeammateState, msg::TeammateStatePubSubType> teammates = others.writer(topic::kTeammates);
  bus::Writer<msg::SessionState, msg::SessionStatePubSubType> session = others.writer(topic::kSession);
  bus::Writer<msg::HumanMessage, msg::HumanMessagePubSubType> human_message = others.writer(topic::kHumanMessage);
  bus::EventSender<msg::HumanMessage, msg::HumanMessagePubSubType> messages{others, topic::kHumanMessage};
  bus::EventSender<msg::BeliefEdit, msg::BeliefEditPubSubType> belief_edits{others, topic::kBeliefEdit};
  bus::EventSender<msg::SourceEdit, msg::SourceEditPubSubType> source_edits{others, topic::kSourceEdit};
  bus::EventSender<msg::ObjectDetection, msg::ObjectDetectionPubSubType> detections{others, topic::kDetection};
  bus::InOrder<msg::MessageReceipt, msg::MessageReceiptPubSubType> receipts = others.in_order(topic::kMessageReceipt);
  bus::Latest<msg::TeamPlan, msg::TeamPlanPubSubType> team_plan = others.latest(topic::kTeamPlan);
  bus::Latest<msg::PlannerStatus, msg::PlannerStatusPubSubType> status = others.latest(topic::kPlannerStatus);
  bus::Latest<msg::SearchBelief, msg::SearchBeliefPubSubType> belief = others.latest(topic::kBelief);
  bus::Latest<msg::RewardSource, msg::RewardSourcePubSubType> sources = others.latest(topic::kRewardSource);
  bus::Latest<msg::SourceRelation, msg::SourceRelationPubSubType> relations = others.latest(topic::kSourceRelation);
  PlannerService service{quick_config(), site, {}, planner_bus, clock};
};

TEST_F(PlannerServiceTest, APlanIsProposedThenAcceptedThenRefreshedEverySecond) {
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));  // map and robot are known
  EXPECT_FALSE(team_plan.newest());
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_PROPOSED));
  ASSERT_TRUE(plan_is(msg::PLAN_ACCEPTED));
  const auto first = team_plan.newest()->message;
  EXPECT_EQ(first.session(), "S01");
  ASSERT_EQ(first.paths().size(), 2U);
  EXPECT_EQ(first.paths()[0].agent(), site.robot);
  EXPECT_GT(first.lower_bound_s(), 0.0);
  EXPECT_LE(first.lower_bound_s(), first.value());
  ASSERT_TRUE(step_until([&] { return team_plan.newest()->message.sequence_number() > first.sequence_number(); }));
  const auto second = team_plan.newest()->message;
  EXPECT_EQ(second.id(), first.id());
  EXPECT_NEAR(static_cast<double>(second.stamp_ns() - first.stamp_ns()), 1e9, 0.15e9);
}

TEST_F(PlannerServiceTest, MessagesGetReceiptsAndGoalsBecomeSources) {
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_PROPOSED));
  EXPECT_TRUE(answered(send(msg::HUMAN_MY_GOAL, 9.0, 7.0), true));
  EXPECT_TRUE(step_until([&] { return sources.newest().has_value(); }));
  EXPECT_EQ(sources.newest()->message.targets(), std::vector<std::string>{site.agent});
  EXPECT_TRUE(answered(send(msg::HUMAN_ROBOT_GOAL, 500.0, 7.0), false));  // outside
  EXPECT_TRUE(answered(send(msg::HUMAN_REPLAN), true));
  ASSERT_TRUE(step_until([&] {
    return team_plan.newest()->message.role() == msg::ROLE_PEER_PEER &&
           team_plan.newest()->message.paths()[1].goal_fixed();
  }));
}

TEST_F(PlannerServiceTest, ThePersonEditsTheBelief) {
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_PROPOSED));
  const std::string first = team_plan.newest()->message.id();
  auto likely = edit_at<msg::BeliefEdit>(8.0, 6.0);
  likely.kind(msg::BELIEF_LIKELY_HERE);
  likely.strength("very");
  belief_edits.send(likely);
  EXPECT_TRUE(answered(likely.id(), true));
  EXPECT_TRUE(step_until([&] { return team_plan.newest()->message.id() != first; }));
  EXPECT_TRUE(team_plan.newest()->message.reason().starts_with("The person knows something of where it is."));
  auto outside = edit_at<msg::BeliefEdit>(800.0, 6.0);
  belief_edits.send(outside);
  EXPECT_TRUE(answered(outside.id(), false));
}

TEST_F(PlannerServiceTest, WhatIsDrawnIsPublishedUntilItIsRemoved) {
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_PROPOSED));
  auto go = edit_at<msg::SourceEdit>(8.0, 6.0);
  go.kind(msg::EDIT_GO_TO);
  go.source_id("here");
  go.targets({site.agent});
  source_edits.send(go);
  ASSERT_TRUE(answered(go.id(), true));
  ASSERT_TRUE(step_until([&] { return relations.newest().has_value(); }));
  EXPECT_EQ(relations.newest()->message.from_id(), "here");
  EXPECT_EQ(relations.newest()->message.kind(), "codependent");
  auto removal = edit_at<msg::SourceEdit>(0.0, 0.0);
  removal.kind(msg::EDIT_REMOVE);
  removal.source_id("here");
  source_edits.send(removal);
  ASSERT_TRUE(answered(removal.id(), true));
  auto through = edit_at<msg::SourceEdit>(8.0, 6.0);
  through.kind(msg::EDIT_PASS_THROUGH);
  through.source_id("through");
  source_edits.send(through);
  EXPECT_TRUE(answered(through.id(), false));  // who?
  through.id(bus::new_event_id("test", others.clock()));
  through.targets({site.robot});
  source_edits.send(through);
  EXPECT_TRUE(answered(through.id(), true));
}

TEST_F(PlannerServiceTest, BehindSomebodyNeedsNoPlace) {
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_PROPOSED));
  auto behind = edit_at<msg::SourceEdit>(0.0, 0.0);
  behind.boundary_in_map().clear();
  behind.kind(msg::EDIT_STAY_BEHIND);
  behind.source_id("behind");
  source_edits.send(behind);
  ASSERT_TRUE(answered(behind.id(), true));
  ASSERT_TRUE(step_until([&] { return sources.newest() && sources.newest()->message.id() == "behind"; }));
  EXPECT_EQ(sources.newest()->message.kind(), "interaction");
  EXPECT_EQ(sources.newest()->message.targets(), std::vector<std::string>{site.robot});
}

TEST_F(PlannerServiceTest, ThePersonIsToldOfAPlaceUntilTheyTakeNoticeOfIt) {
  bus::EventReceiver gateway{others, topic::kInform, "gateway"};
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_PROPOSED));
  EXPECT_TRUE(answered(send(msg::HUMAN_MY_GOAL, 9.0, 7.0), true));  // they choose their way themselves
  auto hole = edit_at<msg::SourceEdit>(8.0, 2.0);
  hole.kind(msg::EDIT_AVOID);
  hole.source_id("hole");
  hole.strength("very");
  hole.who("operator");
  source_edits.send(hole);
  ASSERT_TRUE(answered(hole.id(), true));
  const auto walk = [&] { person_x_m = person_x_m > 6.0 ? 3.0 : person_x_m + 0.05; };  // towards it, and again
  std::vector<msg::Inform> told;
  ASSERT_TRUE(step_until([&] {
    walk();
    for (const auto& inform : gateway.take()) {
      if (inform.source_id() == "hole") told.push_back(inform);
    }
    return !told.empty();
  }));
  EXPECT_EQ(told[0].agent(), site.agent);
  EXPECT_TRUE(told[0].reason().starts_with("operator has drawn a place to keep out of, "));
  gateway.applied(told[0].id());
  for (int i = 0; i < 600; ++i) {  // 60 s, time enough to be told again
    walk();
    step_until([] { return true; });
    for (const auto& inform : gateway.take()) {
      EXPECT_NE(inform.source_id(), "hole");
      gateway.applied(inform.id());
    }
  }
}

TEST_F(PlannerServiceTest, ASessionWhoseLeaderIsGoneIsOver) {
  auto leader = std::make_unique<bus::Bus>(bus::host_domain(site, "leader"));
  auto led =
      std::make_unique<bus::Writer<msg::SessionState, msg::SessionStatePubSubType>>(leader->writer(topic::kSession));
  msg::SessionState state;
  state.robot(site.robot);
  state.code("S02");
  state.phase(msg::SESSION_RUNNING);
  led->write(state);
  ASSERT_TRUE(plan_is(msg::PLAN_ACCEPTED));
  led.reset();
  leader.reset();
  EXPECT_TRUE(plan_is(msg::PLAN_SUPERSEDED));
}

TEST_F(PlannerServiceTest, ADetectionEndsThePlanning) {
  ASSERT_TRUE(step_until([&] { return belief.newest().has_value(); }));
  tell_session(msg::SESSION_RUNNING);
  ASSERT_TRUE(plan_is(msg::PLAN_ACCEPTED));
  msg::ObjectDetection detection;
  detection.id(bus::new_event_id("camera", others.clock()));
  detection.robot(site.robot);
  detection.detected_by(site.robot);
  detections.send(detection);
  ASSERT_TRUE(plan_is(msg::PLAN_SUPERSEDED));
  ASSERT_TRUE(step_until([&] { return status.newest()->message.activity() == msg::PLANNER_FINISHED; }));
  EXPECT_TRUE(
      step_until([&] { return detections.outcome(detection.id()).state == bus::EventOutcome::State::Applied; }));
}

TEST(PlannerProcess, ASecondPlannerIsToldWhoIsActive) {
  const test::DomainLease domains{1};
  const SiteConfig site = site_in(domains[0]);
  bus::Bus first(bus::host_domain(site, "planner"));
  auto health = first.writer(topic::kServiceHealth);
  msg::ServiceHealth alive;
  alive.host("laptop2");
  alive.service("planner");
  alive.robot(site.robot);
  alive.process_id(77);
  alive.state(msg::HEALTH_OK);
  health.write(alive);

  bus::Bus second(bus::host_domain(site, "planner"));
  EXPECT_EQ(other_planner(site, second, seconds{10}), "planner already active on host laptop2 pid 77");
}

TEST(PlannerMessages, AMapThatIsNotWholeIsRefused) {
  EXPECT_TRUE(to_core(map_message()));
  auto cut = map_message();
  cut.cells().pop_back();
  EXPECT_FALSE(to_core(cut));
  auto flat = map_message();
  flat.resolution_m(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(to_core(flat));
}

TEST(PlannerMessages, AnEditKeepsItsPlaceAndWords) {
  msg::SourceEdit message;
  message.kind(msg::EDIT_AVOID);
  message.source_id("s1");
  message.strength("very");
  message.targets({"robot1"});
  message.who("operator");
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.0, 0.0}, {3.0, 0.0}, {0.0, 4.0}, {0.0, 0.0}}) {
    msg::Point2 corner;
    corner.x(x);
    corner.y(y);
    message.boundary_in_map().push_back(corner);
  }
  const auto edit = to_core(message);
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->kind, SourceEdit::Kind::Avoid);
  EXPECT_EQ(edit->source_id, "s1");
  EXPECT_EQ(edit->strength, "very");
  EXPECT_EQ(edit->who, "operator");
  EXPECT_EQ(edit->targets, std::vector<std::string>{"robot1"});
  EXPECT_EQ(std::get<Polygon>(edit->region).corners.size(), 3U);  // a hand draws corners twice
  message.boundary_in_map().resize(1);
  EXPECT_TRUE(std::holds_alternative<Disc>(to_core(message)->region));
  message.boundary_in_map()[0].x(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(to_core(message));
}

TEST(PlannerMessages, ABeliefEditNeedsAPlace) {
  msg::BeliefEdit message;
  message.kind(msg::BELIEF_SEARCHED);
  message.strength("roughly");
  message.who("person1");
  EXPECT_FALSE(to_core(message));
  message.boundary_in_map().resize(1);
  const auto edit = to_core(message);
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->kind, BeliefEdit::Kind::Searched);
  EXPECT_EQ(edit->strength, "roughly");
  EXPECT_EQ(edit->who, "person1");
}

TEST(PlannerMessages, APlanKeepsItsTimesAndPlaces) {
  MissionPlan plan;
  plan.id = "p1";
  plan.start = from_stamp_ns(1'000);
  plan.role = Role::PeerPeer;
  plan.lower_bound_s = 12.0;
  plan.reason = "first plan";
  plan.explanation = "First plan. The robot goes 2 m.";
  plan.members.push_back({"robot1", TimedPath{{{0.0, {1, 2}}, {2.0, {2, 2}}}}, {2, 2}, true});
  const auto message =
      to_message(plan, PlanStanding::Accepted, {"robot1", "S01", "laptop1/1", 5, from_stamp_ns(2'000)});

  EXPECT_EQ(message.state(), msg::PLAN_ACCEPTED);
  EXPECT_EQ(message.role(), msg::ROLE_PEER_PEER);
  EXPECT_EQ(message.lower_bound_s(), 12.0);
  EXPECT_EQ(message.reason(), "First plan. The robot goes 2 m.");
  ASSERT_EQ(message.paths().size(), 1U);
  EXPECT_EQ(message.paths()[0].points()[1].stamp_ns(), 2'000'001'000);
  EXPECT_EQ(message.paths()[0].points()[1].x_m(), 2.0);
  EXPECT_TRUE(message.paths()[0].goal_fixed());
}

}  // namespace
}  // namespace tandem
