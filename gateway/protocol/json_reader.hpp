#pragma once
// Private to gateway/protocol: includes the JSON library.

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::protocol {

using Json = nlohmann::json;

inline constexpr int kMaxDepth = 8;

/// `text` as JSON, or none with a `reason`: a syntax error, nesting over kMaxDepth, a key that comes twice.
[[nodiscard]] std::optional<Json> parse_json(std::string_view text, std::string& reason);

/// Reads the fields of one JSON object and remembers the first thing that is wrong.
class ObjectReader {
 public:
  ObjectReader(const Json& json, std::string& reason) : json_(json), reason_(reason) {
    if (!json.is_object()) fail("not an object");
  }

  /// Ends the reading: every key must have been asked for.
  [[nodiscard]] bool complete() {
    if (!reason_.empty()) return false;
    for (const auto& [key, value] : json_.items()) {
      if (!known_.contains(key)) fail("unknown key '" + key.substr(0, 40) + "'");
    }
    return reason_.empty();
  }

  [[nodiscard]] bool has(const char* key) {
    known_.insert(key);
    return json_.is_object() && json_.contains(key);
  }

  double number(const char* key, double min, double max) {
    const Json* value = find(key);
    if (value == nullptr) return 0.0;
    if (!value->is_number()) return fail(std::string{key} + " is not a number"), 0.0;
    const double number = value->get<double>();
    if (!std::isfinite(number) || number < min || number > max) return fail(std::string{key} + " is out of range"), 0.0;
    return number;
  }

  std::uint64_t count(const char* key, std::uint64_t min, std::uint64_t max) {
    const Json* value = find(key);
    if (value == nullptr) return 0;
    if (!value->is_number_unsigned()) return fail(std::string{key} + " is not a whole number"), 0;
    const auto number = value->get<std::uint64_t>();
    if (number < min || number > max) return fail(std::string{key} + " is out of range"), 0;
    return number;
  }

  std::string text(const char* key, std::size_t min_length, std::size_t max_length) {
    const Json* value = find(key);
    if (value == nullptr) return {};
    if (!value->is_string()) return fail(std::string{key} + " is not a text"), std::string{};
    auto text = value->get<std::string>();
    if (text.size() < min_length || text.size() > max_length) fail(std::string{key} + " is too short or too long");
    return text;
  }

  std::string word(const char* key, const std::vector<std::string_view>& allowed) {
    std::string word = text(key, 1, 64);
    for (const auto& one : allowed) {
      if (word == one) return word;
    }
    fail(std::string{key} + " is none of the known words");
    return {};
  }

  bool truth(const char* key) {
    const Json* value = find(key);
    if (value == nullptr) return false;
    if (!value->is_boolean()) return fail(std::string{key} + " is not true or false"), false;
    return value->get<bool>();
  }

  const Json& array(const char* key) {
    static const Json kEmpty = Json::array();
    const Json* value = find(key);
    if (value == nullptr) return kEmpty;
    if (!value->is_array()) return fail(std::string{key} + " is not a list"), kEmpty;
    return *value;
  }

  const Json& object(const char* key) {
    static const Json kEmpty = Json::object();
    const Json* value = find(key);
    if (value == nullptr) return kEmpty;
    if (!value->is_object()) return fail(std::string{key} + " is not an object"), kEmpty;
    return *value;
  }

  void fail(const std::string& reason) {
    if (reason_.empty()) reason_ = reason;
  }

 private:
  const Json* find(const char* key) {
    if (!has(key)) {
      fail(std::string{key} + " is missing");
      return nullptr;
    }
    return &json_[key];
  }

  const Json& json_;
  std::string& reason_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace tandem::protocol
