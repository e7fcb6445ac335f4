#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace tandem::bus {

/// Who writes each instance of a State, so that an instance whose last writer vanished can be marked. Fast DDS tells of
/// the writer alone: a process that was killed disposes of nothing.
class InstanceWriters {
 public:
  using Key = std::array<std::uint8_t, 16>;
  using Writer = std::array<std::uint8_t, 16>;

  /// A sample of `key` came from `writer`.
  void wrote(const Key& key, const Writer& writer);
  /// The instance was disposed of.
  void ended(const Key& key);
  /// `writer` said that it no longer writes `key`. True if nobody else does.
  bool withdrew(const Key& key, const Writer& writer);
  /// `writer` is out of reach: the instances that now have no writer.
  [[nodiscard]] std::vector<Key> lost(const Writer& writer);
  /// `writer` is back, not started anew: the instances it had when it was lost and nobody wrote since. It does not
  /// repeat what was received before.
  [[nodiscard]] std::vector<Key> back(const Writer& writer);

 private:
  std::map<Key, std::set<Writer>> writers_;
  std::map<Key, Writer> orphans_;  ///< instances without a writer, and the last one they had
};

}  // namespace tandem::bus
