#include "services/cli/map/kept_build.hpp"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "services/common/file_io.hpp"

namespace tandem::cli {
namespace {

constexpr Duration kSaveEvery = std::chrono::seconds{2};

std::string file_beside(const std::string& output) {
  return output + ".checkpoint";
}

}  // namespace

KeptBuild::KeptBuild(const std::string& output, BuildKey key) : file_(file_beside(output)), key_(std::move(key)) {}

BuildState KeptBuild::state(const Drive& drive, const MapBuilderConfig& config) const {
  if (!std::filesystem::exists(file_)) return {};
  CheckpointReading reading;
  try {
    reading = read_checkpoint(read_file(file_), key_, drive, config);
  } catch (const FileError& error) {
    std::fprintf(stderr, "tandem: %s; starting anew\n", error.what());
    return {};
  }
  if (!reading.state) {
    std::fprintf(stderr, "tandem: %s %s; starting anew\n", file_.c_str(), reading.refusal.c_str());
    return {};
  }
  std::fprintf(stderr, "tandem: going on from %s, after %zu of %zu scans (--fresh starts anew)\n", file_.c_str(),
               reading.state->graph.places.size(), drive.scans.size());
  return *std::move(reading.state);
}

void KeptBuild::save_when_due(const BuildState& state) {
  if (!saved_at_ || clock_.now() - *saved_at_ >= kSaveEvery) save(state);
}

void KeptBuild::save(const BuildState& state) {
  try {
    write_file_atomically(file_, checkpoint_of(state, key_));
    has_failed_ = false;
  } catch (const FileError& error) {
    if (!std::exchange(has_failed_, true)) {
      std::fprintf(stderr, "tandem: no checkpoint can be kept: %s\n", error.what());
    }
  }
  saved_at_ = clock_.now();
}

std::string KeptBuild::how_to_go_on() const {
  if (has_failed_) return "; nothing could be kept";
  return ", kept in " + file_ + ": the same command goes on from there";
}

void KeptBuild::remove(const std::string& output) {
  std::error_code ignored;
  std::filesystem::remove(file_beside(output), ignored);
}

}  // namespace tandem::cli
