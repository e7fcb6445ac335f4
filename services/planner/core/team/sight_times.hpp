#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tandem {

/// Who first shows each cell, and when: the arrays that judging a change of routes reads and, for a while, overwrites.
struct SightTimes {
  std::vector<std::int32_t> first;   ///< per cell, the visit that first shows it
  std::vector<std::int32_t> second;  ///< per cell, another one that would
  std::vector<float> first_s;        ///< per cell, when
  std::vector<float> second_s;       ///< per cell, when; never before first_s

  explicit SightTimes(std::size_t cells) : first(cells), second(cells), first_s(cells), second_s(cells) {}
};

/// What was overwritten, to be put back from the last to the first.
class Overwritten {
 public:
  /// Makes room for so many more; where they go.
  struct Entry {
    std::int32_t cell;
    float first_s;
  };
  [[nodiscard]] Entry* room_for(std::size_t count) {
    if (entries_.size() < count_ + count) entries_.resize(2 * (count_ + count));
    return entries_.data() + count_;
  }
  /// That so many of them were used.
  void add(std::size_t count) { count_ += count; }
  void put_back(std::vector<float>& first_s) {
    while (count_ > 0) {
      const Entry& entry = entries_[--count_];
      first_s[static_cast<std::size_t>(entry.cell)] = entry.first_s;
    }
  }

 private:
  std::vector<Entry> entries_;
  std::size_t count_ = 0;
};

/// The cells that a leg shows, in the order of time, each once.
struct LegCells {
  const std::int32_t* cell;
  const float* enter_s;  ///< from the beginning of the leg
  std::size_t count;
};

/// Puts a leg that begins at `start_s` into `times.first_s`: gives the sum of mass times how much sooner its cells are
/// seen [s]. What it shows at `horizon_s` or later does not count.
[[nodiscard]] float take_sooner(const LegCells& leg, float start_s, float horizon_s, const std::vector<float>& mass,
                                SightTimes& times, Overwritten& overwritten);

/// Takes a visit's leg out of `times.first_s`, so that the second to show its cells is the first: gives the sum of mass
/// times how much later they are seen [s].
[[nodiscard]] float take_later(const LegCells& leg, std::int32_t visit, const std::vector<float>& mass,
                               SightTimes& times, Overwritten& overwritten);

}  // namespace tandem
