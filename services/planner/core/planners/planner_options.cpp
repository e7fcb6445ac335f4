#include "services/planner/core/planners/planner_options.hpp"

#include <charconv>
#include <cmath>

#include "services/common/config.hpp"

namespace tandem {

PlannerOptions::PlannerOptions(std::string_view description) {
  const std::string whole{description};
  const auto colon = description.find(':');
  name_ = description.substr(0, colon);
  if (colon == std::string_view::npos) return;
  for (std::string_view rest = description.substr(colon + 1); !rest.empty();) {
    const std::string_view pair = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    const auto equals = pair.find('=');
    double value = 0.0;
    const std::string_view text = equals == std::string_view::npos ? std::string_view{} : pair.substr(equals + 1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) {
      throw ConfigError("planner '" + whole + "': '" + std::string{pair} + "' is not key=number");
    }
    given_[std::string{pair.substr(0, equals)}] = value;
  }
}

double PlannerOptions::number(const std::string& key, double fallback) {
  const auto given = given_.find(key);
  return asked_[key] = given == given_.end() ? fallback : given->second;
}

int PlannerOptions::whole_number(const std::string& key, int fallback) {
  return static_cast<int>(std::lround(number(key, fallback)));
}

void PlannerOptions::refuse_unknown() const {
  for (const auto& [key, value] : given_) {
    if (asked_.contains(key)) continue;
    std::string known;
    for (const auto& [name, used] : asked_) known += (known.empty() ? "" : ", ") + name;
    throw ConfigError("planner '" + name_ + "' has no option '" + key + "'; it has: " + known);
  }
}

}  // namespace tandem
