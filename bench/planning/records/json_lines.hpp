#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "services/common/config.hpp"
#include "services/common/file_io.hpp"

namespace tandem::bench {

/// Records that are a line of JSON each. A record has `template <typename Self, typename Visitor> static void
/// visit_fields(Self& record, Visitor&& field)` that shows each field once, by name: writing and reading cannot differ.

/// The record as one line, without the line's end.
template <typename Record>
[[nodiscard]] std::string to_line(const Record& record) {
  nlohmann::ordered_json line;
  Record::visit_fields(record, [&](const char* name, const auto& value) { line[name] = value; });
  return line.dump();
}

/// The record of a line; throws ConfigError if it is none.
template <typename Record>
[[nodiscard]] Record from_line(std::string_view line) {
  Record record;
  try {
    const auto json = nlohmann::json::parse(line);
    Record::visit_fields(record, [&](const char* name, auto& value) { json.at(name).get_to(value); });
  } catch (const nlohmann::json::exception& error) {
    throw ConfigError(std::string("not a line of benchmark results: ") + error.what());
  }
  return record;
}

/// All whole lines of a file, none if there is no such file. A last line that was cut off is left out.
template <typename Record>
[[nodiscard]] std::vector<Record> read_lines(const std::filesystem::path& file) {
  std::vector<Record> records;
  if (!std::filesystem::exists(file)) return records;
  const std::string content = read_file(file);
  for (std::size_t begin = 0, end = 0; (end = content.find('\n', begin)) != std::string::npos; begin = end + 1) {
    records.push_back(from_line<Record>(std::string_view{content}.substr(begin, end - begin)));
  }
  return records;
}

}  // namespace tandem::bench
