#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tandem::safety {

/// Why the robot stands, as it is published: the enumerators of msg::StopReason in their order.
enum class StopReason : std::uint8_t {
  None,
  NotEnabled,
  Requested,
  EmergencyStop,
  Bumper,
  Stall,
  Obstacle,
  StaleScan,
  BadScan,
  StaleCommand,
  BadCommand,
  StalePose,
  LostPose,
  LinkLost,
  BaseLost,
  OdometryJump,
  LowBattery,
  TwoCommanders,
};

/// How motion comes back once a cause is gone.
enum class Resume : std::uint8_t {
  AtOnce,   ///< A limit rather than a stop: another way may be free now.
  Auto,     ///< After some healthy seconds and a warning.
  Latched,  ///< After a deliberate act and a warning.
};

/// Everything that stops the robot, most urgent first; each is a row of kStopRules.
enum class Cause : std::uint8_t {
  EmergencyStop,
  Bumper,
  Stall,
  StopRequested,
  PauseRequested,
  BaseLost,
  BaseNotThere,
  ServiceFailed,
  OdometryJump,
  Overspeed,
  EncoderDead,
  LowBattery,
  StuckScan,
  StaleScan,
  BadScan,
  PersonClose,
  LinkLongLost,
  LinkLost,
  LostPose,
  StalePose,
  TwoCommanders,
  TwoBases,
  BadCommand,
  StaleCommand,
  OtherMap,
  ObstacleAhead,
  KeepOutAhead,
};
inline constexpr std::size_t kCauses = 27;
using Causes = std::bitset<kCauses>;
[[nodiscard]] constexpr std::size_t index_of(Cause cause) {
  return static_cast<std::size_t>(cause);
}

/// One row of the decision table. Every one commands the wheels to 0 in the cycle that sees its cause.
struct StopRule {
  Cause cause;
  StopReason reason;
  Resume resume;
  std::string_view fault_id;  ///< of docs/safety.md
  std::string_view message;   ///< for people
};

/// The decision table; docs/safety.md shows it.
inline constexpr std::array<StopRule, kCauses> kStopRules{{
    {Cause::EmergencyStop, StopReason::EmergencyStop, Resume::Latched, "B6", "the emergency stop is pressed"},
    {Cause::Bumper, StopReason::Bumper, Resume::Latched, "B5", "a bumper touches something"},
    {Cause::Stall, StopReason::Stall, Resume::Latched, "B5", "a wheel is blocked"},
    {Cause::StopRequested, StopReason::Requested, Resume::Latched, "SAF-8", "somebody pressed STOP"},
    {Cause::PauseRequested, StopReason::Requested, Resume::Auto, "SAF-8", "somebody asked for a pause"},
    {Cause::BaseLost, StopReason::BaseLost, Resume::Latched, "B2", "the base stopped answering"},
    {Cause::BaseNotThere, StopReason::BaseLost, Resume::Auto, "B3", "the base has not answered yet"},
    {Cause::ServiceFailed, StopReason::BaseLost, Resume::Latched, "P1 P2", "the base service was dead or frozen"},
    {Cause::OdometryJump, StopReason::OdometryJump, Resume::Latched, "B8", "the odometry jumped"},
    {Cause::Overspeed, StopReason::OdometryJump, Resume::Latched, "B8", "the robot is faster than it was told"},
    {Cause::EncoderDead, StopReason::OdometryJump, Resume::Latched, "B8", "the wheels do not turn as they were told"},
    {Cause::LowBattery, StopReason::LowBattery, Resume::Latched, "B7", "the battery is empty"},
    {Cause::StuckScan, StopReason::BadScan, Resume::Latched, "S2", "the laser repeats one scan while the robot moves"},
    {Cause::StaleScan, StopReason::StaleScan, Resume::Auto, "P3 S1 S4 S6", "no scan from the laser"},
    {Cause::BadScan, StopReason::BadScan, Resume::Auto, "S3", "the laser sees nothing usable"},
    {Cause::PersonClose, StopReason::Obstacle, Resume::Auto, "H2", "a person is very close"},
    {Cause::LinkLongLost, StopReason::LinkLost, Resume::Latched, "N2 N3", "the link was gone for long"},
    {Cause::LinkLost, StopReason::LinkLost, Resume::Auto, "N2 N4 P15", "no link to the operator"},
    {Cause::LostPose, StopReason::LostPose, Resume::Auto, "L1", "the robot does not know where it is"},
    {Cause::StalePose, StopReason::StalePose, Resume::Auto, "P5", "no pose from localization"},
    {Cause::TwoCommanders, StopReason::TwoCommanders, Resume::Auto, "X5", "two programs command the robot at once"},
    {Cause::TwoBases, StopReason::TwoCommanders, Resume::Auto, "X6", "another base says that it is this robot"},
    {Cause::BadCommand, StopReason::BadCommand, Resume::Auto, "B9", "the velocity commands are nonsense"},
    {Cause::StaleCommand, StopReason::StaleCommand, Resume::Auto, "P4", "the velocity commands ceased while driving"},
    {Cause::OtherMap, StopReason::LostPose, Resume::Auto, "SAF-10", "the robot is not on the map whose zones it minds"},
    {Cause::ObstacleAhead, StopReason::Obstacle, Resume::AtOnce, "S5 SAF-2 SAF-4", "something is in the way"},
    {Cause::KeepOutAhead, StopReason::Obstacle, Resume::AtOnce, "SAF-10", "a keep-out zone of the map is in the way"},
}};

[[nodiscard]] constexpr const StopRule& rule_of(Cause cause) {
  return kStopRules[index_of(cause)];
}

/// The rows whose cause ends motion until it is resumed in that way.
[[nodiscard]] Causes causes_with(Resume resume);

}  // namespace tandem::safety
