#pragma once

namespace tandem {

/// Sets the rate of an open terminal or pseudo-terminal, once what was written is out; any rate the hardware can do.
/// False if it cannot, or if `descriptor` is no terminal.
[[nodiscard]] bool set_line_rate(int descriptor, int baud_rate);

}  // namespace tandem
