#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace tandem {

/// Why a scan or an odometry sample was not used as it came.
enum class InputFault {
  ScanWithoutOdometry,    ///< none near its time
  ScanWithTooFewReturns,  ///< NaN, infinite, zero or out of range
  ScanOutOfOrder,         ///< older than the last one used
  ScanStuck,              ///< the same ranges, to the last bit, although the robot moved on
  ScanAllAlike,           ///< every return from the same range
  ScanGeometryChanged,    ///< another number of beams, other angles or another place of the laser than before
  ScanNotFinite,          ///< its angles or the laser's place are not numbers
  OdometryJump,           ///< faster than any robot: the motion is taken as unknown
  OdometryOutOfOrder,     ///< older than the last one; the localizer still puts it in its place
  OdometryNotFinite,      ///< not a number
  TimeWentBack,           ///< by seconds, and stayed there: the past is forgotten
  LaserMirrored,          ///< scans fit the map clearly better when left and right are exchanged
  MapScaleWrong,          ///< scans fit the map clearly better when they are made larger or smaller
};

inline constexpr std::array<const char*, 13> kInputFaultNames{
    "scan_without_odometry", "scan_with_too_few_returns", "scan_out_of_order", "scan_stuck",
    "scan_all_alike",        "scan_geometry_changed",     "scan_not_finite",   "odometry_jump",
    "odometry_out_of_order", "odometry_not_finite",       "time_went_back",    "laser_mirrored",
    "map_scale_wrong"};

/// How often each came.
class InputFaults {
 public:
  void add(InputFault fault) { ++counts_[static_cast<std::size_t>(fault)]; }
  [[nodiscard]] std::uint64_t count(InputFault fault) const { return counts_[static_cast<std::size_t>(fault)]; }
  /// Those that came after `before`, an earlier state of this.
  [[nodiscard]] InputFaults since(const InputFaults& before) const {
    InputFaults result;
    for (std::size_t i = 0; i < counts_.size(); ++i) result.counts_[i] = counts_[i] - before.counts_[i];
    return result;
  }
  /// "scan_stuck 3, odometry_jump 1"; empty if there were none.
  [[nodiscard]] std::string text() const {
    std::string text;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] == 0) continue;
      text += (text.empty() ? "" : ", ") + std::string{kInputFaultNames[i]} + " " + std::to_string(counts_[i]);
    }
    return text;
  }

 private:
  std::array<std::uint64_t, kInputFaultNames.size()> counts_{};
};

}  // namespace tandem
