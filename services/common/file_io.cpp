#include "services/common/file_io.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace tandem {
namespace {

std::filesystem::path part_of(std::filesystem::path file) {
  file += ".part";
  return file;
}

/// `part` is written first and takes the place of `file` at the end; its mode is kept where it is there already.
void write_by_way_of(const std::filesystem::path& part, const std::filesystem::path& file, std::string_view content) {
  const auto fail = [&](const std::string& reason) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw FileError(file.string() + ": cannot be written: " + reason);
  };
  std::ofstream stream{part, std::ios::binary | std::ios::trunc};
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) fail(std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (error) fail(error.message());
}

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw FileError(file.string() + ": cannot be read: " + std::strerror(errno));
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  write_by_way_of(part_of(file), file, content);
}

void write_private_file(const std::filesystem::path& file, std::string_view content) {
  const std::filesystem::path part = part_of(file);
  unlink(part.c_str());  // a left-over may have been readable by others
  const int made = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (made < 0) throw FileError(file.string() + ": cannot be written: " + std::strerror(errno));
  close(made);
  write_by_way_of(part, file, content);
}

}  // namespace tandem
