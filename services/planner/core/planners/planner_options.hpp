#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tandem {

/// The options in `tandem:eligible=6,exploration=0.5`, each asked for once by its planner.
class PlannerOptions {
 public:
  /// Throws ConfigError where `description` is not `name` or `name:key=number,...`.
  explicit PlannerOptions(std::string_view description);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The option `key` if it is there, else `fallback`.
  [[nodiscard]] double number(const std::string& key, double fallback);
  [[nodiscard]] int whole_number(const std::string& key, int fallback);
  /// To be called last: throws ConfigError on an option that was not asked for, and names those that were.
  void refuse_unknown() const;

 private:
  std::string name_;
  std::map<std::string, double> given_;
  std::map<std::string, double> asked_;  ///< with what was given, or the default
};

}  // namespace tandem
