#pragma once

#include <cstdint>
#include <string>

#include "services/common/config.hpp"
#include "services/mapping/core/map_file.hpp"

namespace tandem {

/// config/<place>/map-server.toml.
struct MapServerConfig {
  std::string map = "map.yaml";               ///< A map_server YAML file, absolute or relative to this file's folder.
  std::int64_t max_cells = kDefaultMaxCells;  ///< Larger maps are refused.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("map", map);
    visitor.field("max_cells", max_cells, Range{1.0, 1e9});
  }
};

}  // namespace tandem
