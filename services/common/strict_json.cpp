#include "services/common/strict_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace tandem {
namespace {

std::string short_number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& file_name) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw ConfigError(file_name + ": " + error.what());
  }
}

StrictObject::StrictObject(const nlohmann::json& value, std::string where) : value_(value), where_(std::move(where)) {
  if (!value_.is_object()) throw ConfigError(where_ + ": must be an object, {...}");
}

bool StrictObject::has(std::string_view key) {
  known_.emplace(key);
  return value_.contains(key);
}

double StrictObject::number(std::string_view key, Range range) {
  return checked(key, at(key), range);
}

double StrictObject::number_or(std::string_view key, double fallback, Range range) {
  return has(key) ? number(key, range) : fallback;
}

std::int64_t StrictObject::whole_number_or(std::string_view key, std::int64_t fallback, Range range) {
  if (!has(key)) return fallback;
  if (!at(key).is_number_integer()) fail(key, "must be a whole number");
  return static_cast<std::int64_t>(checked(key, at(key), range));
}

std::string StrictObject::text(std::string_view key) {
  const auto& value = at(key);
  if (!value.is_string()) fail(key, "must be a text");
  return value.get<std::string>();
}

std::vector<std::string> StrictObject::texts(std::string_view key) {
  if (!has(key)) return {};
  const auto& value = at(key);
  if (!value.is_array()) fail(key, "must be a list of texts");
  std::vector<std::string> all;
  for (const auto& one : value) {
    if (!one.is_string()) fail(key, "must be a list of texts");
    all.push_back(one.get<std::string>());
  }
  return all;
}

std::vector<std::string> StrictObject::names() {
  std::vector<std::string> all;
  for (const auto& [key, value] : value_.items()) {
    if (key == "$schema" || key == "comment") continue;
    known_.insert(key);
    all.push_back(key);
  }
  return all;
}

std::string StrictObject::text_or(std::string_view key, std::string fallback, const std::set<std::string>& allowed) {
  if (!has(key)) return fallback;
  const std::string word = text(key);
  if (allowed.contains(word)) return word;
  std::string words;
  for (const auto& one : allowed) words += (words.empty() ? "" : ", ") + one;
  fail(key, "is \"" + word + "\"; allowed: " + words);
}

std::vector<double> StrictObject::numbers(std::string_view key, std::size_t count) {
  return checked_row(key, at(key), count);
}

std::vector<std::vector<double>> StrictObject::rows(std::string_view key, std::size_t count) {
  const auto& value = at(key);
  if (!value.is_array()) fail(key, "must be a list");
  std::vector<std::vector<double>> all;
  for (const auto& row : value) all.push_back(checked_row(key, row, count));
  return all;
}

StrictObject StrictObject::object(std::string_view key) {
  return {at(key), where_ + ": " + std::string{key}};
}

std::vector<StrictObject> StrictObject::objects(std::string_view key) {
  if (!has(key)) return {};
  const auto& value = at(key);
  if (!value.is_array()) fail(key, "must be a list of objects");
  std::vector<StrictObject> all;
  for (const auto& one : value) {
    all.emplace_back(one, where_ + ": " + std::string{key} + "[" + std::to_string(all.size()) + "]");
  }
  return all;
}

void StrictObject::refuse_unknown_keys() const {
  for (const auto& [key, value] : value_.items()) {
    if (known_.contains(key) || key == "$schema" || key == "comment") continue;
    std::string words;
    for (const auto& one : known_) words += (words.empty() ? "" : ", ") + one;
    fail(key, "unknown key; known: " + words);
  }
}

const nlohmann::json& StrictObject::at(std::string_view key) {
  known_.emplace(key);
  const auto found = value_.find(key);
  if (found == value_.end()) fail(key, "is missing");
  return *found;
}

void StrictObject::fail(std::string_view key, const std::string& what) const {
  throw ConfigError(where_ + ": " + std::string{key} + ": " + what);
}

double StrictObject::checked(std::string_view key, const nlohmann::json& value, Range range) const {
  if (!value.is_number()) fail(key, "must be a number");
  const double number = value.get<double>();
  if (!std::isfinite(number) || number < range.min || number > range.max) {
    fail(key, short_number(number) + " is outside [" + short_number(range.min) + ", " + short_number(range.max) + "]");
  }
  return number;
}

std::vector<double> StrictObject::checked_row(std::string_view key, const nlohmann::json& value,
                                              std::size_t count) const {
  if (!value.is_array() || value.size() != count) fail(key, "must be " + std::to_string(count) + " numbers");
  std::vector<double> row;
  for (const auto& one : value) row.push_back(checked(key, one, {-1e6, 1e6}));
  return row;
}

}  // namespace tandem
