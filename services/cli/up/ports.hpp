#pragma once

#include <string>

namespace tandem::cli {

/// `preferred` if nobody listens there on `address`, else a free TCP port that the kernel picks.
[[nodiscard]] int free_tcp_port(const std::string& address, int preferred);

}  // namespace tandem::cli
