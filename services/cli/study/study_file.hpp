#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include "services/experiment/core/study/study_json.hpp"

namespace tandem::cli {

/// The episodes of a study, each kept in a file as soon as it is finished: a line of settings, then one line an
/// episode. Whatever ends the program, what was finished is there, and the next run goes on behind it.
class StudyFile {
 public:
  /// Kept in memory alone.
  explicit StudyFile(experiment::StudySettings settings) : settings_(std::move(settings)) {}
  /// Takes up what `file` holds. Throws WrongUse if that is another study, FileError if it cannot be written.
  StudyFile(experiment::StudySettings settings, std::filesystem::path file);

  [[nodiscard]] bool has(std::uint64_t seed) const { return episodes_.contains(seed); }
  void add(const experiment::EpisodeResult& episode);
  /// The episodes of seeds `first`, `first` + 1, ... that are there, in this order.
  [[nodiscard]] std::vector<experiment::EpisodeResult> episodes(std::uint64_t first, std::uint64_t count) const;
  /// Writes the file anew in the order of the seeds: the same file however it came about.
  void finish();

 private:
  [[nodiscard]] std::string text() const;
  void write_and_append();

  experiment::StudySettings settings_;
  std::filesystem::path file_;
  std::map<std::uint64_t, experiment::EpisodeResult> episodes_;
  std::ofstream append_;
};

}  // namespace tandem::cli
