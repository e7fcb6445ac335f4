#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tandem::bench {

/// Where the programs are that are measured: tandem and tandem-recorder.
struct Programs {
  std::filesystem::path folder;
};

struct LoadResult {
  std::uint64_t sent = 0;
  std::uint64_t recorded = 0;
  double cpu_share = 0.0;  ///< of a core
  double megabytes_per_s = 0.0;
};
/// Sends 5000 messages of 2 kB a second for `seconds` and counts what tandem-recorder has of them.
[[nodiscard]] LoadResult record_under_load(const Programs& programs, double seconds);

struct KillResult {
  int killed = 0;
  int unreadable = 0;  ///< files that did not open by themselves, or with damage
  int gaps = 0;        ///< files that miss a message that the recorder had written before their last
};
/// Kills a recorder under load at `times` random moments.
[[nodiscard]] KillResult kill_recorders(const Programs& programs, int times);

struct ReplayResult {
  double lateness_p99_ms = 0.0;
  double lateness_max_ms = 0.0;
  std::uint64_t messages = 0;
  std::uint64_t lost = 0;      ///< of the recording, in what was recorded of its replay
  bool is_same_again = false;  ///< that has the same payloads
};
/// Replays a recording of `seconds` at rate 1 beside a recorder.
[[nodiscard]] ReplayResult replay_and_record(const Programs& programs, double seconds);

}  // namespace tandem::bench
