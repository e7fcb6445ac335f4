#pragma once

#include <basePubSubTypes.h>
#include <humanPubSubTypes.h>
#include <localizationPubSubTypes.h>
#include <perceptionPubSubTypes.h>
#include <planningPubSubTypes.h>
#include <systemPubSubTypes.h>

#include <memory>
#include <string_view>
#include <vector>

namespace tandem {

/// What a reader may count on; services/bus/qos.cpp is the only place that turns it into QoS.
enum class Delivery {
  SensorStream,  ///< best effort, newest only
  State,         ///< reliable, newest per key, also for late joiners
  Bulk,          ///< a State of many datagrams: it takes its time on the link, and others do not wait for it
  Command,       ///< best effort, short-lived: the reader stops when it dries up
  Event,         ///< reliable, has an id, repeated until its receipt, applied exactly once
};

/// Whether and how a topic crosses the link between the hosts.
struct Relay {
  enum class Direction { None, ToLaptop, ToRobot, Both };
  Direction direction = Direction::None;
  double max_rate_hz = 0.0;  ///< 0: every sample
  double max_age_s = 0.0;    ///< older samples are dropped, by the link's own clock offset; 0: any age
};

namespace relay {
inline constexpr Relay never() {
  return {};
}
inline constexpr Relay to_laptop(double max_rate_hz = 0.0, double max_age_s = 0.0) {
  return {Relay::Direction::ToLaptop, max_rate_hz, max_age_s};
}
inline constexpr Relay to_robot(double max_age_s = 0.0) {
  return {Relay::Direction::ToRobot, 0.0, max_age_s};
}
inline constexpr Relay both(double max_rate_hz = 0.0) {
  return {Relay::Direction::Both, max_rate_hz, 0.0};
}
}  // namespace relay

/// A topic of the contract. `appliers` are the services whose receipt the sender of an Event waits for.
template <class PubSubType>
struct Topic {
  using Message = typename PubSubType::type;
  using Type = PubSubType;
  std::string_view name;
  Delivery delivery;
  Relay relay;
  std::string_view appliers = "";
};

namespace topic {

using namespace tandem::msg;  // NOLINT: the table below names every type of the module

// The robot's base ---------------------------------------------------------------------------------------------------
/// base -> localization, navigator, tracker; 10-20 Hz.
inline constexpr Topic<OdometryPubSubType> kOdometry{"odometry", Delivery::SensorStream, relay::to_laptop(5.0)};
/// base -> all; 2 Hz and on change.
inline constexpr Topic<BaseStatusPubSubType> kBaseStatus{"base_status", Delivery::State, relay::to_laptop()};
/// base -> recorder; 10 Hz.
inline constexpr Topic<SonarRangesPubSubType> kSonar{"sonar", Delivery::SensorStream, relay::never()};
/// navigator, or teleop on the robot -> base; 20 Hz. On no relay's list: a velocity never crosses the link.
inline constexpr Topic<VelocityCommandPubSubType> kVelocityCommand{"velocity_command", Delivery::Command,
                                                                   relay::never()};
/// gateway, cli -> base.
inline constexpr Topic<StopRequestPubSubType> kStopRequest{"stop_request", Delivery::Event, relay::to_robot(), "base"};
/// gateway, cli -> base.
inline constexpr Topic<ResumeRequestPubSubType> kResumeRequest{"resume_request", Delivery::Event, relay::to_robot(1.0),
                                                               "base"};

// What the robot sees ------------------------------------------------------------------------------------------------
/// laser -> localization, tracker, base, navigator; 10-40 Hz. Thinned to one datagram on the link.
inline constexpr Topic<LaserScanPubSubType> kScan{"scan", Delivery::SensorStream, relay::to_laptop(2.0, 1.0)};
/// camera -> recorder, gateway; at most 1 Hz.
inline constexpr Topic<CameraImagePubSubType> kCameraImage{"camera_image", Delivery::SensorStream,
                                                           relay::to_laptop(0.2)};
/// camera; gateway (Found it) -> planner, gateway.
inline constexpr Topic<ObjectDetectionPubSubType> kDetection{"detection", Delivery::Event, relay::to_laptop(),
                                                             "planner"};
/// tracker -> planner, navigator, gateway, base; 5 Hz.
inline constexpr Topic<TeammateStatePubSubType> kTeammates{"teammates", Delivery::State, relay::to_laptop()};
/// tracker -> base, navigator, planner, gateway; 5-10 Hz.
inline constexpr Topic<TrackedPeoplePubSubType> kPeople{"people", Delivery::SensorStream, relay::to_laptop(2.0)};

// Where the robot is -------------------------------------------------------------------------------------------------
/// map server -> its host's services; once. The relay brings it to a host that has none, compressed.
inline constexpr Topic<OccupancyGridPubSubType> kMap{"map", Delivery::State, relay::never()};
/// relay <-> relay, on change, on the link domain alone.
inline constexpr Topic<MapHoldingPubSubType> kMapHolding{"map_holding", Delivery::State, relay::never()};
/// relay -> relay, while one is asked for, on the link domain alone.
inline constexpr Topic<CompressedMapPubSubType> kCompressedMap{"compressed_map", Delivery::Bulk, relay::never()};
/// localization -> base, navigator, tracker, planner, gateway; 10-20 Hz.
inline constexpr Topic<RobotPosePubSubType> kRobotPose{"robot_pose", Delivery::SensorStream,
                                                       relay::to_laptop(10.0, 1.0)};
/// gateway -> localization.
inline constexpr Topic<PoseHintPubSubType> kPoseHint{"pose_hint", Delivery::Event, relay::to_robot(), "localization"};

// The plan -----------------------------------------------------------------------------------------------------------
/// planner -> navigator, gateway, tracker; on plan, and every second while it holds.
inline constexpr Topic<TeamPlanPubSubType> kTeamPlan{"team_plan", Delivery::State, relay::to_robot()};
/// planner -> gateway; on change.
inline constexpr Topic<PlannerStatusPubSubType> kPlannerStatus{"planner_status", Delivery::State, relay::never()};
/// navigator -> planner, gateway; 2 Hz.
inline constexpr Topic<PlanExecutionPubSubType> kPlanExecution{"plan_execution", Delivery::State, relay::to_laptop()};
/// planner -> gateway. Its receipt says that the person has taken notice: *Got it* on the phone.
inline constexpr Topic<InformPubSubType> kInform{"inform", Delivery::Event, relay::never(), "gateway"};
/// planner -> gateway, recorder; 1 Hz.
inline constexpr Topic<SearchBeliefPubSubType> kBelief{"belief", Delivery::State, relay::never()};
/// planner -> gateway, recorder; on change.
inline constexpr Topic<RewardSourcePubSubType> kRewardSource{"reward_source", Delivery::State, relay::never()};
/// planner -> gateway, recorder; on change.
inline constexpr Topic<SourceRelationPubSubType> kSourceRelation{"source_relation", Delivery::State, relay::never()};
/// gateway -> planner.
inline constexpr Topic<SourceEditPubSubType> kSourceEdit{"source_edit", Delivery::Event, relay::never(), "planner"};
/// gateway -> planner.
inline constexpr Topic<BeliefEditPubSubType> kBeliefEdit{"belief_edit", Delivery::Event, relay::never(), "planner"};

// The person and the study -------------------------------------------------------------------------------------------
/// gateway -> planner, tracker, recorder.
inline constexpr Topic<HumanMessagePubSubType> kHumanMessage{"human_message", Delivery::Event, relay::to_robot(),
                                                             "planner,tracker"};
/// Whoever applies an Event -> its sender.
inline constexpr Topic<MessageReceiptPubSubType> kMessageReceipt{"message_receipt", Delivery::Event, relay::both()};
/// gateway, cli -> all; on change.
inline constexpr Topic<SessionStatePubSubType> kSession{"session", Delivery::State, relay::to_robot()};
/// gateway -> recorder.
inline constexpr Topic<ReminderEventPubSubType> kReminder{"reminder", Delivery::Event, relay::never()};
/// gateway -> recorder.
inline constexpr Topic<QuestionnaireAnswerPubSubType> kQuestionnaireAnswer{"questionnaire_answer", Delivery::Event,
                                                                           relay::never()};

// The system itself --------------------------------------------------------------------------------------------------
/// relay -> its host; 2 Hz and on change.
inline constexpr Topic<LinkStatusPubSubType> kLinkStatus{"link_status", Delivery::State, relay::never()};
/// relay <-> relay, 10 Hz, on the link domain alone.
inline constexpr Topic<LinkHeartbeatPubSubType> kLinkHeartbeat{"link_heartbeat", Delivery::SensorStream,
                                                               relay::never()};
/// all -> doctor, gateway; 1 Hz.
inline constexpr Topic<ServiceHealthPubSubType> kServiceHealth{"service_health", Delivery::State, relay::both(1.0)};
/// simulator, replayer -> all.
inline constexpr Topic<ClockPubSubType> kClock{"clock", Delivery::SensorStream, relay::both()};
/// simulator -> its host's recorder, tests, bench only; 20 Hz. No service reads it, and no real robot sends it.
inline constexpr Topic<GroundTruthPubSubType> kGroundTruth{"ground_truth", Delivery::SensorStream, relay::never()};

}  // namespace topic

/// A topic without its type, for those who handle every topic alike: relay, recorder, replayer, `tandem topics`.
struct TopicInfo {
  std::string_view name;
  Delivery delivery;
  Relay relay;
  std::string_view appliers;
  /// A new type support of the topic's message.
  std::unique_ptr<eprosima::fastdds::dds::TopicDataType> (*make_type)();
  /// Whether a message of the topic's type holds a NaN where none may be.
  bool (*holds_nan)(const void* message);
};

/// A NaN is the one value that does not equal itself, and so is a message with one inside.
template <class Message>
[[nodiscard]] bool holds_nan(const Message& message) {
  return !(message == message);
}
/// NaN is a beam that saw nothing.
[[nodiscard]] inline bool holds_nan(const msg::LaserScan& scan) {
  msg::LaserScan beamless = scan;
  beamless.ranges_m().clear();
  return !(beamless == beamless);
}
/// The safety gate judges commands, and counts those that are nonsense.
[[nodiscard]] inline bool holds_nan(const msg::VelocityCommand&) {
  return false;
}

template <class PubSubType>
[[nodiscard]] TopicInfo info_of(const Topic<PubSubType>& topic) {
  return {topic.name,
          topic.delivery,
          topic.relay,
          topic.appliers,
          +[]() -> std::unique_ptr<eprosima::fastdds::dds::TopicDataType> { return std::make_unique<PubSubType>(); },
          +[](const void* message) { return holds_nan(*static_cast<const typename PubSubType::type*>(message)); }};
}

/// Every topic of the contract, in the order above.
[[nodiscard]] const std::vector<TopicInfo>& all_topics();

}  // namespace tandem
