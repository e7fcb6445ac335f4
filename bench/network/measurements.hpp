#pragma once

#include "bench/network/record.hpp"

/// What is measured, each in a laboratory of its own; isolate_network() must have succeeded. Times in ms unless named
/// otherwise; kNever where nothing came. Each `run` has an air of its own: which frames it loses is drawn by its
/// number.
namespace tandem::bench {

/// A map of `bytes` to a reader that joins late: "ms" from match to data, "sent_kB" by its writer's host. With
/// `odometry`, a stream of 50 Hz to the same host meanwhile: "odometry_p99_ms", "odometry_delivered".
[[nodiscard]] Figures map_to_late_joiner(const std::string& whose, const std::string& air, int run, std::size_t bytes,
                                         bool odometry);

/// 60 messages from the laptop to the robot, each answered: "p50_ms", "p99_ms", "max_ms" of the round trip, "lost",
/// "applied_twice".
[[nodiscard]] Figures messages(const std::string& whose, const std::string& air, int run);

/// A plan of 5 kB each second to the robot, its pose at 10 Hz to the laptop, 20 s: "plan_p50_ms", "plan_max_ms" until
/// it or a newer one is there, "pose_delivered", "pose_gap_ms" longest, "pose_stale" older than 1 s or out of order.
[[nodiscard]] Figures plan_and_pose(const std::string& whose, const std::string& air, int run);

/// "ms" from the start of the laptop's side to the first pose of a robot that is already there.
[[nodiscard]] Figures first_data(const std::string& whose, const std::string& air, int run);

/// "ms" from the end of 30 s without a frame to the first pose that was sent afterwards.
[[nodiscard]] Figures after_outage(const std::string& whose, const std::string& air, int run);

/// "to_laptop_ms" from the change of the robot's address to the first pose that reaches the laptop of those that were
/// sent afterwards, "to_robot_ms" to the first plan that reaches the robot.
[[nodiscard]] Figures after_address_change(const std::string& whose, const std::string& air, int run);

/// A driving robot's streams for 15 s, read `readers` times on the laptop: "robot_kBps" and "laptop_kBps" sent on the
/// air, "robot_cpu" and "laptop_cpu" of the relays (share of a core). Without `driving`, States and health alone.
[[nodiscard]] Figures cost(const std::string& whose, const std::string& air, int run, int readers, bool driving);

// Whole teams on simulated hardware: all services of robot and laptop, without a person. No figures if a process ended.

/// What one team costs: "driving_robot_kBps" and "driving_laptop_kBps" sent on the air, "driving_cpu" of all services
/// of the robot (share of a core; hardware and world not counted) and "driving_cpu_base", ... of each, and the same for
/// a robot that stands: "idle_...".
[[nodiscard]] Figures team_cost(const std::string& air);

/// Four robots of four teams search for two minutes, from when all do: "false_stops" of their bases,
/// "without_plan" in which a navigator did not hear of its plan, in "driven_h" with turning wheels of "watched_h" [h];
/// "busy": share of this machine's cores that was in use meanwhile.
[[nodiscard]] Figures false_stops(const std::string& air, int run);

/// A driving robot after five minutes without a frame: "ms" to the first pose on the laptop, "drives_again_s" until its
/// wheels turn, after it was resumed, "processes_ended", and from 20 s after the beginning of the outage to its end
/// "growth_MB" of all services of the robot, of "memory_MB", "most_growth_MB" of one.
[[nodiscard]] Figures long_outage(const std::string& air);

}  // namespace tandem::bench
