#pragma once

#include <cstddef>
#include <string>

#include "services/common/time.hpp"

namespace tandem::bench {

/// "2026-11-26", in UTC.
[[nodiscard]] std::string date_of(Time time);

/// Processor and number of cores of this machine.
[[nodiscard]] std::string machine();

/// Says on standard error how far a part is: over itself on a terminal, else now and then a line.
class PartProgress {
 public:
  explicit PartProgress(std::string what) : what_(std::move(what)) {}
  void show(const std::string& last, std::size_t left);

 private:
  std::string what_;
  std::size_t done_ = 0;
};

}  // namespace tandem::bench
