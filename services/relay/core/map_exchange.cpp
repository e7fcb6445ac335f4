#include "services/relay/core/map_exchange.hpp"

#include <algorithm>

namespace tandem {

std::optional<std::string> MapExchange::holding(Time now) const {
  if (!own_.empty()) return own_;
  if (!brought_.empty()) return brought_;
  if (now < asks_from_) return std::nullopt;
  return "";
}

bool MapExchange::is_asked_for(const std::vector<std::string>& holdings_of_others) const {
  return !own_.empty() && std::any_of(holdings_of_others.begin(), holdings_of_others.end(),
                                      [](const std::string& sha256) { return sha256.empty(); });
}

}  // namespace tandem
