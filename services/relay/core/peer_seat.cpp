#include "services/relay/core/peer_seat.hpp"

namespace tandem {

std::optional<std::string> PeerSeat::rival_of(const std::string& host, Time now) {
  std::erase_if(claims_, [&](const auto& claim) { return now - claim.second.last > kSilence; });
  Claim& own = claims_.try_emplace(host, Claim{now, now}).first->second;
  own.last = now;
  for (const auto& [other, claim] : claims_) {
    if (other != host && claim.last > own.first && now > claim.first) return other;
  }
  return std::nullopt;
}

}  // namespace tandem
