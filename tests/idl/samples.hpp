#pragma once

#include "idl/topics.hpp"

namespace tandem::test {

/// A message whose every field differs from its default, and, but for flags, from its neighbours.
template <class Message>
[[nodiscard]] Message filled();

template <>
[[nodiscard]] msg::Odometry filled();
template <>
[[nodiscard]] msg::BaseStatus filled();
template <>
[[nodiscard]] msg::SonarRanges filled();
template <>
[[nodiscard]] msg::VelocityCommand filled();
template <>
[[nodiscard]] msg::StopRequest filled();
template <>
[[nodiscard]] msg::ResumeRequest filled();
template <>
[[nodiscard]] msg::LaserScan filled();
template <>
[[nodiscard]] msg::CameraImage filled();
template <>
[[nodiscard]] msg::ObjectDetection filled();
template <>
[[nodiscard]] msg::TeammateState filled();
template <>
[[nodiscard]] msg::TrackedPeople filled();
template <>
[[nodiscard]] msg::OccupancyGrid filled();
template <>
[[nodiscard]] msg::MapHolding filled();
template <>
[[nodiscard]] msg::CompressedMap filled();
template <>
[[nodiscard]] msg::RobotPose filled();
template <>
[[nodiscard]] msg::PoseHint filled();
template <>
[[nodiscard]] msg::TeamPlan filled();
template <>
[[nodiscard]] msg::PlannerStatus filled();
template <>
[[nodiscard]] msg::PlanExecution filled();
template <>
[[nodiscard]] msg::Inform filled();
template <>
[[nodiscard]] msg::SearchBelief filled();
template <>
[[nodiscard]] msg::RewardSource filled();
template <>
[[nodiscard]] msg::SourceRelation filled();
template <>
[[nodiscard]] msg::SourceEdit filled();
template <>
[[nodiscard]] msg::BeliefEdit filled();
template <>
[[nodiscard]] msg::HumanMessage filled();
template <>
[[nodiscard]] msg::MessageReceipt filled();
template <>
[[nodiscard]] msg::SessionState filled();
template <>
[[nodiscard]] msg::ReminderEvent filled();
template <>
[[nodiscard]] msg::QuestionnaireAnswer filled();
template <>
[[nodiscard]] msg::LinkStatus filled();
template <>
[[nodiscard]] msg::LinkHeartbeat filled();
template <>
[[nodiscard]] msg::ServiceHealth filled();
template <>
[[nodiscard]] msg::Clock filled();
template <>
[[nodiscard]] msg::GroundTruth filled();

}  // namespace tandem::test
