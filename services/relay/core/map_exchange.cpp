#include "services/relay/core/map_exchange.hpp"

#include <algorithm>

namespace tandem {

std::optional<std::string> MapExchange::holding(Time now) const {
  if (!own_.empty()) return own_;
  if (!brought_.empty()) return brought_;
  if (now < asks_from_) return std::nullopt;
  return "";
}

bool MapExchange::is_asked_for(const std::vector<HeldMap>& others) const {
  return !own_.empty() &&
         std::any_of(others.begin(), others.end(), [](const HeldMap& other) { return other.sha256.empty(); });
}

std::optional<HeldMap> MapExchange::other_map(const std::vector<HeldMap>& others, Time now) {
  const std::string here = holding(now).value_or("");
  const auto other = std::find_if(others.begin(), others.end(), [&](const HeldMap& held) {
    return !here.empty() && !held.sha256.empty() && held.sha256 != here;
  });
  if (other == others.end()) {
    differs_since_.reset();
    return std::nullopt;
  }
  if (!differs_since_) differs_since_ = now;
  return now - *differs_since_ > kMostDifference ? std::optional{*other} : std::nullopt;
}

}  // namespace tandem
