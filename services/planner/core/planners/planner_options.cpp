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

void PlannerOptions::read(const std::string& key, double& field) {
  const auto given = given_.find(key);
  if (given != given_.end()) field = given->second;
  asked_.insert(key);
}

void PlannerOptions::read(const std::string& key, int& field) {
  double number = field;
  read(key, number);
  field = static_cast<int>(std::lround(number));
}

void PlannerOptions::read(const std::string& key, bool& field) {
  int number = field ? 1 : 0;
  read(key, number);
  field = number != 0;
}

void PlannerOptions::refuse_unknown() const {
  for (const auto& [key, value] : given_) {
    if (asked_.contains(key)) continue;
    std::string known;
    for (const auto& name : asked_) known += (known.empty() ? "" : ", ") + name;
    throw ConfigError("planner '" + name_ + "' has no option '" + key + "'; it has: " + known);
  }
}

}  // namespace tandem
