#include "services/relay/core/link_address.hpp"

namespace tandem {

std::optional<std::string> link_address(const std::string& wanted, const std::vector<InterfaceAddress>& present,
                                        const std::optional<std::string>& in_use) {
  std::optional<std::string> first;
  for (const auto& candidate : present) {
    if (candidate.interface != wanted && candidate.address != wanted) continue;
    if (candidate.address == in_use) return in_use;
    if (!first) first = candidate.address;
  }
  return first;
}

}  // namespace tandem
