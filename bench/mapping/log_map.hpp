#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/localization/recorded_log.hpp"
#include "services/localization/core/trajectory_errors.hpp"
#include "services/map_builder/core/map_builder.hpp"

namespace tandem::bench {

/// A real robot's log, and what is known of where it was.
struct MappingLog {
  std::string name;
  std::vector<LogEvent> events;  ///< in the log's order
  std::vector<Relation> relations;
  double relation_offset_s = 0.0;  ///< relation time minus log time
  std::vector<TimedPose> truth;    ///< another program's poses, by time
  double way_m = 0.0;              ///< driven, by the truth
  bool has_clock = true;           ///< false: its times are scan numbers
};

/// "intel", "fr079" or "frcampus" of docs/data.md. Throws where a file is missing.
[[nodiscard]] MappingLog load_mapping_log(const std::string& name, const std::filesystem::path& data_folder);

/// A map built from a log, and what it cost.
struct LogMap {
  BuiltMap map;
  std::vector<TimedPose> scan_poses;  ///< those of the map, by time
  std::size_t scans = 0;              ///< in the log
  double recorded_s = 0.0;            ///< from the first scan to the last
  double cpu_s = 0.0;                 ///< processor time of reading in and building
  double peak_mb = 0.0;               ///< of the whole program meanwhile
};

[[nodiscard]] LogMap built(const MappingLog& log, const MapBuilderConfig& config);

}  // namespace tandem::bench
