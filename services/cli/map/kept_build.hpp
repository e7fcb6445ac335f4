#pragma once

#include <optional>
#include <string>

#include "services/common/clock.hpp"
#include "services/map_builder/core/build_checkpoint.hpp"

namespace tandem::cli {

/// The checkpoint of a build, in the file OUTPUT.checkpoint: written now and then, so that whatever ends the program
/// costs seconds of work alone.
class KeptBuild {
 public:
  KeptBuild(const std::string& output, BuildKey key);

  /// Where to go on: at the checkpoint if it is of this very build, else at the beginning. Which, it says on standard
  /// error if there is a checkpoint at all.
  [[nodiscard]] BuildState state(const Drive& drive, const MapBuilderConfig& config) const;

  /// Writes the checkpoint if there is none yet, or the last one is old enough.
  void save_when_due(const BuildState& state);
  /// Writes the checkpoint. Where that fails it says so once, and the build goes on.
  void save(const BuildState& state);
  /// The end of the sentence that says how far the build came.
  [[nodiscard]] std::string how_to_go_on() const;

  /// There is nothing more to go on with.
  static void remove(const std::string& output);

 private:
  std::string file_;
  BuildKey key_;
  SteadyClock clock_;
  std::optional<Time> saved_at_;
  bool has_failed_ = false;
};

}  // namespace tandem::cli
