#include "services/bus/core/rtps_guard.hpp"

#include <algorithm>

namespace tandem::bus {
namespace {

using Kind = RtpsSubmessage::Kind;

/// Endpoints of topics, and those by which secured hosts tell each other of them: never in the clear on a secured link.
bool is_protected(const EntityId& entity) {
  constexpr std::uint8_t kOrigin = 0xc0;  // of the kind: user, vendor or built in
  const bool of_a_topic = (entity[3] & kOrigin) == 0;
  const bool of_security = entity[0] == 0xff && (entity[3] & kOrigin) == kOrigin;
  return of_a_topic || of_security;
}

/// Whether the numbers make sense by themselves.
bool are_possible(const RtpsSubmessage& said) {
  const std::int64_t least = said.kind == Kind::Answer ? 0 : 1;  // a reader that knows nothing has everything before 0
  if (said.first < least || said.first > RtpsGuard::kMostNumber || said.last > RtpsGuard::kMostNumber) return false;
  return said.last >= said.first - 1;
}

EndpointId endpoint_of(const ParticipantId& participant, const EntityId& entity) {
  EndpointId id{};
  std::copy(participant.begin(), participant.end(), id.begin());
  std::copy(entity.begin(), entity.end(), id.begin() + static_cast<std::ptrdiff_t>(participant.size()));
  return id;
}

}  // namespace

std::string_view text_of(RtpsFault fault) {
  switch (fault) {
    case RtpsFault::NoMessage:
      return "no RTPS message, or a broken one";
    case RtpsFault::Numbers:
      return "sequence numbers that no peer can have come to";
    case RtpsFault::Unprotected:
      return "not encrypted, on a secured link";
  }
  return "";
}

std::optional<RtpsFault> RtpsGuard::fault_of(std::span<const std::uint8_t> datagram, Time now) {
  const auto submessages = submessages_of(datagram);
  if (!submessages) return RtpsFault::NoMessage;
  for (const auto& said : *submessages) {
    if (secured_ && is_protected(said.writer)) return RtpsFault::Unprotected;
    if (!are_possible(said) || (said.kind != Kind::Gap && !is_in_order(said, now))) return RtpsFault::Numbers;
  }
  // The heartbeat that says how far the writer has come often stands behind its gap.
  for (const auto& said : *submessages) {
    if (said.kind == Kind::Gap && !is_within_what_was_said(said)) return RtpsFault::Numbers;
  }
  return std::nullopt;
}

bool RtpsGuard::is_within_what_was_said(const RtpsSubmessage& gap) const {
  const auto writer = accounts_.find({endpoint_of(gap.source, gap.writer), {}});
  const std::int64_t highest = writer == accounts_.end() ? 0 : writer->second.highest;
  return gap.last - gap.first < kMostGap && gap.last <= highest + kJump;
}

bool RtpsGuard::is_in_order(const RtpsSubmessage& said, Time now) {
  if (said.kind != Kind::Answer) return follows({endpoint_of(said.source, said.writer), {}}, said.last, now);
  // A reader has an account with each writer that it answers.
  return said.first == 0 || follows({endpoint_of(said.source, said.reader), said.writer}, said.first, now);
}

bool RtpsGuard::follows(const AccountId& id, std::int64_t number, Time now) {
  if (accounts_.size() >= kMostAccounts && !accounts_.contains(id)) accounts_.clear();
  const auto [entry, is_new] = accounts_.try_emplace(id);
  Account& account = entry->second;
  if (!is_new && number > account.highest + kJump) {
    const bool is_said_again = account.ahead != 0 && number >= account.ahead && number <= account.ahead + kJump;
    if (!is_said_again) {
      account.ahead = number;
      account.ahead_since = now;
    }
    if (!is_said_again || now - account.ahead_since < kAgain) return false;
  }
  if (number > account.highest) account = {number};
  return true;
}

}  // namespace tandem::bus
