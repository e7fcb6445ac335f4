#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "services/map_builder/core/build_state.hpp"
#include "services/map_builder/core/drive_log.hpp"

namespace tandem {

/// What decides what a build becomes: a state of one is of no use to another.
struct BuildKey {
  std::string program;     ///< one line: which version of the program builds
  std::string drive;       ///< SHA-256 of all that it builds from
  std::string parameters;  ///< SHA-256
};

/// The key of a build by a program that says of itself `program`.
[[nodiscard]] BuildKey key_of(const Drive& drive, const MapBuilderConfig& config, const std::string& program);

/// `state` as bytes: a text header with the format's version, the key and a checksum, then the numbers as this machine
/// holds them.
[[nodiscard]] std::string checkpoint_of(const BuildState& state, const BuildKey& key);

/// What was read from a checkpoint: a state, or why there is none.
struct CheckpointReading {
  std::optional<BuildState> state;
  std::string refusal;  ///< "is damaged", "is of another recording", ...: of the checkpoint
};

/// Reads what checkpoint_of wrote, for a build with `key`. Nodes' surfaces are made anew from `drive`.
[[nodiscard]] CheckpointReading read_checkpoint(std::string_view bytes, const BuildKey& key, const Drive& drive,
                                                const MapBuilderConfig& config);

}  // namespace tandem
