#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tandem::bench {

/// One figure of speed or memory.
struct MicroRecord {
  struct Key {
    std::string measure;  ///< a name of micro_measures()
    std::string family;
    std::uint64_t seed = 0;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  Key key;
  double value = 0.0;
  std::string unit;

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("measure", record.key.measure);
    field("family", record.key.family);
    field("seed", record.key.seed);
    field("value", record.value);
    field("unit", record.unit);
  }
};

struct MicroRequest {
  MicroRecord::Key key;
};

/// What can be measured:
///   evaluations    values of a plan of the whole mission per second of one core as the planner tandem finds them
///                  (RouteValue), legs known
///   objective      the same by SearchObjective
///   rollouts       of the planner tandem per second of one core, in its first plan
///   memory         peak resident memory of a process that prepares the map and plans for 200 ms [MB]
///   reproducible   1 if two searches at a time give what one alone gives, bit for bit, else 0
///   searches       whole searches per minute of one core at 10 ms a plan
[[nodiscard]] std::vector<std::string> micro_measures();

/// Measures it; throws ConfigError on an unknown measure.
[[nodiscard]] MicroRecord measured(const MicroRequest& request);

}  // namespace tandem::bench
