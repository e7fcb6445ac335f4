#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tandem {

/// An IPv4 address of an interface that is up.
struct InterfaceAddress {
  std::string interface;
  std::string address;
};

/// The address at which the relay is to be on the link; nothing while there is none.
///
/// `wanted` is the name of an interface, whose address is followed, or one address. What is `in_use` is kept as long as
/// it is there, else the first that fits is taken.
[[nodiscard]] std::optional<std::string> link_address(const std::string& wanted,
                                                      const std::vector<InterfaceAddress>& present,
                                                      const std::optional<std::string>& in_use);

}  // namespace tandem
