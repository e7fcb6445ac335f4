#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace tandem {

/// Which instances of a State were brought in from the link, so that one that ended while the link was away is ended
/// here too.
///
/// Each time the relay joins the link anew begins a round; the other host then sends all that still lives.
class InstanceLedger {
 public:
  using Key = std::array<std::uint8_t, 16>;

  void begin_round() { ++round_; }
  void came(const Key& key) { round_of_[key] = round_; }
  void ended(const Key& key) { round_of_.erase(key); }
  /// All that came, in this round or before, and did not end.
  [[nodiscard]] std::vector<Key> living() const;
  /// Instances that did not come in this round; they are forgotten.
  [[nodiscard]] std::vector<Key> take_missing();

 private:
  int round_ = 0;
  std::map<Key, int> round_of_;
};

}  // namespace tandem
