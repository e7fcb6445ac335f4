#include "services/recorder/core/topic_choice.hpp"

#include <algorithm>

namespace tandem::recorder {

bool matches(std::string_view pattern, std::string_view name) {
  // The last star seen, and how much it has swallowed: on a mismatch it swallows one character more.
  std::size_t star = std::string_view::npos;
  std::size_t swallowed = 0;
  std::size_t p = 0;
  std::size_t n = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      swallowed = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++swallowed;
    } else {
      return false;
    }
  }
  return std::all_of(pattern.begin() + static_cast<std::ptrdiff_t>(p), pattern.end(), [](char c) { return c == '*'; });
}

bool is_chosen(std::string_view topic, const std::vector<std::string>& topics,
               const std::vector<std::string>& without) {
  const auto names_it = [topic](const std::string& pattern) { return matches(pattern, topic); };
  return (topics.empty() || std::any_of(topics.begin(), topics.end(), names_it)) &&
         std::none_of(without.begin(), without.end(), names_it);
}

}  // namespace tandem::recorder
