#pragma once

#include <cstdint>
#include <string>

#include "tests/network/lab/air.hpp"

namespace tandem::bench {

/// What the air of this name does to what each host receives: "clean", "loss5", ... "loss30" [%], "bursts" (300 ms of
/// every second), "loss30+bursts", "2M" (2 Mbit/s, bursts of 16 KiB at once), "2M+loss10", "no_multicast". Throws
/// std::invalid_argument for another name.
[[nodiscard]] test::Conditions conditions_of(const std::string& air);

/// The seed of the air of a run. A host of a laboratory draws with the seed and its number added, so runs are far
/// apart.
[[nodiscard]] std::uint64_t seed_of(int run);

/// As a reader of a report reads it: "20 %".
[[nodiscard]] std::string title_of(const std::string& air);

}  // namespace tandem::bench
