#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "services/cli/plan/svg.hpp"

namespace tandem::cli {

/// Words on a picture that keep out of each other's way.
class Labels {
 public:
  /// Writes `words` above, below, to the right or to the left of a point, `off` from it [px]: the first place that is
  /// free. If none is: above.
  void add(Svg& svg, const Eigen::Vector2d& at, double off, const std::string& words, double font_size,
           const std::string& style);
  /// Writes it to the lower right, or not at all.
  void add_if_free(Svg& svg, const Eigen::Vector2d& at, const std::string& words, double font_size,
                   const std::string& style);

 private:
  struct Place {
    Eigen::Vector2d low;  ///< upper left corner on the picture
    Eigen::Vector2d high;
  };
  [[nodiscard]] bool is_free(const Place& place) const;
  void write(Svg& svg, const Place& place, const std::string& words, double font_size, const std::string& style);

  std::vector<Place> taken_;
};

}  // namespace tandem::cli
