#include "bench/planning/loop/walked.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tandem::bench {

using Eigen::Vector2d;

TimedPath cut(const TimedPath& path, double from_s, double to_s) {
  assert(!path.points.empty() && to_s >= from_s);
  TimedPath piece;
  piece.points.push_back({0.0, pose_at(path, from_s).position()});
  for (const TimedPoint& point : path.points) {
    if (point.time_s > from_s && point.time_s < to_s)
      piece.points.push_back({point.time_s - from_s, point.point_in_map});
  }
  if (to_s > from_s) piece.points.push_back({to_s - from_s, pose_at(path, to_s).position()});
  return piece;
}

Pose2 pose_after(const TimedPath& walked, const Pose2& before) {
  if (walked.points.empty()) return before;
  const Vector2d end = walked.points.back().point_in_map;
  double heading_rad = before.heading;
  for (std::size_t i = walked.points.size(); i-- > 1;) {
    if ((walked.points[i].point_in_map - walked.points[i - 1].point_in_map).norm() < 1e-9) continue;
    heading_rad = heading_towards(walked.points[i - 1].point_in_map, walked.points[i].point_in_map);
    break;
  }
  return {end.x(), end.y(), heading_rad};
}

void append(Walked& walked, const TimedPath& piece) {
  const double begin_s = walked.path.duration_s();
  for (std::size_t i = walked.path.points.empty() ? 0 : 1; i < piece.points.size(); ++i) {
    walked.path.points.push_back({begin_s + piece.points[i].time_s, piece.points[i].point_in_map});
  }
}

void take_off_seen(std::vector<double>& mass, const Sightings& seen, double rate_per_s, double end_s) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double duration_s = std::min(seen.leave_s[i], end_s) - seen.enter_s[i];
    double& here = mass[static_cast<std::size_t>(seen.cells[i])];
    if (std::isinf(rate_per_s)) {
      if (seen.enter_s[i] < end_s) here = 0.0;
    } else if (duration_s > 0.0) {
      here *= std::exp(-rate_per_s * duration_s);
    }
  }
}

double length_m(const TimedPath& path) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum_m += (path.points[i].point_in_map - path.points[i - 1].point_in_map).norm();
  }
  return sum_m;
}

double frechet_distance_m(const TimedPath& a, const TimedPath& b, double duration_s, double step_s) {
  const auto samples = static_cast<std::size_t>(std::floor(duration_s / step_s)) + 1;
  std::vector<Vector2d> of_b;
  for (std::size_t j = 0; j < samples; ++j) of_b.push_back(pose_at(b, static_cast<double>(j) * step_s).position());
  std::vector<double> row(samples, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < samples; ++i) {
    const Vector2d here = pose_at(a, static_cast<double>(i) * step_s).position();
    double diagonal = i == 0 ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < samples; ++j) {
      const double before = j == 0 ? row[0] : std::min(row[j], row[j - 1]);
      const double reached = i == 0 && j == 0 ? 0.0 : std::min(before, diagonal);
      diagonal = row[j];
      row[j] = std::max(reached, (here - of_b[j]).norm());
    }
  }
  return row.back();
}

}  // namespace tandem::bench
