#include "services/localization/core/trajectory_file.hpp"

#include <array>
#include <charconv>

#include "services/localization/core/number_lines.hpp"

namespace tandem {
namespace {

void append(std::string& line, double value, int decimals) {
  std::array<char, 400> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
  line.append(digits.data(), end);
}

}  // namespace

std::string trajectory_line(const TimedPose& pose) {
  std::string line;
  append(line, to_seconds(pose.time.time_since_epoch()), 6);
  for (const double value : {pose.map_from_base.x, pose.map_from_base.y, pose.map_from_base.heading}) {
    line += ' ';
    append(line, value, 9);
  }
  line += '\n';
  return line;
}

std::string trajectory_text(std::span<const TimedPose> poses) {
  std::string text;
  for (const TimedPose& pose : poses) text += trajectory_line(pose);
  return text;
}

std::vector<TimedPose> parse_trajectory(const std::string& text, const std::string& file_name) {
  std::vector<TimedPose> poses;
  for (const auto& numbers : number_lines(text, 4, file_name)) {
    poses.push_back({Time{from_seconds(numbers[0])}, {numbers[1], numbers[2], wrap_to_pi(numbers[3])}});
  }
  return poses;
}

}  // namespace tandem
