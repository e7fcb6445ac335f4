#pragma once

#include <optional>
#include <vector>

#include "services/navigator/core/navigator_config.hpp"
#include "services/navigator/core/path_follower.hpp"
#include "services/navigator/core/swept_path.hpp"

namespace tandem::navigator {

/// What the robot can do next, seen from its base frame.
struct Course {
  enum class Kind { Arc, TurnInPlace, Stand };
  Kind kind = Kind::Stand;
  double curvature = 0.0;  ///< Of an arc [1/m].
  FreeWay free;            ///< Along the arc; of a course that stands, what is in the way of the one it wanted.
  bool detour = false;     ///< Not the arc the path asks for.
  double nearest_m = 0.0;  ///< From the hull to the nearest obstacle.
};

/// Chooses between what the path asks for and a few arcs around what stands in the way (in the manner of the dynamic
/// window approach of Fox, Burgard and Thrun, 1997, over curvatures alone: speed follows from the free way).
///
/// Drives on as the path asks where the path is free. Else along the path, shifted aside; where no shift is free, on
/// the arc that brings it closest to the path behind the obstacle; where it must turn but has no room for that, on the
/// arc that leads to room. Never backwards.
class Avoidance {
 public:
  explicit Avoidance(const NavigatorConfig& config);

  [[nodiscard]] Course course(const Aim& aim, const Path& path, const Pose2& map_from_base,
                              const std::vector<Eigen::Vector2d>& obstacles_in_base);

 private:
  [[nodiscard]] bool path_is_free(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                  const std::vector<Eigen::Vector2d>& obstacles_in_base) const;
  [[nodiscard]] std::optional<Course> aside(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                            const std::vector<Eigen::Vector2d>& obstacles_in_base);
  [[nodiscard]] std::optional<Course> detour(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                             const std::vector<Eigen::Vector2d>& obstacles_in_base) const;
  [[nodiscard]] std::optional<Course> way_to_room(const Aim& aim,
                                                  const std::vector<Eigen::Vector2d>& obstacles_in_base) const;

  NavigatorConfig config_;
  Hull hull_;
  std::vector<double> curvatures_;  ///< tried for a detour
  bool turning_ = false;
  double last_offset_m_ = 0.0;   ///< of the last step aside
  double last_curvature_ = 0.0;  ///< of the last detour, for which there is a small preference
};

}  // namespace tandem::navigator
