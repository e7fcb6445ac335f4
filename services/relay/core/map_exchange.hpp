#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem {

/// What a host says of the map that it has: the hash, empty if it asks for one.
struct HeldMap {
  std::string host;
  std::string sha256;
};

/// Decides which map crosses the link: to a host that has none, and never one that is there already. Maps go by the
/// hash of their cells.
///
/// A host with a map server keeps its own map, whatever others have.
class MapExchange {
 public:
  /// Hosts whose maps differ for longer have not just been given a new one.
  static constexpr Duration kMostDifference = std::chrono::seconds{5};

  /// A host that has no map `patience` after `start` asks for one: its map server may still be loading.
  MapExchange(Time start, Duration patience) : asks_from_(start + patience) {}

  /// This host's map server published a map.
  void own_is(const std::string& sha256) {
    own_ = sha256;
    brought_.clear();
  }
  /// A map came over the link and was published here.
  void brought_is(const std::string& sha256) { brought_ = sha256; }

  /// What this host says that it has: a hash, or empty when it asks for a map; nothing before that is known.
  [[nodiscard]] std::optional<std::string> holding(Time now) const;
  /// True if this host's own map is to be sent, by what the others say that they have.
  [[nodiscard]] bool is_asked_for(const std::vector<HeldMap>& others) const;
  /// A host that has had another map than this one for too long; none if there is no such host.
  [[nodiscard]] std::optional<HeldMap> other_map(const std::vector<HeldMap>& others, Time now);
  /// True if a map that came over the link is to be published here.
  [[nodiscard]] bool is_welcome(const std::string& sha256) const { return own_.empty() && sha256 != brought_; }

 private:
  Time asks_from_;
  std::string own_;
  std::string brought_;
  std::optional<Time> differs_since_;
};

}  // namespace tandem
