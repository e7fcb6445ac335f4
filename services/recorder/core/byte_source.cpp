#include "services/recorder/core/byte_source.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace tandem::mcap {
namespace {

class FileSource final : public ByteSource {
 public:
  explicit FileSource(const std::filesystem::path& file) : stream_(file, std::ios::binary), name_(file.string()) {
    std::error_code error;
    size_ = std::filesystem::file_size(file, error);
    if (!stream_ || error) {
      throw McapError(name_ + ": cannot be opened: " + (error ? error.message() : std::strerror(errno)));
    }
  }
  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] Bytes read(std::uint64_t offset, std::uint64_t length) override {
    Bytes bytes(static_cast<std::size_t>(std::min(length, size_ - std::min(offset, size_))));
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream_) throw McapError(name_ + ": cannot be read at byte " + std::to_string(offset));
    return bytes;
  }

 private:
  std::ifstream stream_;
  std::string name_;
  std::uint64_t size_ = 0;
};

class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(Bytes bytes) : bytes_(std::move(bytes)) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] Bytes read(std::uint64_t offset, std::uint64_t length) override {
    const std::uint64_t start = std::min<std::uint64_t>(offset, bytes_.size());
    const std::uint64_t end = start + std::min<std::uint64_t>(length, bytes_.size() - start);
    return {bytes_.begin() + static_cast<std::ptrdiff_t>(start), bytes_.begin() + static_cast<std::ptrdiff_t>(end)};
  }

 private:
  Bytes bytes_;
};

}  // namespace

std::unique_ptr<ByteSource> file_source(const std::filesystem::path& file) {
  return std::make_unique<FileSource>(file);
}
std::unique_ptr<ByteSource> memory_source(Bytes bytes) {
  return std::make_unique<MemorySource>(std::move(bytes));
}

}  // namespace tandem::mcap
