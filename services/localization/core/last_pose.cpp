#include "services/localization/core/last_pose.hpp"

#include <nlohmann/json.hpp>

#include "services/common/strict_json.hpp"

namespace tandem {
namespace {

constexpr const char* kFormat = "tandem last pose 1";
constexpr Duration kClocksDiffer = std::chrono::seconds{1};

Pose2 pose_of(StrictObject& object, std::string_view key) {
  const std::vector<double> numbers = object.numbers(key, 3);
  return {numbers[0], numbers[1], wrap_to_pi(numbers[2])};
}

LastPose parsed(std::string_view text) {
  const nlohmann::json json = parse_json(text, "last pose");
  StrictObject object{json, "last pose"};
  if (object.text("format") != kFormat) object.fail("format", "is not known");
  LastPose last;
  last.time = from_stamp_ns(object.whole_number_or("stamp_ns", 0, Range{0, 9e18}));
  last.map_sha256 = object.text("map_sha256");
  last.pose.map_from_base = pose_of(object, "map_from_base");
  last.pose.odom_from_base = pose_of(object, "odom_from_base");
  last.pose.odometry_epoch = static_cast<int>(object.whole_number_or("odometry_epoch", -1, Range{-1, 2e9}));
  object.refuse_unknown_keys();
  return last;
}

}  // namespace

std::string to_text(const LastPose& last) {
  const auto numbers = [](const Pose2& pose) { return nlohmann::ordered_json{pose.x, pose.y, pose.heading}; };
  const nlohmann::ordered_json json{{"format", kFormat},
                                    {"stamp_ns", to_stamp_ns(last.time)},
                                    {"map_sha256", last.map_sha256},
                                    {"map_from_base", numbers(last.pose.map_from_base)},
                                    {"odom_from_base", numbers(last.pose.odom_from_base)},
                                    {"odometry_epoch", last.pose.odometry_epoch}};
  return json.dump() + "\n";
}

std::variant<MemoryUse, std::string> memory_of(std::string_view text, const MemoryRule& rule) {
  LastPose last;
  try {
    last = parsed(text);
  } catch (const ConfigError& error) {
    return std::string{error.what()};
  }
  if (last.map_sha256 != rule.map_sha256) return "it belongs to another map";
  const Duration age = rule.now - last.time;
  if (age < -kClocksDiffer) return "it is from the future";
  if (age > rule.max_age) return "it is " + std::to_string(age / std::chrono::seconds{1}) + " s old";
  return MemoryUse{last.pose, age <= rule.fresh ? Memory::Fresh : Memory::Old};
}

}  // namespace tandem
