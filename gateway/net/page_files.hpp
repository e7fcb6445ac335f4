#pragma once

#include <map>
#include <string>
#include <vector>

#include "gateway/net/https_server.hpp"

namespace tandem::net {

/// The files of the web page, by what a browser asks for.
class PageFiles {
 public:
  /// `files` outlive it.
  explicit PageFiles(const std::vector<Asset>& files) {
    for (const auto& file : files) by_path_.emplace(file.path, &file);
  }

  /// The file at `target` whatever its query; "/" and the pairing link's "/p" are the page itself. Null if there is
  /// none.
  [[nodiscard]] const Asset* find(const std::string& target) const {
    const std::string path = target.substr(0, target.find('?'));
    const auto found = by_path_.find(path == "/" || path == "/p" ? "/index.html" : path);
    return found == by_path_.end() ? nullptr : found->second;
  }
  /// True if the file there never changes: its name carries a hash.
  [[nodiscard]] bool is_immutable(const std::string& target) const {
    const Asset* file = find(target);
    return file != nullptr && file->immutable;
  }

 private:
  std::map<std::string, const Asset*, std::less<>> by_path_;
};

}  // namespace tandem::net
