#pragma once

#include <string_view>

namespace tandem::recorder {

/// The IDL that defines `type_name` ("tandem::msg::Odometry"), its includes inlined, so that a recording explains
/// itself to any reader. Empty for a type that is not of the contract. Embedded at build time from idl/*.idl.
[[nodiscard]] std::string_view idl_of(std::string_view type_name);

}  // namespace tandem::recorder
