#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::recorder {

/// A file that grows by whole records: one write() each, nothing kept in this process; what does not fit wholly on the
/// disk is taken back, so that the file ends with a whole record.
class RecordFile {
 public:
  /// Creates `file`, which must not exist, and its folder. Throws FileError.
  explicit RecordFile(const std::filesystem::path& file);
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  bool write(mcap::ByteView record);
  /// Forces what was written to the disk. After a power failure at most what came later is lost.
  void sync();
  [[nodiscard]] std::uint64_t size_bytes() const { return static_cast<std::uint64_t>(size_); }
  /// Why the last write() was false: "No space left on device".
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  int descriptor_ = -1;
  std::int64_t size_ = 0;
  std::string error_;
};

/// Writes a whole indexed recording: `fill` writes to the writer it is given. `file` is untouched until all is there,
/// and nothing is left behind when `fill` throws or the disk is full. Throws FileError.
void write_recording(const std::filesystem::path& file, const std::function<void(mcap::Writer&)>& fill);

/// Writes all that `reader` can read to the indexed recording `file`, which may be the one it reads. Throws as above.
void rewrite_recording(mcap::Reader& reader, const std::filesystem::path& file);

/// Replaces the live recording `file` by an indexed, compressed one with the same content. Throws FileError or
/// mcap::McapError; `file` is then as before.
void compact_recording(const std::filesystem::path& file);

/// What stands in a recording's header as the program that wrote it.
[[nodiscard]] mcap::Header recording_header();

}  // namespace tandem::recorder
