#pragma once

#include <vector>

#include "services/relay/core/link_address.hpp"

namespace tandem {

/// Hears from the kernel when an address or an interface changes.
class AddressWatcher {
 public:
  /// Throws std::runtime_error when the kernel refuses.
  AddressWatcher();
  ~AddressWatcher();
  AddressWatcher(const AddressWatcher&) = delete;
  AddressWatcher& operator=(const AddressWatcher&) = delete;

  /// True if something may have changed since the last call. Does not wait.
  [[nodiscard]] bool changed();
  /// The IPv4 addresses of all interfaces that are up.
  [[nodiscard]] static std::vector<InterfaceAddress> addresses();

 private:
  int socket_ = -1;
};

}  // namespace tandem
