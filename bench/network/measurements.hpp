#pragma once

#include "bench/network/record.hpp"

/// What is measured, each in a laboratory of its own; isolate_network() must have succeeded. Times in ms unless named
/// otherwise; kNever where nothing came.
namespace tandem::bench {

/// A map of `bytes` to a reader that joins late: "ms" from match to data, "sent_kB" by its writer's host. With
/// `odometry`, a stream of 50 Hz to the same host meanwhile: "odometry_p99_ms", "odometry_delivered".
[[nodiscard]] Figures map_to_late_joiner(const std::string& whose, const std::string& air, std::size_t bytes,
                                         bool odometry);

/// 60 messages from the laptop to the robot, each answered: "p50_ms", "p99_ms", "max_ms" of the round trip, "lost",
/// "applied_twice".
[[nodiscard]] Figures messages(const std::string& whose, const std::string& air);

/// A plan of 5 kB each second to the robot, its pose at 10 Hz to the laptop, 20 s: "plan_p50_ms", "plan_max_ms" until
/// it or a newer one is there, "pose_delivered", "pose_gap_ms" longest, "pose_stale" older than 1 s or out of order.
[[nodiscard]] Figures plan_and_pose(const std::string& whose, const std::string& air);

/// "ms" from the start of the laptop's side to the first pose of a robot that is already there.
[[nodiscard]] Figures first_data(const std::string& whose, const std::string& air);

/// "ms" from the end of 30 s without a frame to the first pose that was sent afterwards.
[[nodiscard]] Figures after_outage(const std::string& whose, const std::string& air);

/// "ms" from the change of the robot's address to the first pose that was sent afterwards.
[[nodiscard]] Figures after_address_change(const std::string& whose, const std::string& air);

/// A driving robot's streams for 15 s, read `readers` times on the laptop: "robot_kBps" and "laptop_kBps" sent on the
/// air, "robot_cpu" and "laptop_cpu" of the relays (share of a core). Without `driving`, States and health alone.
[[nodiscard]] Figures cost(const std::string& whose, const std::string& air, int readers, bool driving);

}  // namespace tandem::bench
