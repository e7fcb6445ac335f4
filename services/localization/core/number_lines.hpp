#pragma once

#include <string>
#include <vector>

namespace tandem {

/// The numbers of each line of `text` that is not empty or a comment (`#`), `count` in each at least; locale plays no
/// part. Throws std::runtime_error, "`file_name`:12: ...", for a line with fewer or with something else.
[[nodiscard]] std::vector<std::vector<double>> number_lines(const std::string& text, std::size_t count,
                                                            const std::string& file_name);

}  // namespace tandem
