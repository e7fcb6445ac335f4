#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "robot/laser/core/scip.hpp"

namespace tandem {

inline std::span<const std::uint8_t> bytes_in(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// A sensor that behaves, but for what a test tells it: answers by the command's two letters, and scans when asked to.
class FakeSensor {
 public:
  scip::SensorParameters parameters = scip::utm_30lx();
  std::map<std::string, std::string> status = {};  ///< Status instead of 00, by command: {"BM", "01"}.
  std::map<std::string, int> deaf = {};            ///< So many requests of a command are not heard.
  bool in_time_adjust = false;                     ///< QT gives 0E until TM2.
  std::string state = "Sensor works well.";        ///< As II tells it.
  std::string heard;                               ///< Commands in order, "QT RS VV ...".

  /// The answer to `request` bytes.
  std::string answer(std::string_view request) {
    std::string bytes;
    for (const std::string& line : reader_.take(bytes_in(request))) {
      if (const auto parsed = scip::parse_request(line)) bytes += answer_to(*parsed);
    }
    return bytes;
  }
  /// The next scan of the stream, all beams at `range_mm`; nothing when none was asked for.
  [[nodiscard]] std::string scan(std::uint32_t timestamp_ms, std::uint32_t range_mm) const {
    if (!stream_) return "";
    scip::ScanData data{.request = *stream_, .timestamp_ms = timestamp_ms};
    data.ranges_mm.assign(scip::value_count(*stream_), range_mm);
    return scip::bytes_of(data);
  }
  [[nodiscard]] bool streams() const { return stream_.has_value(); }
  void stream(const scip::ScanRequest& request) { stream_ = request; }

 private:
  std::string answer_to(const scip::Request& request) {
    heard += (heard.empty() ? "" : " ") + request.command;
    if (deaf[request.command]-- > 0) return "";
    scip::Reply reply{.echo = request.line, .status = "00", .data = {}};
    if (const auto told = status.find(request.command); told != status.end()) reply.status = told->second;
    if (request.command == "TM") in_time_adjust = false;
    if (request.command == "QT" && in_time_adjust) reply.status = "0E";
    if (request.command == "QT" || request.command == "RS") stream_.reset();
    if (request.command == "VV") reply.data = {"VEND:Fake", "PROD:" + parameters.model, "FIRM:1.0", "SERI:H1"};
    if (request.command == "PP") reply.data = scip::parameter_lines(parameters);
    if (request.command == "II") reply.data = {"MODL:" + parameters.model, "STAT:" + state};
    if (scip::is_stream(request.command)) {
      const auto parsed = scip::parse_scan_request(request, parameters);
      if (const auto* refusal = std::get_if<std::string>(&parsed)) {
        reply.status = *refusal;
      } else if (reply.status == "00") {
        stream_ = std::get<scip::ScanRequest>(parsed);
      }
    }
    return scip::bytes_of(reply);
  }

  scip::LineReader reader_{true};
  std::optional<scip::ScanRequest> stream_;
};

}  // namespace tandem
