#pragma once

#include <string>

#include "services/common/clock.hpp"

namespace tandem::cli {

/// A progress bar on standard error, shown only on a terminal and only once the work has taken a second.
class Progress {
 public:
  explicit Progress(std::string what);
  /// Wipes the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// `share` of the work is done, in [0, 1]; `note` stands behind the bar. Cheap: draws at most ten times a second.
  void show(double share, const std::string& note = "");

 private:
  std::string what_;
  SteadyClock clock_;
  Time started_;
  Time drawn_;
  bool on_terminal_;
  bool visible_ = false;
};

}  // namespace tandem::cli
