#include "robot/laser/core/scip_reply.hpp"

#include <algorithm>

#include "robot/laser/core/scip_encoding.hpp"

namespace tandem::scip {
namespace {

constexpr std::size_t kDataPerLine = 64;
constexpr std::size_t kTimestampCharacters = 4;
constexpr std::uint32_t kTimestampMask = 0xFFFFFF;
constexpr std::size_t kMostLines = 2000;  // a scan of 1081 ranges with intensities has 102

/// VV, PP and II close their lines with ";" and a checksum that leaves the ";" out.
bool has_semicolons(std::string_view echo) {
  return echo.starts_with("VV") || echo.starts_with("PP") || echo.starts_with("II");
}

std::string closed(const std::string& text, bool semicolon) {
  return text + (semicolon ? ";" : "") + checksum(text) + "\n";
}

/// `line` without what closes it; none if its checksum is wrong.
std::optional<std::string> opened(std::string_view line, bool semicolon) {
  const std::size_t closing = semicolon ? 2 : 1;
  if (line.size() < closing) return std::nullopt;
  const std::string_view text = line.substr(0, line.size() - closing);
  if (line.back() != checksum(text) || (semicolon && line[line.size() - 2] != ';')) return std::nullopt;
  return std::string{text};
}

std::optional<Reply> reply_of(const std::vector<std::string>& lines) {
  if (lines.size() < 2) return std::nullopt;
  Reply reply{.echo = lines[0], .status = {}, .data = {}};
  const std::string& status = lines[1];
  if (status.size() == 1) {  // SCIP 1.1: "0" or "E", without checksum
    reply.status = status;
  } else if (const auto text = opened(status, false); text && text->size() == 2) {
    reply.status = *text;
  } else {
    return std::nullopt;
  }
  for (auto line = lines.begin() + 2; line != lines.end(); ++line) {
    auto text = opened(*line, has_semicolons(reply.echo));
    if (!text) return std::nullopt;
    reply.data.push_back(std::move(*text));
  }
  return reply;
}

std::size_t characters_per_range(std::string_view command) {
  return command[1] == 'S' ? 2 : 3;
}
bool has_intensities(std::string_view command) {
  return command[1] == 'E';
}

}  // namespace

std::vector<Reply> ReplyParser::take(std::span<const std::uint8_t> bytes) {
  std::vector<Reply> replies;
  for (std::string& line : reader_.take(bytes)) {
    if (!line.empty()) {
      if (lines_.size() < kMostLines) lines_.push_back(std::move(line));
      continue;
    }
    if (lines_.empty()) continue;  // a second empty line
    if (auto reply = reply_of(lines_)) {
      replies.push_back(std::move(*reply));
    } else {
      ++damaged_;
    }
    lines_.clear();
  }
  return replies;
}

std::string bytes_of(const Reply& reply) {
  std::string bytes = reply.echo + "\n" + closed(reply.status, false);
  for (const std::string& line : reply.data) bytes += closed(line, has_semicolons(reply.echo));
  return bytes + "\n";
}

std::string bytes_of(const ScanData& scan) {
  const std::string& command = scan.request.command;
  const std::size_t width = characters_per_range(command);
  std::string values;
  values.reserve(scan.ranges_mm.size() * width * 2);
  for (std::size_t i = 0; i < scan.ranges_mm.size(); ++i) {
    values += encode_number(scan.ranges_mm[i], width);
    if (has_intensities(command)) values += encode_number(i < scan.intensities.size() ? scan.intensities[i] : 0, width);
  }
  Reply reply{.echo = line_of(scan.request), .status = is_stream(command) ? "99" : "00", .data = {}};
  reply.data.push_back(timestamp_data(scan.timestamp_ms));
  for (std::size_t from = 0; from < values.size(); from += kDataPerLine) {
    reply.data.push_back(values.substr(from, kDataPerLine));
  }
  return bytes_of(reply);
}

std::optional<ScanData> parse_scan(const Reply& reply) {
  const auto request = parse_request(reply.echo);
  if (!request || reply.data.size() < 2) return std::nullopt;
  auto parsed = parse_scan_request(*request);
  auto* echoed = std::get_if<ScanRequest>(&parsed);
  if (echoed == nullptr || reply.status != (is_stream(echoed->command) ? "99" : "00")) return std::nullopt;
  const auto timestamp = reply.data[0].size() == kTimestampCharacters ? decode_number(reply.data[0]) : std::nullopt;
  if (!timestamp) return std::nullopt;

  std::string values;  // one value may be split over two lines: join first
  for (auto line = reply.data.begin() + 1; line != reply.data.end(); ++line) values += *line;
  const std::size_t width = characters_per_range(echoed->command);
  const bool intensities = has_intensities(echoed->command);
  const std::size_t count = value_count(*echoed);
  if (values.size() != count * width * (intensities ? 2 : 1)) return std::nullopt;

  ScanData scan{.request = std::move(*echoed), .timestamp_ms = *timestamp, .ranges_mm = {}, .intensities = {}};
  scan.ranges_mm.reserve(count);
  for (std::size_t from = 0; from < values.size(); from += width) {
    const auto value = decode_number(std::string_view{values}.substr(from, width));
    if (!value) return std::nullopt;
    const bool is_range = !intensities || scan.ranges_mm.size() == scan.intensities.size();
    (is_range ? scan.ranges_mm : scan.intensities).push_back(*value);
  }
  return scan;
}

std::string timestamp_data(std::uint32_t timestamp_ms) {
  return encode_number(timestamp_ms & kTimestampMask, kTimestampCharacters);
}

}  // namespace tandem::scip
