#pragma once

namespace tandem::simulator {

/// The rate that was set on the terminal `descriptor` [baud]; 0 if it is none.
[[nodiscard]] int line_rate(int descriptor);

}  // namespace tandem::simulator
