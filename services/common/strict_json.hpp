#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "services/common/config.hpp"

namespace tandem {

/// `text` as JSON. Throws ConfigError with `file_name`, line and column where it is not.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& file_name);

/// One JSON object read strictly: every error says file and key, and a key that nobody asked for is one.
///
/// `where` is the place in messages: "brl.json", then "brl.json: robot". The JSON value must outlive it.
class StrictObject {
 public:
  /// Throws ConfigError if `value` is not an object.
  StrictObject(const nlohmann::json& value, std::string where);

  [[nodiscard]] bool has(std::string_view key);
  [[nodiscard]] double number(std::string_view key, Range range);
  [[nodiscard]] double number_or(std::string_view key, double fallback, Range range);
  [[nodiscard]] std::int64_t whole_number_or(std::string_view key, std::int64_t fallback, Range range);
  [[nodiscard]] std::string text(std::string_view key);
  /// Empty where the key is absent.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key);
  [[nodiscard]] std::string text_or(std::string_view key, std::string fallback, const std::set<std::string>& allowed);
  /// Exactly `count` finite numbers.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t count);
  /// A list of lists of exactly `count` finite numbers each.
  [[nodiscard]] std::vector<std::vector<double>> rows(std::string_view key, std::size_t count);
  [[nodiscard]] StrictObject object(std::string_view key);
  /// Empty where the key is absent.
  [[nodiscard]] std::vector<StrictObject> objects(std::string_view key);

  /// All keys of the object, for one whose keys are names; each counts as asked for.
  [[nodiscard]] std::vector<std::string> names();
  /// The place in messages.
  [[nodiscard]] const std::string& where() const { return where_; }

  /// Throws ConfigError: what is wrong with the value of `key`.
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

  /// To be called last: throws ConfigError on a key that was not asked for.
  void refuse_unknown_keys() const;

 private:
  [[nodiscard]] const nlohmann::json& at(std::string_view key);
  [[nodiscard]] double checked(std::string_view key, const nlohmann::json& value, Range range) const;
  [[nodiscard]] std::vector<double> checked_row(std::string_view key, const nlohmann::json& value,
                                                std::size_t count) const;

  const nlohmann::json& value_;
  std::string where_;
  std::set<std::string> known_;
};

}  // namespace tandem
