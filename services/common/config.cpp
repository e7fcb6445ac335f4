#include "services/common/config.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

namespace tandem::detail {
namespace {

/// Single-character edits from `a` to `b` (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row.back();
}

/// The shortest text that reads back as `value`, in any locale.
std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string range_text(Range range) {
  return "[" + shortest(range.min) + ", " + shortest(range.max) + "]";
}

class Reader final : public ConfigVisitor {
 public:
  Reader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  void field(std::string_view name, double& value, Range range) override {
    if (const auto* node = find(name)) value = real(*node, name, range);
  }
  void field(std::string_view name, std::int64_t& value, Range range) override {
    const auto* node = find(name);
    if (node == nullptr) return;
    if (!node->is_integer()) fail(*node, name, "is not a whole number");
    value = **node->as_integer();
    check_range(*node, name, static_cast<double>(value), range);
  }
  void field(std::string_view name, bool& value) override {
    const auto* node = find(name);
    if (node == nullptr) return;
    if (!node->is_boolean()) fail(*node, name, "is neither true nor false");
    value = **node->as_boolean();
  }
  void field(std::string_view name, std::string& value) override {
    if (const auto* node = find(name)) value = text(*node, name);
  }
  void field(std::string_view name, std::vector<double>& value, Range range) override {
    if (const auto* node = find(name)) {
      value.clear();
      for (const auto& element : array(*node, name)) value.push_back(real(element, name, range));
    }
  }
  void field(std::string_view name, std::vector<std::string>& value) override {
    if (const auto* node = find(name)) {
      value.clear();
      for (const auto& element : array(*node, name)) value.push_back(text(element, name));
    }
  }
  void field(std::string_view name, std::string& value, std::vector<std::string> allowed) override {
    const auto* node = find(name);
    if (node == nullptr) return;
    value = text(*node, name);
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
      std::string words;
      for (const auto& word : allowed) words += (words.empty() ? "" : ", ") + word;
      fail(*node, name, "is \"" + value + "\"; allowed: " + words);
    }
  }

  /// To be called after the visit: refuses what no field asked for.
  void refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
      const std::string name{key.str()};
      if (known_.contains(name)) continue;
      const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
        return edit_distance(a, name) < edit_distance(b, name);
      });
      throw ConfigError(place(node) + name + ": unknown key" +
                        (nearest == known_.end() ? "" : "; the nearest known key is " + *nearest));
    }
  }

 private:
  const toml::node* find(std::string_view name) {
    known_.insert(std::string{name});
    return table_.get(name);
  }
  std::string place(const toml::node& node) const {
    return file_ + ":" + std::to_string(node.source().begin.line) + ": ";
  }
  [[noreturn]] void fail(const toml::node& node, std::string_view name, const std::string& what) const {
    throw ConfigError(place(node) + std::string{name} + " " + what);
  }
  void check_range(const toml::node& node, std::string_view name, double value, Range range) const {
    if (!(value >= range.min && value <= range.max) || !std::isfinite(value)) {
      throw ConfigError(place(node) + std::string{name} + ": " + shortest(value) + " is outside " + range_text(range));
    }
  }
  double real(const toml::node& node, std::string_view name, Range range) const {
    if (!node.is_number()) fail(node, name, "is not a number");
    const double value = *node.value<double>();
    check_range(node, name, value, range);
    return value;
  }
  std::string text(const toml::node& node, std::string_view name) const {
    if (!node.is_string()) fail(node, name, "is not a \"string\"");
    return **node.as_string();
  }
  const toml::array& array(const toml::node& node, std::string_view name) const {
    if (!node.is_array()) fail(node, name, "is not a [list]");
    return *node.as_array();
  }

  const toml::table& table_;
  std::string file_;
  std::set<std::string> known_;
};

std::string toml_string(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string toml_real(double value) {
  std::string text = shortest(value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

class Writer final : public ConfigVisitor {
 public:
  void field(std::string_view name, double& value, Range) override { line(name, toml_real(value)); }
  void field(std::string_view name, std::int64_t& value, Range) override { line(name, std::to_string(value)); }
  void field(std::string_view name, bool& value) override { line(name, value ? "true" : "false"); }
  void field(std::string_view name, std::string& value) override { line(name, toml_string(value)); }
  void field(std::string_view name, std::vector<double>& value, Range) override {
    std::string list;
    for (const double element : value) list += (list.empty() ? "" : ", ") + toml_real(element);
    line(name, "[" + list + "]");
  }
  void field(std::string_view name, std::vector<std::string>& value) override {
    std::string list;
    for (const auto& element : value) list += (list.empty() ? "" : ", ") + toml_string(element);
    line(name, "[" + list + "]");
  }
  void field(std::string_view name, std::string& value, std::vector<std::string>) override {
    line(name, toml_string(value));
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void line(std::string_view name, const std::string& value) { text_ += std::string{name} + " = " + value + "\n"; }
  std::string text_;
};

toml::table parsed(std::string_view toml_text, const std::string& file_name) {
  try {
    return toml::parse(toml_text, file_name);
  } catch (const toml::parse_error& error) {
    throw ConfigError(file_name + ":" + std::to_string(error.source().begin.line) + ": " +
                      std::string{error.description()});
  }
}

}  // namespace

void read_config(AnyConfig& config, std::string_view toml_text, const std::string& file_name) {
  const toml::table table = parsed(toml_text, file_name);
  Reader reader{table, file_name};
  config.visit(reader);
  reader.refuse_unknown_keys();
}

void read_config_file(AnyConfig& config, const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw ConfigError(file.string() + ": cannot be read; give the folder with --config");
  std::ostringstream text;
  text << stream.rdbuf();
  read_config(config, text.str(), file.string());
}

std::string written_config(AnyConfig& config) {
  Writer writer;
  config.visit(writer);
  return writer.text();
}

}  // namespace tandem::detail

namespace tandem {

std::map<std::string, int> config_lines(std::string_view toml) {
  std::map<std::string, int> lines;
  for (const auto& [key, node] : detail::parsed(toml, "config")) {
    lines.emplace(key.str(), static_cast<int>(key.source().begin.line));
  }
  return lines;
}

}  // namespace tandem
