#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/network/record.hpp"

namespace tandem::bench {

/// A measurement that is to be made.
struct NetworkRequest {
  NetworkKey key;
  bool alone = false;  ///< with the machine for itself: a whole team's processes need its cores
};

/// All measurements of the campaign, `runs` of each but of the longest; `quick`: fewer airs.
[[nodiscard]] std::vector<NetworkRequest> network_campaign(int runs, bool quick);

/// Measures in this process, which must have no threads yet and must end afterwards. Throws std::runtime_error where no
/// laboratory can run, std::invalid_argument for a key that is none.
[[nodiscard]] Figures measured_here(const NetworkKey& key);

/// Measures in a process of its own: `program cell ...`, whose log goes to `log`. No figures if that fails.
[[nodiscard]] NetworkRecord measured_apart(const NetworkRequest& request, const std::filesystem::path& program,
                                           const std::filesystem::path& log);

/// `figures` as `program cell` prints them.
[[nodiscard]] std::string text_of(const Figures& figures);

}  // namespace tandem::bench
