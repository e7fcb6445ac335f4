#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tandem {

/// A configuration that cannot be used; what() says file, line, key and what is allowed.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The closed range of values a field may have.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// Is shown each field of a config struct, by name; loading, checking and writing are visitors.
///
/// A config struct has `template <typename Visitor> void visit_fields(Visitor& visitor)` that names every field once.
class ConfigVisitor {
 public:
  virtual ~ConfigVisitor() = default;
  virtual void field(std::string_view name, double& value, Range range) = 0;
  virtual void field(std::string_view name, std::int64_t& value, Range range) = 0;
  virtual void field(std::string_view name, bool& value) = 0;
  virtual void field(std::string_view name, std::string& value) = 0;
  virtual void field(std::string_view name, std::vector<double>& value, Range range) = 0;
  virtual void field(std::string_view name, std::vector<std::string>& value) = 0;
  /// A word out of `allowed`.
  virtual void field(std::string_view name, std::string& value, std::vector<std::string> allowed) = 0;
};

namespace detail {
/// A config struct without its type, so that the TOML library is compiled once.
class AnyConfig {
 public:
  virtual ~AnyConfig() = default;
  virtual void visit(ConfigVisitor& visitor) = 0;
};
template <typename Config>
class AnyConfigOf final : public AnyConfig {
 public:
  explicit AnyConfigOf(Config& config) : config_(config) {}
  void visit(ConfigVisitor& visitor) override { config_.visit_fields(visitor); }

 private:
  Config& config_;
};
void read_config(AnyConfig& config, std::string_view toml, const std::string& file_name);
void read_config_file(AnyConfig& config, const std::filesystem::path& file);
std::string written_config(AnyConfig& config);
}  // namespace detail

/// The config in `file`; fields it does not name keep their default. An absent file throws.
///
/// Throws ConfigError on a syntax error, an unknown key (with the nearest known one), a wrong type, a value outside its
/// range or not finite.
template <typename Config>
[[nodiscard]] Config load_config(const std::filesystem::path& file) {
  Config config;
  detail::AnyConfigOf<Config> any{config};
  detail::read_config_file(any, file);
  return config;
}

/// As load_config, from text; `file_name` stands in error messages.
template <typename Config>
[[nodiscard]] Config parse_config(std::string_view toml, const std::string& file_name = "config") {
  Config config;
  detail::AnyConfigOf<Config> any{config};
  detail::read_config(any, toml, file_name);
  return config;
}

/// The top-level keys of a TOML text, each with the line it stands in. Throws ConfigError when it is no TOML.
[[nodiscard]] std::map<std::string, int> config_lines(std::string_view toml);

/// `config` as TOML, every field with its effective value; parse_config gives the same config back.
template <typename Config>
[[nodiscard]] std::string write_config(Config config) {
  detail::AnyConfigOf<Config> any{config};
  return detail::written_config(any);
}

}  // namespace tandem
