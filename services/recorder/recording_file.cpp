#include "services/recorder/recording_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "services/common/file_io.hpp"
#include "services/common/version.hpp"
#include "services/recorder/core/mcap_copy.hpp"

namespace tandem::recorder {

RecordFile::RecordFile(const std::filesystem::path& file) {
  std::error_code ignored;  // open() says what is wrong
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw FileError(file.string() + ": cannot be created: " + std::strerror(errno));
}

RecordFile::~RecordFile() {
  ::close(descriptor_);
}

bool RecordFile::write(mcap::ByteView record) {
  std::size_t done = 0;
  while (done < record.size()) {
    const ssize_t count = ::write(descriptor_, record.data() + done, record.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      error_ = count < 0 ? std::strerror(errno) : "nothing more can be written";
      if (::ftruncate(descriptor_, size_) == 0) ::lseek(descriptor_, size_, SEEK_SET);
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  size_ += static_cast<std::int64_t>(record.size());
  return true;
}

void RecordFile::sync() {
  ::fdatasync(descriptor_);
}

void write_recording(const std::filesystem::path& file, const std::function<void(mcap::Writer&)>& fill) {
  std::filesystem::path part = file;
  part += ".part";
  std::error_code error;
  std::filesystem::remove(part, error);  // of a run that was killed
  try {
    RecordFile out{part};
    mcap::IndexedWriter writer{[&out](mcap::ByteView bytes) { return out.write(bytes); }, recording_header()};
    fill(writer);
    if (!writer.finish()) throw FileError(file.string() + ": cannot be written: " + out.error());
    out.sync();
    std::filesystem::rename(part, file);
  } catch (...) {
    std::filesystem::remove(part, error);
    throw;
  }
}

void rewrite_recording(mcap::Reader& reader, const std::filesystem::path& file) {
  write_recording(file, [&reader](mcap::Writer& writer) { (void)mcap::copy(reader, writer); });
}

void compact_recording(const std::filesystem::path& file) {
  mcap::Reader reader{mcap::file_source(file), file.string()};
  rewrite_recording(reader, file);
}

mcap::Header recording_header() {
  return {"", "tandem " + version()};
}

}  // namespace tandem::recorder
