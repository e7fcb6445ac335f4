#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "services/common/time.hpp"

namespace tandem {

/// Which way a relay carries a sample.
enum class Crossing { HostToLink, LinkToHost };

/// The host a relay stands on.
enum class HostRole { Robot, Laptop };

/// What the topic table says of a topic, in the relay's own words.
struct ForwardingRule {
  bool to_laptop = false;
  bool to_robot = false;
  double max_rate_hz = 0.0;  ///< per instance; 0: every sample
  double max_age_s = 0.0;    ///< 0: any age
};

/// True if the relay of a host with `role` carries samples of this topic in direction `crossing`.
[[nodiscard]] bool carries(const ForwardingRule& rule, HostRole role, Crossing crossing);

/// Thins a topic to its rate, each instance for itself, and drops what is too old.
///
/// Time is handed in, and ages are of one host's clock: the age of a sample that crossed the link is corrected by the
/// link's own clock offset before it comes here.
class ForwardingGate {
 public:
  using Key = std::array<std::uint8_t, 16>;
  explicit ForwardingGate(const ForwardingRule& rule) : rule_(rule) {}

  /// True if the sample of instance `key` that is `age_s` [s] old may pass at `now`.
  [[nodiscard]] bool passes(const Key& key, Time now, double age_s);

 private:
  ForwardingRule rule_;
  std::map<Key, Time> next_;  // instances are robots, agents, services: a handful
};

}  // namespace tandem
