#include "services/localization/core/trajectory_errors.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "services/localization/core/number_lines.hpp"

namespace tandem {
namespace {

constexpr double kLostM = 1.0;
constexpr double kWrongM = 0.5;
constexpr double kWrongDeg = 10.0;

bool is_within(const TimeWindows& windows, double time_s) {
  return std::any_of(windows.begin(), windows.end(),
                     [time_s](const auto& window) { return time_s >= window.first && time_s <= window.second; });
}

std::pair<double, double> mean_and_deviation(std::span<const double> values) {
  if (values.empty()) return {};
  double mean = 0.0;
  double square = 0.0;
  for (const double value : values) {
    mean += value / static_cast<double>(values.size());
    square += value * value / static_cast<double>(values.size());
  }
  return {mean, std::sqrt(std::max(0.0, square - mean * mean))};
}

double root_of_mean(double sum, std::size_t count) {
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

}  // namespace

std::optional<Pose2> pose_at(std::span<const TimedPose> poses, Time time) {
  const auto after = std::lower_bound(poses.begin(), poses.end(), time,
                                      [](const TimedPose& pose, Time wanted) { return pose.time < wanted; });
  if (after == poses.end()) return std::nullopt;
  if (after->time == time) return after->map_from_base;
  if (after == poses.begin()) return std::nullopt;
  const TimedPose& before = *std::prev(after);
  const double share = to_seconds(time - before.time) / to_seconds(after->time - before.time);
  return interpolate(before.map_from_base, after->map_from_base, share);
}

TrajectoryErrors errors_of(std::span<const EstimatedPose> estimates, std::span<const TimedPose> truth,
                           double truth_offset_s, const TimeWindows& excluded) {
  TrajectoryErrors errors;
  std::vector<double> distances;
  double square_m = 0.0;
  double square_deg = 0.0;
  double square_kept = 0.0;
  double normalised = 0.0;
  std::size_t kept = 0;
  std::size_t lost = 0;
  std::size_t wrong = 0;
  for (const EstimatedPose& estimate : estimates) {
    const auto reference = pose_at(truth, estimate.pose.time + from_seconds(truth_offset_s));
    if (!reference) continue;
    const Eigen::Vector2d offset = estimate.pose.map_from_base.position() - reference->position();
    const double turn = turn_between(reference->heading, estimate.pose.map_from_base.heading);
    const double distance = offset.norm();
    const double degrees = std::abs(to_degrees(turn));
    distances.push_back(distance);
    square_m += distance * distance;
    square_deg += degrees * degrees;
    if (!is_within(excluded, to_seconds(estimate.pose.time.time_since_epoch()))) {
      square_kept += distance * distance;
      ++kept;
    }
    if (distance > kLostM) ++lost;
    const bool is_right = distance <= kWrongM && degrees <= kWrongDeg;
    if (is_right != (estimate.status == LocalizationStatus::Ok)) ++wrong;
    const Eigen::Vector3d error{offset.x(), offset.y(), turn};
    normalised += error.dot(estimate.covariance.inverse() * error) / 3.0;
  }
  errors.compared = distances.size();
  if (distances.empty()) return errors;
  const auto count = static_cast<double>(distances.size());
  std::sort(distances.begin(), distances.end());
  errors.rmse_m = root_of_mean(square_m, distances.size());
  errors.rmse_deg = root_of_mean(square_deg, distances.size());
  errors.rmse_kept_m = root_of_mean(square_kept, kept);
  errors.median_m = distances[distances.size() / 2];
  errors.max_m = distances.back();
  errors.lost_share = static_cast<double>(lost) / count;
  errors.nees = normalised / count;
  errors.status_wrong_share = static_cast<double>(wrong) / count;
  return errors;
}

std::vector<Relation> parse_relations(const std::string& text, const std::string& file_name) {
  std::vector<Relation> relations;
  for (const auto& numbers : number_lines(text, 8, file_name)) {
    relations.push_back({Time{from_seconds(numbers[0])},
                         Time{from_seconds(numbers[1])},
                         {numbers[2], numbers[3], wrap_to_pi(numbers[7])}});
  }
  return relations;
}

RelationErrors relation_errors_of(std::span<const TimedPose> estimates, std::span<const Relation> relations,
                                  double truth_offset_s) {
  std::vector<double> metres;
  std::vector<double> degrees;
  for (const Relation& relation : relations) {
    const auto from = pose_at(estimates, relation.from - from_seconds(truth_offset_s));
    const auto to = pose_at(estimates, relation.to - from_seconds(truth_offset_s));
    if (!from || !to) continue;
    const Pose2 error = inverse(relation.from_pose_to_pose) * (inverse(*from) * *to);
    metres.push_back(error.position().norm());
    degrees.push_back(std::abs(to_degrees(error.heading)));
  }
  RelationErrors errors{.compared = metres.size()};
  std::tie(errors.mean_m, errors.deviation_m) = mean_and_deviation(metres);
  std::tie(errors.mean_deg, errors.deviation_deg) = mean_and_deviation(degrees);
  return errors;
}

FormErrors form_errors_of(std::span<const TimedPose> estimates, std::span<const TimedPose> truth,
                          double truth_offset_s) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d true_middle = Eigen::Vector2d::Zero();
  for (const TimedPose& estimate : estimates) {
    const auto there = pose_at(truth, estimate.time + from_seconds(truth_offset_s));
    if (!there) continue;
    pairs.emplace_back(estimate.map_from_base.position(), there->position());
    middle += pairs.back().first;
    true_middle += pairs.back().second;
  }
  FormErrors errors{.compared = pairs.size()};
  if (pairs.empty()) return errors;
  middle /= static_cast<double>(pairs.size());
  true_middle /= static_cast<double>(pairs.size());
  double along = 0.0;
  double across = 0.0;
  for (const auto& [point, true_point] : pairs) {
    const Eigen::Vector2d a = point - middle;
    const Eigen::Vector2d b = true_point - true_middle;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
  }
  const Pose2 turn{0.0, 0.0, std::atan2(across, along)};
  const Eigen::Vector2d origin = true_middle - turn * middle;
  errors.truth_from_map = {origin.x(), origin.y(), turn.heading};
  double square = 0.0;
  for (const auto& [point, true_point] : pairs) {
    const double distance = (errors.truth_from_map * point - true_point).norm();
    square += distance * distance;
    errors.max_m = std::max(errors.max_m, distance);
  }
  errors.rmse_m = root_of_mean(square, pairs.size());
  return errors;
}

}  // namespace tandem
