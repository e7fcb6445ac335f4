#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace tandem::gateway {

/// Which Host and Origin headers are ours: exact matches only. A foreign Host is DNS rebinding, a foreign Origin
/// another page that uses the phone's cookie.
class HostPolicy {
 public:
  HostPolicy(const std::vector<std::string>& names, std::uint16_t port) {
    for (const auto& name : names) {
      hosts_.insert(name + ":" + std::to_string(port));
      if (port == 443) hosts_.insert(name);
    }
  }

  [[nodiscard]] bool is_our_host(const std::string& host) const { return hosts_.contains(host); }
  /// `origin` must be the very page that `host` served.
  [[nodiscard]] bool is_our_origin(const std::string& origin, const std::string& host) const {
    return is_our_host(host) && origin == "https://" + host;
  }

 private:
  std::set<std::string> hosts_;
};

/// The value of cookie `name` in a Cookie header; empty if it is not there.
[[nodiscard]] inline std::string cookie_value(const std::string& header, const std::string& name) {
  std::size_t at = 0;
  while (at < header.size()) {
    std::size_t end = header.find(';', at);
    if (end == std::string::npos) end = header.size();
    const std::size_t start = header.find_first_not_of(' ', at);
    if (start < end && header.compare(start, name.size() + 1, name + "=") == 0) {
      return header.substr(start + name.size() + 1, end - start - name.size() - 1);
    }
    at = end + 1;
  }
  return "";
}

}  // namespace tandem::gateway
