#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tandem::recorder {

/// Whether `name` is as `pattern` says: `*` stands for any text, `?` for one character, all else for itself.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view name);

/// Whether a topic is recorded: named by one of `topics`, or these are none, and by none of `without`.
[[nodiscard]] bool is_chosen(std::string_view topic, const std::vector<std::string>& topics,
                             const std::vector<std::string>& without);

}  // namespace tandem::recorder
