#pragma once

namespace tandem::protocol {

struct Point {
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]

  friend bool operator==(const Point&, const Point&) = default;
};

}  // namespace tandem::protocol
