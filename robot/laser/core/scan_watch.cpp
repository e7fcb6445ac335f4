#include "robot/laser/core/scan_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tandem {
namespace {

constexpr std::size_t kScansForRate = 20;
constexpr double kSlow = 1.5;  // times the expected period
constexpr int kStuck = 10;     // ranges have noise: so many scans never agree to the millimetre

/// Bit for bit: NaN equals NaN.
bool same(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace

void ScanWatch::add(const LaserReading& reading) {
  stamps_.push_back(reading.first_beam);
  if (stamps_.size() > kScansForRate) stamps_.pop_front();
  identical_ = same(reading.ranges_m, last_ranges_) ? identical_ + 1 : 1;
  last_ranges_ = reading.ranges_m;
  all_blind_ = std::all_of(last_ranges_.begin(), last_ranges_.end(), [](float range) { return std::isnan(range); });
}

std::string ScanWatch::complaint() const {
  if (all_blind_) return "no beam returns: is the laser covered?";
  if (identical_ >= kStuck) return std::to_string(identical_) + " identical scans in a row: the sensor is stuck";
  if (stamps_.size() < kScansForRate) return "";
  const double period_s = to_seconds(stamps_.back() - stamps_.front()) / static_cast<double>(stamps_.size() - 1);
  if (period_s < kSlow * expected_period_s_) return "";
  return "scans come every " + std::to_string(std::lround(period_s * 1e3)) + " ms instead of " +
         std::to_string(std::lround(expected_period_s_ * 1e3));
}

}  // namespace tandem
