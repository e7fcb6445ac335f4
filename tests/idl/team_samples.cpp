#include "tests/idl/samples.hpp"

namespace tandem::test {

template <>
msg::TeamPlan filled() {
  msg::TeamPlan message;
  message.robot("robot-1");
  message.id("id-2");
  message.session("session-3");
  message.planner("planner-4");
  message.sequence_number(5);
  message.world_version(6);
  message.stamp_ns(1700000000000000007);
  message.valid_until_ns(1700000000000000008);
  message.state(msg::PLAN_ACCEPTED);
  message.role(msg::ROLE_PEER_PEER);
  message.paths().resize(1);
  message.paths()[0].agent("agent-9");
  message.paths()[0].points().resize(1);
  message.paths()[0].points()[0].stamp_ns(1700000000000000010);
  message.paths()[0].points()[0].x_m(11.5);
  message.paths()[0].points()[0].y_m(12.5);
  message.paths()[0].goal_in_map().x(13.5);
  message.paths()[0].goal_in_map().y(14.5);
  message.paths()[0].goal_fixed(true);
  message.value(15.5);
  message.probability_found(16.5);
  message.lower_bound_s(17.5);
  message.reason("reason-18");
  return message;
}

template <>
msg::PlannerStatus filled() {
  msg::PlannerStatus message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.activity(msg::PLANNER_COMPUTING);
  message.progress(3.5);
  message.computing_s(4.5);
  message.reason("reason-5");
  return message;
}

template <>
msg::PlanExecution filled() {
  msg::PlanExecution message;
  message.robot("robot-1");
  message.plan_id("plan-id-2");
  message.stamp_ns(1700000000000000003);
  message.progress(4.5);
  message.moving(true);
  message.finished(true);
  message.blocked(true);
  message.blocked_at_in_map().x(5.5);
  message.blocked_at_in_map().y(6.5);
  message.reason("reason-7");
  return message;
}

template <>
msg::Inform filled() {
  msg::Inform message;
  message.agent("agent-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.source_id("source-id-4");
  message.reason("reason-5");
  return message;
}

template <>
msg::SearchBelief filled() {
  msg::SearchBelief message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.resolution_m(3.5);
  message.width(4);
  message.height(5);
  message.origin_in_map().x(6.5);
  message.origin_in_map().y(7.5);
  message.peak(8.5);
  message.cells({9, 10});
  message.explored(11.5);
  message.explored_by().resize(1);
  message.explored_by()[0].agent("agent-12");
  message.explored_by()[0].share(13.5);
  message.probability_left(14.5);
  return message;
}

template <>
msg::RewardSource filled() {
  msg::RewardSource message;
  message.id("id-1");
  message.kind("kind-2");
  message.meaning("meaning-3");
  message.boundary_in_map().resize(1);
  message.boundary_in_map()[0].x(4.5);
  message.boundary_in_map()[0].y(5.5);
  message.radius_m(6.5);
  message.rate_per_s(7.5);
  message.pool(8.5);
  message.targets({"targets-9", "targets-10"});
  return message;
}

template <>
msg::SourceRelation filled() {
  msg::SourceRelation message;
  message.from_id("from-id-1");
  message.to_id("to-id-2");
  message.kind("kind-3");
  message.coupling(4.5);
  return message;
}

template <>
msg::SourceEdit filled() {
  msg::SourceEdit message;
  message.robot("robot-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.who("who-4");
  message.kind(msg::EDIT_AVOID);
  message.source_id("source-id-5");
  message.boundary_in_map().resize(1);
  message.boundary_in_map()[0].x(6.5);
  message.boundary_in_map()[0].y(7.5);
  message.strength("strength-8");
  message.targets({"targets-9", "targets-10"});
  return message;
}

template <>
msg::BeliefEdit filled() {
  msg::BeliefEdit message;
  message.robot("robot-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.who("who-4");
  message.kind(msg::BELIEF_NOT_HERE);
  message.boundary_in_map().resize(1);
  message.boundary_in_map()[0].x(5.5);
  message.boundary_in_map()[0].y(6.5);
  message.strength("strength-7");
  return message;
}

template <>
msg::HumanMessage filled() {
  msg::HumanMessage message;
  message.agent("agent-1");
  message.robot("robot-2");
  message.id("id-3");
  message.sequence_number(4);
  message.stamp_ns(1700000000000000005);
  message.kind(msg::HUMAN_MY_GOAL);
  message.point_in_map().x(6.5);
  message.point_in_map().y(7.5);
  message.heading_known(true);
  message.heading(8.5);
  return message;
}

template <>
msg::MessageReceipt filled() {
  msg::MessageReceipt message;
  message.id("id-1");
  message.topic("topic-2");
  message.by("by-3");
  message.stamp_ns(1700000000000000004);
  message.applied(true);
  message.reason("reason-5");
  return message;
}

template <>
msg::SessionState filled() {
  msg::SessionState message;
  message.robot("robot-1");
  message.code("code-2");
  message.agent("agent-3");
  message.stamp_ns(1700000000000000004);
  message.phase(msg::SESSION_RUNNING);
  message.condition("condition-5");
  message.reminder("reminder-6");
  message.mode("mode-7");
  message.started_ns(1700000000000000008);
  message.ended_ns(1700000000000000009);
  message.outcome("outcome-10");
  return message;
}

template <>
msg::ReminderEvent filled() {
  msg::ReminderEvent message;
  message.agent("agent-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.kind("kind-4");
  message.fired(true);
  message.obeyed(true);
  message.threshold_s(5.5);
  return message;
}

template <>
msg::QuestionnaireAnswer filled() {
  msg::QuestionnaireAnswer message;
  message.agent("agent-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.question("question-4");
  message.answer("answer-5");
  return message;
}

}  // namespace tandem::test
