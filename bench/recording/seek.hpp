#pragma once

#include <cstdint>

namespace tandem::bench {

/// How long it takes to open an indexed recording of `size_mb` [MB] and read the message in its middle [s].
[[nodiscard]] double seek_s(std::uint64_t size_mb);

}  // namespace tandem::bench
