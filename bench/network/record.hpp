#pragma once

#include <map>
#include <string>

namespace tandem::bench {

/// Names one measurement: what, of whom, over which air, the how-many-eth time.
struct NetworkKey {
  std::string what;   ///< "map300", "message", ...
  std::string whose;  ///< "ours" or "default": Fast DDS as it comes, over UDP alone
  std::string air;    ///< name of conditions_of
  int run = 1;
  auto operator<=>(const NetworkKey&) const = default;

  /// "map300/ours/loss20/1".
  [[nodiscard]] std::string text() const { return what + "/" + whose + "/" + air + "/" + std::to_string(run); }
};

/// The figures of one measurement, by name.
using Figures = std::map<std::string, double>;

/// What stands in for a time that did not end within its patience.
inline constexpr double kNever = 1e9;

/// A line of results.jsonl.
struct NetworkRecord {
  NetworkKey key;
  Figures figures;

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("what", record.key.what);
    field("whose", record.key.whose);
    field("air", record.key.air);
    field("run", record.key.run);
    field("figures", record.figures);
  }
};

}  // namespace tandem::bench
