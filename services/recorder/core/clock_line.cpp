#include "services/recorder/core/clock_line.hpp"

#include <algorithm>
#include <cassert>
#include <map>

namespace tandem::recorder {
namespace {

constexpr std::uint64_t kWindow_ns = 60'000'000'000;

double median(std::vector<OffsetSample>& window) {
  const auto middle = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
  std::nth_element(window.begin(), middle, window.end(),
                   [](const OffsetSample& a, const OffsetSample& b) { return a.offset_s < b.offset_s; });
  return middle->offset_s;
}

}  // namespace

ClockLine::ClockLine(std::vector<OffsetSample> samples) {
  assert(!samples.empty());
  std::map<std::uint64_t, std::vector<OffsetSample>> windows;
  for (const OffsetSample& sample : samples) windows[sample.time_ns / kWindow_ns].push_back(sample);
  for (auto& [number, window] : windows) {
    const auto [first, last] =
        std::minmax_element(window.begin(), window.end(),
                            [](const OffsetSample& a, const OffsetSample& b) { return a.time_ns < b.time_ns; });
    const std::uint64_t centre = first->time_ns + (last->time_ns - first->time_ns) / 2;
    knots_.push_back({centre, median(window)});
  }
}

double ClockLine::offset_s_at(std::uint64_t time_ns) const {
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), time_ns,
                                      [](std::uint64_t time, const OffsetSample& knot) { return time < knot.time_ns; });
  if (after == knots_.begin()) return knots_.front().offset_s;
  if (after == knots_.end()) return knots_.back().offset_s;
  const OffsetSample& before = *std::prev(after);
  const double share =
      static_cast<double>(time_ns - before.time_ns) / static_cast<double>(after->time_ns - before.time_ns);
  return before.offset_s + share * (after->offset_s - before.offset_s);
}

}  // namespace tandem::recorder
