#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace tandem {

/// The options in `tandem:eligible=6,exploration=0.5`, each asked for once by its planner.
class PlannerOptions {
 public:
  /// Throws ConfigError where `description` is not `name` or `name:key=number,...`.
  explicit PlannerOptions(std::string_view description);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Takes the option `key` over into `field`, which keeps its value, the default, where it is not given. A whole
  /// number is rounded; a truth is 0 or 1.
  void read(const std::string& key, double& field);
  void read(const std::string& key, int& field);
  void read(const std::string& key, bool& field);
  /// To be called last: throws ConfigError on an option that was not asked for, and names those that were.
  void refuse_unknown() const;

 private:
  std::string name_;
  std::map<std::string, double> given_;
  std::set<std::string> asked_;
};

}  // namespace tandem
