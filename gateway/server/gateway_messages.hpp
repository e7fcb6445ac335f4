#pragma once

#include <optional>
#include <string>

#include "gateway/protocol/belief_frame.hpp"
#include "gateway/protocol/messages.hpp"
#include "idl/topics.hpp"
#include "services/common/time.hpp"

namespace tandem::gateway {

// Bus -> phone
[[nodiscard]] protocol::RobotState to_phone(const msg::RobotPose& pose, Duration age);
[[nodiscard]] protocol::PersonState to_phone(const msg::TeammateState& person, Duration age);
[[nodiscard]] protocol::PlannerState to_phone(const msg::PlannerStatus& status);
[[nodiscard]] protocol::LinkState to_phone(const msg::LinkStatus& status);
[[nodiscard]] protocol::Plan to_phone(const msg::TeamPlan& plan);
[[nodiscard]] protocol::Map to_phone(const msg::OccupancyGrid& grid);
[[nodiscard]] protocol::BeliefGrid to_phone(const msg::SearchBelief& belief, std::uint32_t revision);
/// What is drawn; none for a source that no phone has drawn.
[[nodiscard]] std::optional<protocol::Source> to_phone(const msg::RewardSource& source);
/// Null: there is no session.
[[nodiscard]] protocol::Session to_phone(const msg::SessionState* session);
/// What the base and the navigator say about the robot's motion, one of them or none may be unknown.
[[nodiscard]] protocol::BaseState to_phone(const msg::BaseStatus* base, const msg::PlanExecution* execution);

// Phone -> bus
struct Sender {
  std::string agent;  ///< whose phone
  std::string robot;
  std::string id;  ///< of the event
  Time pressed{};  ///< mission time of the press
};
/// For the kinds that are messages to the team: poses, goals, replan. `sequence_number` counts them per agent.
[[nodiscard]] msg::HumanMessage to_human_message(const protocol::Command& command, const Sender& sender,
                                                 std::uint64_t sequence_number);
[[nodiscard]] msg::SourceEdit to_source_edit(const protocol::Command& command, const Sender& sender);
[[nodiscard]] msg::BeliefEdit to_belief_edit(const protocol::Command& command, const Sender& sender);
[[nodiscard]] msg::ReminderEvent to_reminder(const protocol::Command& command, const Sender& sender);
/// That a layer of the map is shown or hidden, as an answer to the question of which are.
[[nodiscard]] msg::QuestionnaireAnswer to_layer_record(const protocol::Command& command, const Sender& sender);
[[nodiscard]] msg::PoseHint to_pose_hint(const protocol::Command& command, const Sender& sender);
[[nodiscard]] msg::ObjectDetection to_detection(const protocol::Command& command, const Sender& sender);
[[nodiscard]] msg::StopRequest to_stop_request(const Sender& sender);
[[nodiscard]] msg::ResumeRequest to_resume_request(const protocol::Command& command, const Sender& sender);

}  // namespace tandem::gateway
