#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tandem {

/// A file that cannot be read or written; what() names it and says why.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The whole of `file`, byte for byte. Throws FileError.
[[nodiscard]] std::string read_file(const std::filesystem::path& file);

/// Writes `content` so that `file` is either its old self or all of the new, whatever happens meanwhile. Throws
/// FileError.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// As write_file_atomically, for what only its owner may read, at no time anybody else: mode 0600. For keys.
void write_private_file(const std::filesystem::path& file, std::string_view content);

}  // namespace tandem
