#include "robot/laser/core/device_clock.hpp"

#include <algorithm>

namespace tandem {
namespace {

constexpr Duration kBucket = from_seconds(1.0);
constexpr std::size_t kBuckets = 30;
constexpr std::size_t kBucketsForDrift = 5;  // a line through less says more about jitter than about drift
constexpr Duration kJump = from_seconds(0.5);

}  // namespace

Time DeviceClock::mission_time(std::uint32_t count, Time received) {
  const Time latest = received - least_delay_;
  Time stamp = latest;
  const Duration elapsed = ((count - last_count_) & format_.most) * format_.tick;
  const bool is_first = !last_received_;
  const bool believed =
      is_first || (elapsed > Duration::zero() && std::chrono::abs((received - *last_received_) - elapsed) < kJump);
  if (believed) {
    if (!is_first) device_time_ += elapsed;
    remember(latest.time_since_epoch() - device_time_);
    stamp = std::min(latest, Time{device_time_ + offset_now()});
  } else {
    offsets_.clear();
  }
  if (!is_first) stamp = std::max(stamp, last_stamp_ + std::chrono::milliseconds{1});
  last_count_ = count;
  last_received_ = received;
  last_stamp_ = stamp;
  return stamp;
}

void DeviceClock::remember(Duration offset) {
  if (offsets_.empty() || device_time_ - offsets_.back().device_time >= kBucket) {
    offsets_.push_back({device_time_, offset});
    if (offsets_.size() > kBuckets) offsets_.pop_front();
  } else {
    offsets_.back().offset = std::min(offsets_.back().offset, offset);
  }
}

Duration DeviceClock::offset_now() const {
  const auto less = [](const LeastOffset& a, const LeastOffset& b) { return a.offset < b.offset; };
  const Duration least = std::min_element(offsets_.begin(), offsets_.end(), less)->offset;
  if (offsets_.size() < kBucketsForDrift) return least;
  // Line by least squares, relative to the first bucket so that doubles keep nanoseconds.
  const LeastOffset& origin = offsets_.front();
  double sum_t = 0.0, sum_o = 0.0, sum_tt = 0.0, sum_to = 0.0;
  for (const LeastOffset& one : offsets_) {
    const double t = to_seconds(one.device_time - origin.device_time);
    const double o = to_seconds(one.offset - origin.offset);
    sum_t += t;
    sum_o += o;
    sum_tt += t * t;
    sum_to += t * o;
  }
  const auto count = static_cast<double>(offsets_.size());
  const double drift = (count * sum_to - sum_t * sum_o) / (count * sum_tt - sum_t * sum_t);
  const double at_origin = (sum_o - drift * sum_t) / count;
  return origin.offset + from_seconds(at_origin + drift * to_seconds(device_time_ - origin.device_time));
}

}  // namespace tandem
