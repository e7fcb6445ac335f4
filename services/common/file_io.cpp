#include "services/common/file_io.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace tandem {

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw FileError(file.string() + ": cannot be read: " + std::strerror(errno));
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::path part = file;
  part += ".part";
  {
    std::ofstream stream{part, std::ios::binary | std::ios::trunc};
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.flush();
    if (!stream) throw FileError(file.string() + ": cannot be written: " + std::strerror(errno));
  }
  std::error_code error;
  std::filesystem::rename(part, file, error);
  if (error) throw FileError(file.string() + ": cannot be written: " + error.message());
}

}  // namespace tandem
