#pragma once

#include <string>

namespace tandem::cli {

struct MapCheckOptions {
  std::string file;
  bool json = false;
};

/// `tandem map check`: prints what was found; throws Failed when the map has faults.
void run_map_check(const MapCheckOptions& options);

}  // namespace tandem::cli
