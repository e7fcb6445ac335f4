#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/common/time.hpp"

/// What makes an Event apply exactly once, without DDS: who still owes a receipt, and what was applied already.
namespace tandem::bus {

/// What became of an event that was sent.
struct EventOutcome {
  enum class State { Pending, Applied, Refused, Undelivered };
  State state = State::Pending;
  std::string by;      ///< who refused it, or who has not answered
  std::string reason;  ///< of a refusal
};

/// The sender's side: what was sent, who has answered, what to repeat.
class SentEvents {
 public:
  SentEvents(std::vector<std::string> appliers, Duration repeat_after, Duration give_up_after)
      : appliers_(std::move(appliers)), repeat_after_(repeat_after), give_up_after_(give_up_after) {}

  void sent(const std::string& id, Time now);
  /// A receipt for `id`; false if it belongs to nobody's event here.
  bool answered(const std::string& id, const std::string& by, bool applied, const std::string& reason);
  /// Ids whose event is to be sent again now.
  [[nodiscard]] std::vector<std::string> due(Time now);
  [[nodiscard]] EventOutcome outcome(const std::string& id) const;
  [[nodiscard]] bool is_pending(const std::string& id) const;

 private:
  struct Entry {
    Time first_sent;
    Time last_sent;
    std::set<std::string> owing;
    EventOutcome outcome;
  };
  void forget_old(Time now);

  std::vector<std::string> appliers_;
  Duration repeat_after_;
  Duration give_up_after_;
  std::map<std::string, Entry> entries_;
};

/// The receiver's side: what was seen, and how it was answered.
class AppliedEvents {
 public:
  struct Answer {
    bool applied = false;
    std::string reason;
  };
  /// True the first time `id` is seen.
  bool is_new(const std::string& id);
  void answer(const std::string& id, Answer answer);
  /// The answer given to `id`, to be given again to a repetition.
  [[nodiscard]] std::optional<Answer> answer_to(const std::string& id) const;

 private:
  static constexpr std::size_t kRemembered = 4096;
  std::deque<std::string> order_;
  std::map<std::string, std::optional<Answer>> seen_;
};

}  // namespace tandem::bus
