#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tandem::cli {

struct MapBuildOptions {
  std::string file;
  std::string output;
  std::string config;
  std::string truth;
  double truth_offset_s = 0.0;
  std::optional<std::int64_t> seed;
  std::string trajectory;
  std::string picture;
  bool json = false;
};

/// `tandem map build`. After Ctrl-C the map of the scans taken in so far is written, and Interrupted thrown.
void run_map_build(const MapBuildOptions& options);

}  // namespace tandem::cli
