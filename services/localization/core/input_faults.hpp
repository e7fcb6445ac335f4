#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tandem {

/// Why a scan or an odometry sample was not used as it came.
enum class InputFault {
  ScanWithoutOdometry,    ///< none near its time
  ScanWithTooFewReturns,  ///< NaN, infinite, zero or out of range
  ScanOutOfOrder,         ///< older than the last one used
  ScanStuck,              ///< the same ranges, to the last bit, although the robot moved on
  OdometryJump,           ///< faster than any robot: the motion is taken as unknown
  OdometryOutOfOrder,     ///< much older than the last one
};

inline constexpr std::array<const char*, 6> kInputFaultNames{"scan_without_odometry", "scan_with_too_few_returns",
                                                             "scan_out_of_order",     "scan_stuck",
                                                             "odometry_jump",         "odometry_out_of_order"};

/// How often each came.
class InputFaults {
 public:
  void add(InputFault fault) { ++counts_[static_cast<std::size_t>(fault)]; }
  [[nodiscard]] std::uint64_t count(InputFault fault) const { return counts_[static_cast<std::size_t>(fault)]; }

 private:
  std::array<std::uint64_t, kInputFaultNames.size()> counts_{};
};

}  // namespace tandem
