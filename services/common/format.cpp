#include "services/common/format.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace tandem {

std::string formatted(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  std::va_list values_again;
  va_copy(values_again, values);
  const int length = std::vsnprintf(nullptr, 0, format, values);
  va_end(values);
  std::string text(static_cast<std::size_t>(std::max(length, 0)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, values_again);
  va_end(values_again);
  return text;
}

}  // namespace tandem
