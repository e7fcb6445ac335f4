#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "services/bus/core/rtps_message.hpp"
#include "services/common/time.hpp"

namespace tandem::bus {

/// Why a datagram must not reach Fast DDS.
enum class RtpsFault {
  NoMessage,    ///< no RTPS, cut short, or with lengths that do not fit
  Numbers,      ///< sequence numbers that no peer of ours can have come to
  Unprotected,  ///< said in the clear on a secured link, where hosts encrypt it
};

/// "no RTPS message": for log and service_health.
[[nodiscard]] std::string_view text_of(RtpsFault fault);

/// Judges each datagram that comes to a participant of the link, before Fast DDS 2.9 sees it.
///
/// What Fast DDS cannot bear is forged easily: it goes through a gap number by number with the reader locked, after a
/// sample far ahead it takes nothing below that number, and on a secured link it takes whatever has no payload from
/// anybody. All that participants of a link send each other passes
/// (docs/decisions/0011-datagrams-are-judged-before-fast-dds.md).
class RtpsGuard {
 public:
  /// The highest sequence number: at 50 samples a second a link takes half a year to it.
  static constexpr std::int64_t kMostNumber = 1'000'000'000;
  /// The longest gap. A State of which one instance stays as it is while others change leaves gaps, in days.
  static constexpr std::int64_t kMostGap = 10'000'000;
  /// A number further than this ahead of all that was said before counts only when it is said again,
  static constexpr std::int64_t kJump = 1'000;
  /// and later than this: a forged datagram may go to several ports at once.
  static constexpr Duration kAgain = std::chrono::milliseconds{20};
  /// Writers and readers that are remembered. An attacker can make up as many as it likes.
  static constexpr std::size_t kMostAccounts = 4'096;

  explicit RtpsGuard(bool secured) : secured_(secured) {}

  /// What is wrong with a datagram that came at `now`; nothing if it may pass.
  [[nodiscard]] std::optional<RtpsFault> fault_of(std::span<const std::uint8_t> datagram, Time now);
  /// Writers and readers that are remembered now.
  [[nodiscard]] std::size_t accounts() const { return accounts_.size(); }

 private:
  /// How far the numbers of a writer have come, or the answers of a reader to it.
  struct Account {
    std::int64_t highest = 0;
    std::int64_t ahead = 0;  ///< a jump that was not believed yet; 0 if there is none
    Time ahead_since{};
  };
  using AccountId = std::pair<EndpointId, EntityId>;

  [[nodiscard]] bool is_in_order(const RtpsSubmessage& said, Time now);
  /// A gap does not say how far its writer has come; samples and heartbeats do.
  [[nodiscard]] bool is_within_what_was_said(const RtpsSubmessage& gap) const;
  /// Whether `number` may come next in an account, which then has come to it.
  [[nodiscard]] bool follows(const AccountId& id, std::int64_t number, Time now);

  bool secured_;
  std::map<AccountId, Account> accounts_;
};

}  // namespace tandem::bus
