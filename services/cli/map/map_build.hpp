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
  bool fresh = false;
  bool json = false;
};

/// `tandem map build`. After Ctrl-C what is done is kept beside the output for the next time, and Interrupted thrown.
void run_map_build(const MapBuildOptions& options);

}  // namespace tandem::cli
