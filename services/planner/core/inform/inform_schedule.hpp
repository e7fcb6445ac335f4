#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem {

/// Something that could be told to a person (paper 3.4, digest D3).
struct InformOption {
  std::string source_id;  ///< what it is about
  double gain_s = 0.0;    ///< what it gains that they know it
  std::string reason;     ///< the message, for them
};

/// What a message costs, and how often there may be one.
struct InformRules {
  double cost_s = 3.0;    ///< of attention: nothing that gains less is told
  double pause_s = 20.0;  ///< from one message to the next
  double life_s = 30.0;   ///< a message that was not taken notice of for so long is withdrawn
};

/// Decides when a person is told what: one thing at a time, the one that gains most, each until they take notice of it,
/// but no more than kMostTries times.
class InformSchedule {
 public:
  explicit InformSchedule(const InformRules& rules) : rules_(rules) {}

  /// What is to be told now, of all that they do not know; it counts as told.
  [[nodiscard]] std::optional<InformOption> next(const std::vector<InformOption>& options, Time now);
  /// They have taken notice of it. What they do not know of it later is told anew.
  void heard(const std::string& source_id);
  /// There is nothing to be told about it any more.
  void forget(const std::string& source_id);

  static constexpr int kMostTries = 2;

 private:
  struct UnderWay {
    std::string source_id;
    Time told{};
  };

  InformRules rules_;
  std::optional<UnderWay> under_way_;
  std::optional<Time> last_told_;
  std::map<std::string, int> tries_;  ///< of what has not been heard yet
};

}  // namespace tandem
