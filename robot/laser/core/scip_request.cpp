#include "robot/laser/core/scip_request.hpp"

#include <algorithm>
#include <array>

#include "robot/laser/core/scip_encoding.hpp"

namespace tandem::scip {
namespace {

constexpr std::string_view kLeaveVersion1 = "SCIP2.0";
constexpr std::array<std::string_view, 3> kStreams{"MD", "MS", "ME"};
constexpr std::array<std::string_view, 3> kSingles{"GD", "GS", "GE"};
constexpr std::size_t kStreamDigits = 4 + 4 + 2 + 1 + 2;
constexpr std::size_t kSingleDigits = 4 + 4 + 2;

}  // namespace

std::vector<std::string> LineReader::take(std::span<const std::uint8_t> bytes) {
  std::vector<std::string> lines;
  for (const std::uint8_t byte : bytes) {
    const bool was_carriage_return = after_carriage_return_;
    after_carriage_return_ = carriage_return_ends_ && byte == '\r';
    if (byte == '\n' && was_carriage_return) continue;  // CR LF is one end
    if (byte == '\n' || after_carriage_return_) {
      lines.push_back(std::move(line_));
      line_.clear();
    } else if (line_.size() < kMostCharacters) {
      line_.push_back(static_cast<char>(byte));
    }
  }
  return lines;
}

std::optional<Request> parse_request(const std::string& line) {
  if (line.size() < 2) return std::nullopt;
  Request request{.line = line, .command = {}, .parameters = {}, .tag = {}};
  const auto semicolon = line.find(';');
  const std::string body = line.substr(0, semicolon);
  if (semicolon != std::string::npos) request.tag = line.substr(semicolon + 1);
  const std::size_t length = body == kLeaveVersion1 ? body.size() : std::min<std::size_t>(2, body.size());
  request.command = body.substr(0, length);
  request.parameters = body.substr(length);
  return request;
}

std::string line_of(const ScanRequest& request) {
  std::string line =
      request.command + decimal(request.first_step, 4) + decimal(request.last_step, 4) + decimal(request.cluster, 2);
  if (is_stream(request.command)) line += decimal(request.skip, 1) + decimal(request.count, 2);
  if (!request.tag.empty()) line += ";" + request.tag;
  return line;
}

std::variant<ScanRequest, std::string> parse_scan_request(const Request& request) {
  const bool stream = is_stream(request.command);
  if (!stream && !is_single(request.command)) return "0E";
  const std::string& digits = request.parameters;
  const std::size_t expected = stream ? kStreamDigits : kSingleDigits;
  if (digits.size() < expected) return "0C";
  if (digits.size() > expected) return "0D";
  const auto number = [&digits](std::size_t from, std::size_t count) {
    return parse_decimal(std::string_view{digits}.substr(from, count));
  };
  const auto first_step = number(0, 4);
  if (!first_step) return "01";
  const auto last_step = number(4, 4);
  if (!last_step) return "02";
  const auto cluster = number(8, 2);
  if (!cluster) return "03";
  if (*last_step < *first_step) return "05";
  const auto skip = stream ? number(10, 1) : 0;
  if (!skip) return "06";
  const auto count = stream ? number(11, 2) : 1;
  if (!count) return "07";
  return ScanRequest{request.command, *first_step, *last_step, *cluster, *skip, *count, request.tag};
}

std::variant<ScanRequest, std::string> parse_scan_request(const Request& request, const SensorParameters& sensor) {
  auto parsed = parse_scan_request(request);
  if (const auto* scan = std::get_if<ScanRequest>(&parsed)) {
    if (scan->first_step < sensor.first_step || scan->last_step > sensor.last_step) return "04";
  }
  return parsed;
}

bool is_stream(std::string_view command) {
  return std::find(kStreams.begin(), kStreams.end(), command) != kStreams.end();
}

bool is_single(std::string_view command) {
  return std::find(kSingles.begin(), kSingles.end(), command) != kSingles.end();
}

int steps_per_value(const ScanRequest& request) {
  return std::max(1, request.cluster);
}

std::size_t value_count(const ScanRequest& request) {
  return static_cast<std::size_t>((request.last_step - request.first_step) / steps_per_value(request)) + 1;
}

}  // namespace tandem::scip
